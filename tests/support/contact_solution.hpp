// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/contact/elastic_contact.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

/// Elastic contacts, and what every solution of one has to be.
namespace brinell::test
{

struct ContactSolution
{
  contact::Report report;
  std::vector<double> pressure, gap;

  [[nodiscard]] double load(const SurfaceGrid& grid) const
  {
    return std::accumulate(pressure.begin(), pressure.end(), 0.0) * grid.cell_area();
  }
  [[nodiscard]] std::ptrdiff_t cells_in_contact() const
  {
    return std::count_if(pressure.begin(), pressure.end(), [](double p) { return p > 0.0; });
  }
};

/// @param guess  of the pressure; empty: none
[[nodiscard]] inline ContactSolution solved(const halfspace::SurfaceCompliance& compliance,
                                            const std::vector<double>& distance, const contact::Drive& drive,
                                            double tolerance, int max_iterations = 2000, std::vector<double> guess = {})
{
  contact::ElasticContact contact(compliance);
  guess.resize(distance.size(), 0.0);
  ContactSolution s{{}, std::move(guess), std::vector<double>(distance.size())};
  s.report = contact.solve(distance, drive, tolerance, max_iterations, s.pressure, s.gap);
  return s;
}

/// No tension, no overlap, and no pressure where there is a gap.
inline void expect_complementary(const ContactSolution& s, double tolerance)
{
  EXPECT_TRUE(s.report.converged);
  for (std::size_t i = 0; i < s.gap.size(); ++i)
  {
    ASSERT_GE(s.pressure[i], 0.0);
    ASSERT_GE(s.gap[i], -tolerance);
    ASSERT_TRUE(s.pressure[i] == 0.0 || std::abs(s.gap[i]) <= tolerance) << s.gap[i];
  }
}

} // namespace brinell::test
