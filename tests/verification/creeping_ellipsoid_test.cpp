// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/quality/quality.hpp"
#include "creeping_cylinder.hpp"
#include "record.hpp"
#include "scenario_runs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fmt/format.h>
#include <string>

/// Rolling with little creepage on elliptical contacts: Kalker's coefficients.
namespace brinell::verification::creeping_ellipsoid_test
{
namespace
{

using simulation::Creepage;
using simulation::RollingCase;

/// A rolling ellipsoid whose elastic contact is `length` times as long as wide.
RollingCase rolling_ellipsoid(double length, double cells)
{
  constexpr double R = 0.01;
  RollingCase c;
  c.lower = {simulation::Plane{}, {{200e9, 0.25}, {}}};
  c.upper = c.lower;
  c.drive = load(100.0);
  c.friction.coefficient = 0.3;
  c.creepage = Creepage{};
  c.resolution = cells;
  c.distance = 1e-3;
  c.load_steps = 2;
  const auto ratio = [&](double radius_y)
  {
    c.upper.shape = simulation::Paraboloid{R, radius_y};
    const simulation::RollingPlan p = simulation::plan(c);
    return p.half_width_x / p.half_width_y;
  };
  double narrow = 1e-3 * R, wide = 1e3 * R;
  for (int i = 0; i < 60; ++i)
    (ratio(std::sqrt(narrow * wide)) > length ? narrow : wide) = std::sqrt(narrow * wide);
  static_cast<void>(ratio(wide));
  // The narrower the contact along the motion, the more it is like a line, whose force takes long to become steady.
  c.distance = std::max(8.0, 10.0 / length) * simulation::plan(c).half_width_x;
  return c;
}

/// Creepage, or spin times the geometric mean of the half-lengths, of which the force is a share of friction times load.
double small_creepage(const RollingCase& c, double share)
{
  return share * c.friction.coefficient * simulation::plan(c).peak_pressure / (200e9 / 2.5);
}

TEST(RollingCreepage, EllipsesFollowKalker)
{
  // Kalker's table E.3 for nu = 1/4, ratio a/b of the half-length along the motion to that across; three digits, 8 cells.
  struct Row
  {
    double length, C11, C22, C23;
  };
  for (const Row& row : {Row{0.1, 3.31, 2.52, 0.473}, Row{0.3, 3.44, 2.75, 0.715}, Row{10.0 / 3.0, 6.34, 6.40, 4.32},
                         Row{10.0, 11.7, 12.8, 14.6}})
  {
    RollingCase c = rolling_ellipsoid(row.length, 8.0);
    const simulation::RollingPlan p = simulation::plan(c);
    const double area = p.half_width_x * p.half_width_y, small = small_creepage(c, 5e-3);
    const double unit = 200e9 / 2.5 * area * small;
    const auto end = [&](const Creepage& creepage)
    {
      c.creepage = creepage;
      return at_the_end(c, computed(c));
    };
    const std::string of = fmt::format("an ellipse of a/b = {:.3g}, 8 cells: ", row.length);
    test::expect_close(of + "C11 over the table's", end({small, 0.0, 0.0}).F_x / unit / row.C11, 1.0, 0.03,
                       "table: Kalker (1967)");
    test::expect_close(of + "C22 over the table's", end({0.0, small, 0.0}).F_y / unit / row.C22, 1.0, 0.03,
                       "table: Kalker (1967)");
    test::expect_close(of + "C23 over the table's", end({0.0, 0.0, small / std::sqrt(area)}).F_y / unit / row.C23, 1.0,
                       0.03, "table: Kalker (1967)");
  }
}

TEST(RollingCreepage, TheMomentOfASpinIsWithinItsExpectedError)
{
  // M = C33 G (a b)^2 phi of a small spin, nu = 1/4 (Kalker 1967), by the ratio a/b of an ellipse longer along the motion.
  struct Row
  {
    double length, C33, cells;
  };
  for (const Row& row : {Row{1.0, 1.19, 8.0}, Row{2.0, 0.819, 8.0}, Row{10.0 / 3.0, 0.674, 8.0},
                         Row{10.0 / 3.0, 0.674, 16.0}, Row{5.0, 0.601, 16.0}})
  {
    RollingCase c = rolling_ellipsoid(row.length, row.cells);
    const simulation::RollingPlan p = simulation::plan(c);
    const double area = p.half_width_x * p.half_width_y;
    c.creepage->spin = small_creepage(c, 0.02) / std::sqrt(area);
    const double exact = row.C33 * (200e9 / 2.5) * area * area * c.creepage->spin;
    const double error = at_the_end(c, computed(c)).M_z / exact - 1.0;
    double stated = 0.0;
    for (const quality::ExpectedError& e : quality::expected(c, p).resolution.expected_errors)
      if (e.quantity == "spin moment")
        stated = e.relative;
    std::printf("  a/b %.2f, %.0f cells: error of C33 %.3f, expected %.3f\n", row.length, row.cells, error, stated);
    EXPECT_NEAR(error, 0.0, 0.03) << row.length;
    EXPECT_LE(std::abs(error), stated) << row.length;
    EXPECT_LE(stated, 0.07) << row.length << ": says nothing";
  }
}

} // namespace
} // namespace brinell::verification::creeping_ellipsoid_test
