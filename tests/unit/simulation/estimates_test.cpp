// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/reference/hertz.hpp"
#include "brinell/simulation/estimates.hpp"

#include <gtest/gtest.h>

namespace brinell::simulation::estimates_test
{
namespace
{

constexpr double modulus = 1.1e11, pressure = 2e9; // [Pa]

TEST(Estimates, LoadHasThePeakPressureOfHertz)
{
  const Shape ball = Paraboloid{2e-3, 2e-3}, barrel = Paraboloid{2e-3, 8e-3}, roller = Roller{2e-3, 5e-3},
              flat = Plane{};
  const auto load = [&](const Shape& upper)
  { return load_of_peak_pressure(flat, upper, Domain{}, modulus, pressure).value(); };
  EXPECT_NEAR(reference::point_contact_at_load(2e-3, modulus, load(ball)).peak_pressure, pressure, 1e-9 * pressure);
  EXPECT_NEAR(reference::elliptical_contact_at_load(2e-3, 8e-3, modulus, load(barrel)).peak_pressure, pressure,
              1e-9 * pressure);
  EXPECT_NEAR(reference::line_contact_at_load(2e-3, modulus, load(roller) / 5e-3).peak_pressure, pressure,
              1e-9 * pressure);
}

TEST(Estimates, NoLoadHasAPeakPressureOfHertzWithoutACurvature)
{
  const Shape flat = Plane{}, cone = Cone{1.2, 0.0};
  EXPECT_FALSE(load_of_peak_pressure(flat, flat, Domain{}, modulus, pressure));
  EXPECT_FALSE(load_of_peak_pressure(flat, cone, Domain{}, modulus, pressure));
}

} // namespace
} // namespace brinell::simulation::estimates_test
