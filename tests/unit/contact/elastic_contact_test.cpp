// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/contact/elastic_contact.hpp"

#include "brinell/green/rectangle.hpp"
#include "brinell/reference/hertz.hpp"
#include "contact_solution.hpp"
#include "grid_fields.hpp"
#include "order.hpp"
#include "random_field.hpp"
#include "refusal.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace brinell::contact::elastic_contact_test
{
namespace
{

using Solution = test::ContactSolution;
using test::expect_complementary;
using test::largest;
using test::paraboloid;

/// At no approach: the gap is given where nothing is displaced, negative where the bodies overlap.
Solution solution(const SurfaceGrid& grid, double modulus, const std::vector<double>& rigid_gap, double tolerance,
                  std::vector<double> guess = {}, int max_iterations = 1000)
{
  return test::solved(halfspace::SurfaceCompliance(grid, modulus), rigid_gap, {}, tolerance, max_iterations,
                      std::move(guess));
}

TEST(HertzContactTest, LoadRadiusAndPeakPressureConverge)
{
  // Constant pressures err by the second order inside; on the rim, which falls on whole cells, a strip of width h/a
  // carries a share (h/a)^1.5 of the load. Radius from the area: known to a part of the cells on the rim, order one.
  // Peak pressure: far from the rim.
  const double approach = 0.01, modulus = 1.0;
  const auto exact = reference::point_contact_at_approach(1.0, modulus, approach);
  std::vector<double> load, radius, peak;
  for (const int cells : {10, 20, 40}) // to the radius
  {
    const int n = 2 * cells + 5;
    const double h = exact.contact_radius / cells;
    const SurfaceGrid g{n, n, h, h};
    const Solution s = solution(g, modulus, paraboloid(g, approach), 1e-10 * approach);
    expect_complementary(s, 1e-10 * approach);
    load.push_back(s.load(g) / exact.load - 1.0);
    radius.push_back(std::sqrt(static_cast<double>(s.cells_in_contact()) * g.cell_area() / std::numbers::pi) /
                         exact.contact_radius -
                     1.0);
    peak.push_back(largest(s.pressure) / exact.peak_pressure - 1.0);
  }
  EXPECT_GT(test::Orders("Hertz, load", load).overall, 1.3);
  EXPECT_GT(test::Orders("Hertz, peak pressure", peak).overall, 1.8);
  EXPECT_GT(test::Orders("Hertz, radius", radius).overall, 0.8);
  EXPECT_LT(std::abs(load.back()), 0.1 * std::pow(40.0, -1.5));
  EXPECT_LT(std::abs(peak.back()), 1.0 / (40 * 40));
  EXPECT_LT(std::abs(radius.back()), 0.5 / 40);
}

/// The same problem by a dense matrix, one cell after the other (projected Gauss-Seidel): slow and certain for a
/// symmetric positive definite matrix.
std::vector<double> dense_pressure(const SurfaceGrid& g, double modulus, const std::vector<double>& rigid_gap)
{
  const std::size_t n = g.size();
  std::vector<double> a(n * n);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j)
    {
      const auto nx = static_cast<std::size_t>(g.nx);
      const double x = (static_cast<double>(i % nx) - static_cast<double>(j % nx)) * g.dx;
      const double y = (static_cast<double>(i / nx) - static_cast<double>(j / nx)) * g.dy;
      a[i * n + j] = green::rectangle_displacement(x, y, g.dx, g.dy) / (std::numbers::pi * modulus);
    }
  std::vector<double> p(n, 0.0);
  double change = 1.0;
  for (int sweep = 0; sweep < 20000 && change > 1e-14 * largest(p); ++sweep)
  {
    change = 0.0;
    for (std::size_t i = 0; i < n; ++i)
    {
      double gap = rigid_gap[i];
      for (std::size_t j = 0; j < n; ++j)
        gap += a[i * n + j] * p[j];
      const double next = std::max(0.0, p[i] - gap / a[i * n + i]);
      change = std::max(change, std::abs(next - p[i]));
      p[i] = next;
    }
  }
  return p;
}

TEST(RoughContactTest, MeetsTheDenseSolver)
{
  // Both stop at 1e-13 of the roughness; pressure is gap times the inverse of a matrix of condition below 100.
  for (const auto& [grid, seed] :
       {std::pair{SurfaceGrid{12, 9, 1.0, 1.3}, 1u}, std::pair{SurfaceGrid{7, 13, 1.0, 0.8}, 2u}})
  {
    const std::vector<double> rigid_gap = test::random_field(grid.size(), seed, -1.0, 1.5);
    const Solution s = solution(grid, 1.0, rigid_gap, 1e-13);
    expect_complementary(s, 1e-13);
    const std::vector<double> expected = dense_pressure(grid, 1.0, rigid_gap);
    for (std::size_t i = 0; i < expected.size(); ++i)
      EXPECT_NEAR(s.pressure[i], expected[i], 1e-10 * largest(expected));
    const auto touching = std::count_if(expected.begin(), expected.end(), [](double p) { return p > 0.0; });
    EXPECT_GT(touching, 10); // the test would be void without contact, or in full contact
    EXPECT_LT(touching, static_cast<long>(grid.size()) - 10);
  }
}

TEST(ElasticContactTest, SeparatedSurfacesCarryNothing)
{
  const SurfaceGrid g{8, 8, 1.0, 1.0};
  const std::vector<double> rigid_gap = paraboloid(g, -0.5);
  for (const double guess : {0.0, 3.0}) // also from a contact that has just been lost
  {
    const Solution s = solution(g, 1.0, rigid_gap, 1e-12, std::vector<double>(g.size(), guess));
    ASSERT_TRUE(s.report.converged);
    EXPECT_EQ(largest(s.pressure), 0.0);
    for (std::size_t i = 0; i < g.size(); ++i)
      EXPECT_NEAR(s.gap[i], rigid_gap[i], 1e-12);
  }
}

TEST(ElasticContactTest, FullContactClosesEveryGap)
{
  const SurfaceGrid g{9, 6, 1.0, 1.0};
  std::vector<double> rigid_gap = test::random_field(g.size(), 5, -1.0, 0.0);
  for (double& h : rigid_gap)
    h = 0.02 * h - 10.0;
  const Solution s = solution(g, 1.0, rigid_gap, 1e-10);
  expect_complementary(s, 1e-10);
  EXPECT_GT(*std::min_element(s.pressure.begin(), s.pressure.end()), 0.0);
}

TEST(ElasticContactTest, OneCellIsALinearSpring)
{
  const SurfaceGrid g{1, 1, 2.0, 2.0};
  const Solution s = solution(g, 3.0, {-0.5}, 1e-14);
  ASSERT_TRUE(s.report.converged);
  const double compliance = green::rectangle_displacement(0.0, 0.0, 2.0, 2.0) / (std::numbers::pi * 3.0);
  EXPECT_NEAR(s.pressure[0], 0.5 / compliance, 1e-12);
}

TEST(ElasticContactTest, AnyGuessGivesTheSamePressureAndTheAnswerIsFoundAtOnce)
{
  const SurfaceGrid g{15, 15, 0.02, 0.02};
  const double tolerance = 1e-12;
  const std::vector<double> rigid_gap = paraboloid(g, 0.01);
  const Solution cold = solution(g, 1.0, rigid_gap, tolerance);
  std::vector<double> wild = test::random_field(g.size(), 9, -0.1, 0.3);
  const Solution warm = solution(g, 1.0, rigid_gap, tolerance, wild);
  ASSERT_TRUE(cold.report.converged && warm.report.converged);
  for (std::size_t i = 0; i < g.size(); ++i) // gap/approach 1e-10, times the condition
    EXPECT_NEAR(warm.pressure[i], cold.pressure[i], 1e-8 * largest(cold.pressure));
  EXPECT_EQ(solution(g, 1.0, rigid_gap, tolerance, cold.pressure).report.iterations, 0);
}

TEST(ElasticContactTest, UnitsDoNotMatter)
{
  const double modulus = 1.1e11, approach = 1e-5, unit = 1e6;
  const SurfaceGrid metre{13, 11, 6e-4, 7e-4}, micrometre{13, 11, 6e2, 7e2};
  const Solution a = solution(metre, modulus, paraboloid(metre, approach), 1e-11 * approach);
  const Solution b = solution(micrometre, modulus / (unit * unit), paraboloid(micrometre, unit * approach, unit),
                              1e-11 * approach * unit);
  ASSERT_TRUE(a.report.converged && b.report.converged);
  for (std::size_t i = 0; i < a.pressure.size(); ++i)
    EXPECT_NEAR(b.pressure[i] * unit * unit, a.pressure[i], 1e-9 * largest(a.pressure));
}

TEST(ElasticContactTest, SaysWhenItHasNotConverged)
{
  const SurfaceGrid g{15, 15, 0.02, 0.02};
  const Solution s = solution(g, 1.0, paraboloid(g, 0.01), 1e-12, {}, 2);
  EXPECT_FALSE(s.report.converged);
  EXPECT_EQ(s.report.iterations, 2);
  EXPECT_GT(std::max(s.report.gap_error, s.report.penetration), 1e-12);
}

TEST(ContactDoorTest, RefusesFieldsOfAnotherSize)
{
  const SurfaceGrid grid{4, 3, 1.0, 1.0};
  const halfspace::SurfaceCompliance compliance(grid, 1.0);
  ElasticContact contact(compliance);
  std::vector<double> field(12), other(12), short_field(11);
  const auto solve = [&](const std::vector<double>& distance, std::vector<double>& pressure, std::vector<double>& gap) {
    static_cast<void>(contact.solve(distance, {Drive::Kind::load, 0.0}, 1e-9, 10, pressure, gap));
  };
  test::expect_refused("ElasticContact::solve: the distance", 11, 12, [&] { solve(short_field, field, other); });
  test::expect_refused("ElasticContact::solve: the pressure", 11, 12, [&] { solve(field, short_field, other); });
  test::expect_refused("ElasticContact::solve: the gap", 11, 12, [&] { solve(field, other, short_field); });
}

} // namespace
} // namespace brinell::contact::elastic_contact_test
