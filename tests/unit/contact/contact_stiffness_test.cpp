// SPDX-License-Identifier: BSD-3-Clause
// The elastic stiffness of a contact, and mean gaps that are imposed.
#include "brinell/contact/contact_stiffness.hpp"

#include "brinell/foundation/error.hpp"
#include "contact_solution.hpp"
#include "grid_fields.hpp"
#include "order.hpp"
#include "random_field.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

namespace brinell::contact::contact_stiffness_test
{
namespace
{

constexpr double pi = std::numbers::pi;

using Solution = test::ContactSolution;
using test::mean;

Solution converged(const halfspace::SurfaceCompliance& compliance, const std::vector<double>& distance,
                   const Drive& drive, double tolerance)
{
  Solution s = test::solved(compliance, distance, drive, tolerance);
  EXPECT_TRUE(s.report.converged);
  return s;
}

SurfaceGrid square(int n, double length, Boundary boundary)
{
  return {n, n, length / n, length / n, boundary, boundary};
}

/// Waves of a few lengths, of height 1 or so.
std::vector<double> rough(const SurfaceGrid& g)
{
  std::vector<double> distance(g.size());
  std::mt19937_64 generator(3);
  for (int m = 0; m < 5; ++m)
    for (int n = 0; n < 5; ++n)
    {
      const double phase_x = test::uniform(generator, 0.0, 2.0 * pi), phase_y = test::uniform(generator, 0.0, 2.0 * pi);
      for (int j = 0; j < g.ny; ++j)
        for (int i = 0; i < g.nx; ++i)
          distance[g.index(i, j)] += std::cos(2.0 * pi * m * i / g.nx + phase_x) *
                                     std::cos(2.0 * pi * n * j / g.ny + phase_y) / (1.0 + m * m + n * n);
    }
  return distance;
}

TEST(ContactStiffness, IsTheSlopeOfTheLoadWhileNoCellChanges)
{
  // Pressure vanishes at the edge, so that cells that join or leave do not count to first order; between two loads so close that
  // none does, the load is linear in the approach, and the slope is the stiffness but for the tolerances.
  const SurfaceGrid g = square(40, 2.0, Boundary::periodic);
  const halfspace::SurfaceCompliance compliance(g, 3.0);
  const std::vector<double> distance = rough(g);
  for (const double share : {0.05, 0.5, 1.0, 2.0})
  {
    const double load = share * 3.0 * 4.0;
    constexpr double change = 1e-5;
    const Solution one = converged(compliance, distance, {Drive::Kind::load, load}, 1e-13);
    const Solution two = converged(compliance, distance, {Drive::Kind::load, load * (1.0 + change)}, 1e-13);
    const double slope = change * load / (two.report.approach - one.report.approach);
    for (std::size_t i = 0; i < g.size(); ++i)
      ASSERT_EQ(one.pressure[i] > 0.0, two.pressure[i] > 0.0);
    EXPECT_NEAR(stiffness(compliance, one.pressure) / slope, 1.0, 1e-5) << share;
  }
}

TEST(ContactStiffness, IsThatOfAFlatPunchOnAnOpenSurface)
{
  // Sneddon: 2 E' a of a circle, here with the area of the cells whose centre is in it: first order in the cell.
  constexpr double modulus = 2.0, a = 0.7;
  std::vector<double> errors;
  for (const int n : {21, 41, 81, 161})
  {
    const SurfaceGrid g = square(n, 2.0, Boundary::open);
    std::vector<double> pressure(g.size());
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i)
        pressure[g.index(i, j)] = std::hypot(g.x(i), g.y(j)) < a ? 1.0 : 0.0;
    const double radius = 2.0 * std::sqrt(mean(pressure) / pi); // of a square of 2 x 2
    errors.push_back(stiffness(halfspace::SurfaceCompliance(g, modulus), pressure) / (2.0 * modulus * radius) - 1.0);
  }
  EXPECT_GT(test::Orders("stiffness of a circular punch, cells halved", errors).overall, 0.8);
  EXPECT_LT(std::abs(errors.back()), 0.02);
}

TEST(ContactStiffness, OfStripsInAPeriod)
{
  // Strips of half-width a every L: the mean pressure per approach is pi E' / (2 L ln(1 / sin(pi a / L))), what follows from
  // Westergaard's waves, whose mean gap is h (1 - s + s ln s) at the share s = sin^2(pi a / L) of the pressure of full contact.
  constexpr double modulus = 3.0, length = 2.0;
  for (const int pressed : {1, 4, 10, 15}) // of 16 cells
  {
    std::vector<double> errors;
    for (const int finer : {1, 2, 4, 8})
    {
      const int n = 16 * finer;
      const SurfaceGrid g{n, 2, length / n, 0.3, Boundary::periodic, Boundary::periodic};
      std::vector<double> pressure(g.size());
      for (int j = 0; j < 2; ++j)
        std::fill_n(pressure.begin() + static_cast<std::ptrdiff_t>(g.index(0, j)), pressed * finer, 1.0);
      const double of_strip = stiffness(halfspace::SurfaceCompliance(g, modulus), pressure) / (length * 0.6);
      const double exact = pi * modulus / (2.0 * length * -std::log(std::sin(pi * pressed / 32.0)));
      errors.push_back(of_strip / exact - 1.0);
    }
    EXPECT_GT(test::Orders("stiffness of strips in a period, cells halved", errors).last, 0.8) << pressed;
    EXPECT_LT(std::abs(errors.back()), 0.1) << pressed;
  }
}

TEST(ContactStiffness, WithoutContactAndInFullContact)
{
  const SurfaceGrid g = square(8, 1.0, Boundary::periodic);
  const halfspace::SurfaceCompliance compliance(g, 1.0);
  std::vector<double> pressure(g.size());
  EXPECT_EQ(stiffness(compliance, pressure), 0.0);
  pressure.assign(g.size(), 1.0);
  EXPECT_EQ(stiffness(compliance, pressure), std::numeric_limits<double>::infinity());
  // With one open cell it is finite, and larger than with two.
  pressure[5] = 0.0;
  const double of_one = stiffness(compliance, pressure);
  pressure[30] = 0.0;
  EXPECT_GT(of_one, 1.5 * stiffness(compliance, pressure));
  EXPECT_TRUE(std::isfinite(of_one));
}

TEST(MeanGap, IsImposedByTheApproachThatLeavesIt)
{
  const SurfaceGrid g = square(36, 2.0, Boundary::periodic);
  const halfspace::SurfaceCompliance compliance(g, 3.0);
  const std::vector<double> distance = rough(g);
  const double touch = mean(distance) - *std::min_element(distance.begin(), distance.end());
  for (const double share : {0.9, 0.5, 0.1, 0.01, 1e-3})
  {
    const Solution s = converged(compliance, distance, {Drive::Kind::mean_gap, share * touch}, 1e-10);
    EXPECT_NEAR(mean(s.gap), share * touch, 1e-14); // displacements have the mean zero: rounding
    const Solution same = converged(compliance, distance, {Drive::Kind::approach, s.report.approach}, 1e-10);
    EXPECT_NEAR(mean(same.pressure), mean(s.pressure), 1e-12 * mean(s.pressure));
  }
  const Solution apart = converged(compliance, distance, {Drive::Kind::mean_gap, 1.1 * touch}, 1e-10);
  EXPECT_EQ(mean(apart.pressure), 0.0);
}

TEST(MeanGap, IsRefusedIfNegativeOrWithoutAPeriod)
{
  for (const Boundary boundary : {Boundary::periodic, Boundary::open})
  {
    const SurfaceGrid g = square(8, 1.0, boundary);
    const halfspace::SurfaceCompliance compliance(g, 1.0);
    try
    {
      (void)converged(compliance, rough(g), {Drive::Kind::mean_gap, boundary == Boundary::open ? 0.1 : -0.1}, 1e-10);
      FAIL() << "accepted";
    }
    catch (const InputError& e)
    {
      EXPECT_NE(std::string(e.what()).find("allowed: >= 0, and only for bodies that are periodic along both axes"),
                std::string::npos)
          << e.what();
    }
  }
}

} // namespace
} // namespace brinell::contact::contact_stiffness_test
