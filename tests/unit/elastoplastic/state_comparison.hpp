// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/elastoplastic/body.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

namespace brinell::elastoplastic
{

inline std::vector<double> copy(std::span<const double> s)
{
  return {s.begin(), s.end()};
}

inline double largest(const std::vector<double>& v)
{
  double m = 0.0;
  for (const double x : v)
    m = std::max(m, std::abs(x));
  return m;
}

inline void expect_near(const std::vector<double>& a, const std::vector<double>& b, double relative, const char* what)
{
  ASSERT_EQ(a.size(), b.size()) << what;
  double difference = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
    difference = std::max(difference, std::abs(a[i] - b[i]));
  EXPECT_LE(difference, relative * largest(b)) << what;
}

inline void expect_same_state(const BodyState& a, const BodyState& b, double relative)
{
  expect_near(a.plastic_strain, b.plastic_strain, relative, "plastic strain");
  expect_near(a.equivalent, b.equivalent, relative, "equivalent plastic strain");
  expect_near(a.residual_displacement, b.residual_displacement, relative, "residual displacement");
  EXPECT_NEAR(a.dissipation, b.dissipation, relative * b.dissipation);
  EXPECT_NEAR(a.locked_in_energy, b.locked_in_energy, relative * b.locked_in_energy);
}

} // namespace brinell::elastoplastic
