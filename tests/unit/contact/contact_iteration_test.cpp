// SPDX-License-Identifier: BSD-3-Clause
// The steps of the contact solver: what they are, what they cost, and what is reported of them.
#include "brinell/contact/elastic_contact.hpp"

#include "contact_solution.hpp"
#include "grid_fields.hpp"
#include "random_field.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <omp.h>
#include <vector>

namespace brinell::contact::contact_iteration_test
{
namespace
{

using Solution = test::ContactSolution;
using test::expect_complementary;
using test::largest;
using test::paraboloid;
using test::sum;

/// A sphere with roughness in several waves, pressed by half the height of the sphere's cap on the grid.
struct RoughSphere
{
  SurfaceGrid grid;
  std::vector<double> distance;
  double overlap = 0.0;

  explicit RoughSphere(int n, double roughness) : grid{n, n, 1.0 / n, 1.0 / n}, distance(paraboloid(grid, 0.0))
  {
    overlap = 0.5 * 0.3 * 0.3;
    const std::vector<double> phase = test::random_field(24, 11, 0.0, 2.0 * std::numbers::pi);
    for (int k = 0; k < 12; ++k)
    {
      const double wave = 2.0 * std::numbers::pi * (k + 2), turn = phase[static_cast<std::size_t>(2 * k)];
      for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i)
          distance[static_cast<std::size_t>(i + n * j)] +=
              roughness * overlap * std::pow(k + 1.0, -1.8) *
              std::cos(wave * (std::cos(turn) * i * grid.dx + std::sin(turn) * j * grid.dy) +
                       phase[static_cast<std::size_t>(2 * k + 1)]);
    }
  }
  /// Of modulus 1.
  [[nodiscard]] Solution pressed(const Drive& drive, double tolerance, int max_iterations = 1000) const
  {
    return test::solved(halfspace::SurfaceCompliance(grid, 1.0), distance, drive, tolerance, max_iterations);
  }
};

/// The method as it is written, with sums in the order of the cells and a product with the pressure in every iteration.
Solution by_two_products(const RoughSphere& problem, const Drive& drive, double tolerance)
{
  const SurfaceGrid& grid = problem.grid;
  const halfspace::SurfaceCompliance compliance(grid, 1.0);
  halfspace::SurfaceCompliance::Scratch scratch = compliance.make_scratch();
  const bool load_given = drive.kind == Drive::Kind::load;
  const std::size_t n = grid.size();
  std::vector<double> p(n), g(n), d(n), wanted(n), image(n);
  const auto mean = [&](const std::vector<double>& field, const auto& counts)
  {
    double total = 0.0, count = 0.0;
    for (std::size_t i = 0; i < n; ++i)
      if (counts(i))
        total += field[i], count += 1.0;
    return total / count;
  };
  const auto pressed = [&](std::size_t i) { return p[i] > 0.0; };
  const auto is_free = [&](std::size_t i) { return p[i] > 0.0 || g[i] < 0.0; };
  const auto keep_load = [&](std::vector<double>& field)
  {
    const double shift = load_given ? mean(field, is_free) : 0.0;
    for (std::size_t i = 0; i < n; ++i)
      field[i] = is_free(i) ? field[i] - shift : 0.0;
  };
  const auto along = [&](const std::vector<double>& field)
  { return std::inner_product(field.begin(), field.end(), g.begin(), 0.0); };
  const auto scale = [&]
  {
    const double factor = drive.value / (sum(p) * grid.cell_area());
    for (double& value : p)
      value *= factor;
  };
  if (load_given)
  {
    p[static_cast<std::size_t>(std::min_element(problem.distance.begin(), problem.distance.end()) -
                               problem.distance.begin())] = 1.0;
    scale();
  }
  else
    for (std::size_t i = 0; i < n; ++i)
      p[i] = std::max(0.0, drive.value - problem.distance[i]) / compliance.largest();
  double before = 0.0;
  Report report;
  for (;; ++report.iterations)
  {
    compliance.apply({.pressure = p}, {.z = g}, scratch);
    for (std::size_t i = 0; i < n; ++i)
      g[i] += problem.distance[i];
    report.approach = load_given ? mean(g, pressed) : drive.value;
    double error = 0.0;
    for (std::size_t i = 0; i < n; ++i)
    {
      g[i] -= report.approach;
      error = std::max(error, pressed(i) ? std::abs(g[i]) : -g[i]);
    }
    report.converged = error <= tolerance;
    if (report.converged || report.iterations == 1000)
      return {report, p, g};
    for (std::size_t i = 0; i < n; ++i)
      wanted[i] = is_free(i) ? g[i] : 0.0;
    compliance.apply_inverse(wanted, wanted, scratch);
    keep_load(wanted);
    keep_load(d);
    const double slope = along(wanted);
    double beta = before > 0.0 ? slope / before : 0.0;
    before = slope;
    if (slope + beta * along(d) <= 0.0)
      beta = 0.0;
    for (std::size_t i = 0; i < n; ++i)
      d[i] = wanted[i] + beta * d[i];
    compliance.apply({.pressure = d}, {.z = image}, scratch);
    const double step = along(d) / std::inner_product(image.begin(), image.end(), d.begin(), 0.0);
    for (std::size_t i = 0; i < n; ++i)
      p[i] = std::max(0.0, p[i] - step * d[i]);
    if (load_given)
      scale();
  }
}

TEST(OneProductTest, TakesTheStepsOfTheMethodAndCostsLess)
{
  for (const int n : {31, 47}) // larger grids begin with the pressure on larger cells
  {
    const RoughSphere problem(n, 0.2);
    for (const Drive& drive : {Drive{Drive::Kind::approach, problem.overlap}, Drive{Drive::Kind::load, 0.01}})
    {
      const double tolerance = 1e-8 * problem.overlap;
      const Solution s = problem.pressed(drive, tolerance);
      expect_complementary(s, tolerance);
      const Solution twin = by_two_products(problem, drive, tolerance);
      ASSERT_TRUE(twin.report.converged);
      EXPECT_EQ(s.report.iterations, twin.report.iterations);
      EXPECT_NEAR(s.report.approach, twin.report.approach, 1e-12 * problem.overlap);
      // Each step feeds on the rounding of the one before, but what is left of it is below the tolerance of the gap.
      for (std::size_t i = 0; i < s.pressure.size(); ++i)
        EXPECT_NEAR(s.pressure[i], twin.pressure[i], 1e-8 * largest(twin.pressure));
      EXPECT_LT(s.report.products, 1.9 * s.report.iterations); // 2 by the method as it is written
    }
  }
}

/// What the pressure itself says, by a product of its own.
void expect_true_errors(const RoughSphere& problem, const Solution& s)
{
  const halfspace::SurfaceCompliance compliance(problem.grid, 1.0);
  halfspace::SurfaceCompliance::Scratch scratch = compliance.make_scratch();
  std::vector<double> gap(s.gap.size());
  compliance.apply({.pressure = s.pressure}, {.z = gap}, scratch);
  double under = 0.0, outside = 0.0;
  for (std::size_t i = 0; i < gap.size(); ++i)
  {
    gap[i] = gap[i] + problem.distance[i] - s.report.approach;
    EXPECT_EQ(s.gap[i], gap[i]);
    (s.pressure[i] > 0.0 ? under : outside) =
        std::max(s.pressure[i] > 0.0 ? under : outside, s.pressure[i] > 0.0 ? std::abs(gap[i]) : -gap[i]);
  }
  EXPECT_EQ(s.report.gap_error, under);
  EXPECT_EQ(s.report.penetration, outside);
}

TEST(OneProductTest, WhatIsReportedComesOfTheFinalPressure)
{
  // Also in the last iteration allowed, and at a tolerance near rounding, where hundreds of followed steps would not tell.
  const RoughSphere problem(65, 0.2);
  for (const Drive& drive : {Drive{Drive::Kind::approach, problem.overlap}, Drive{Drive::Kind::load, 0.01}})
  {
    for (const int iterations : {0, 1, 7, 40})
      expect_true_errors(problem, problem.pressed(drive, 1e-13 * problem.overlap, iterations));
    const Solution exact = problem.pressed(drive, 1e-13 * problem.overlap);
    EXPECT_TRUE(exact.report.converged);
    expect_true_errors(problem, exact);
  }
}

TEST(OneProductTest, ManyStepsDoNotDriftApartFromThePressure)
{
  // No tolerance is ever met: hundreds of steps at rounding level, where errors of following would add up.
  const RoughSphere problem(33, 0.0);
  const Solution s = problem.pressed({Drive::Kind::approach, problem.overlap}, 0.0, 1000);
  EXPECT_FALSE(s.report.converged);
  expect_true_errors(problem, s);
  EXPECT_LT(s.report.gap_error, 1e-13 * problem.overlap);
}

TEST(ThreadsTest, DoNotChangeADigit)
{
  // 139 cells: the last piece of the sums and the last batch of rows are incomplete.
  const int before = omp_get_max_threads();
  const RoughSphere problem(139, 0.1);
  for (const Drive& drive : {Drive{Drive::Kind::approach, problem.overlap}, Drive{Drive::Kind::load, 0.01}})
  {
    std::vector<Solution> solutions;
    for (const int threads : {1, 2, 3})
    {
      omp_set_num_threads(threads);
      solutions.push_back(problem.pressed(drive, 1e-6 * problem.overlap));
    }
    omp_set_num_threads(before);
    for (const Solution& s : solutions)
    {
      EXPECT_TRUE(s.report.converged);
      EXPECT_EQ(s.report.iterations, solutions.front().report.iterations);
      EXPECT_EQ(s.report.approach, solutions.front().report.approach);
      EXPECT_EQ(s.pressure, solutions.front().pressure);
      EXPECT_EQ(s.gap, solutions.front().gap);
    }
  }
}

} // namespace
} // namespace brinell::contact::contact_iteration_test
