// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/contact/elastic_contact.hpp"

#include "brinell/green/rectangle.hpp"
#include "brinell/reference/hertz.hpp"
#include "order.hpp"
#include "random_field.hpp"
#include "refusal.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <omp.h>
#include <vector>

namespace brinell::contact
{
namespace
{

struct Solution
{
  Report report;
  std::vector<double> pressure, gap;
};

Solution solution(const SurfaceGrid& grid, double modulus, const std::vector<double>& rigid_gap, double tolerance,
                  std::vector<double> guess = {}, int max_iterations = 1000)
{
  const halfspace::SurfaceCompliance compliance(grid, modulus);
  ElasticContact contact(compliance);
  guess.resize(grid.size(), 0.0);
  Solution s{{}, std::move(guess), std::vector<double>(grid.size())};
  s.report = contact.solve(rigid_gap, {}, tolerance, max_iterations, s.pressure, s.gap);
  return s;
}

/// r^2/2 - approach around the middle of the grid, R = 1.
std::vector<double> paraboloid(const SurfaceGrid& g, double approach, double unit = 1.0)
{
  std::vector<double> gap(g.size());
  for (int j = 0; j < g.ny; ++j)
    for (int i = 0; i < g.nx; ++i)
    {
      const double x = (i - 0.5 * (g.nx - 1)) * g.dx, y = (j - 0.5 * (g.ny - 1)) * g.dy;
      gap[g.index(i, j)] = 0.5 * (x * x + y * y) / unit - approach;
    }
  return gap;
}

double largest(const std::vector<double>& v)
{
  return *std::max_element(v.begin(), v.end());
}

double sum(const std::vector<double>& v)
{
  double s = 0.0;
  for (const double x : v)
    s += x;
  return s;
}

void expect_complementary(const Solution& s, double tolerance)
{
  ASSERT_TRUE(s.report.converged);
  for (std::size_t i = 0; i < s.gap.size(); ++i)
  {
    EXPECT_GE(s.pressure[i], 0.0);
    EXPECT_GE(s.gap[i], -tolerance);
    EXPECT_TRUE(s.pressure[i] == 0.0 || std::abs(s.gap[i]) <= tolerance) << s.gap[i];
  }
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
    const auto touching = std::count_if(s.pressure.begin(), s.pressure.end(), [](double p) { return p > 0.0; });
    load.push_back(sum(s.pressure) * g.cell_area() / exact.load - 1.0);
    radius.push_back(
        std::sqrt(static_cast<double>(touching) * g.cell_area() / std::numbers::pi) / exact.contact_radius - 1.0);
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

/// The same paraboloid under a load.
Solution under_load(const SurfaceGrid& grid, double modulus, double load, double tolerance, double scale = 1.0)
{
  const halfspace::SurfaceCompliance compliance(grid, modulus);
  ElasticContact contact(compliance);
  Solution s{{}, std::vector<double>(grid.size()), std::vector<double>(grid.size())};
  std::vector<double> distance = paraboloid(grid, 0.0);
  for (double& d : distance)
    d *= scale;
  s.report = contact.solve(distance, {Drive::Kind::load, load}, tolerance, 1000, s.pressure, s.gap);
  return s;
}

TEST(LoadDrivenTest, FindsTheApproachThatGivesTheLoad)
{
  const SurfaceGrid g{31, 27, 0.012, 0.014};
  const double approach = 0.01, tolerance = 1e-12 * approach;
  const Solution given = solution(g, 2.0, paraboloid(g, approach), tolerance);
  const double load = sum(given.pressure) * g.cell_area();
  const Solution found = under_load(g, 2.0, load, tolerance);
  expect_complementary(found, tolerance);
  EXPECT_NEAR(found.report.approach, approach, 1e-9 * approach);
  EXPECT_NEAR(sum(found.pressure) * g.cell_area(), load, 1e-12 * load);
  for (std::size_t i = 0; i < g.size(); ++i)
    EXPECT_NEAR(found.pressure[i], given.pressure[i], 1e-8 * largest(given.pressure));
}

TEST(LoadDrivenTest, NoLoadIsTheFirstTouch)
{
  const SurfaceGrid g{9, 9, 0.1, 0.1};
  const halfspace::SurfaceCompliance compliance(g, 1.0);
  ElasticContact contact(compliance);
  std::vector<double> pressure(g.size(), 3.0), gap(g.size());
  const Report report = contact.solve(paraboloid(g, 0.25), {Drive::Kind::load, 0.0}, 1e-12, 100, pressure, gap);
  EXPECT_TRUE(report.converged);
  EXPECT_EQ(report.approach, -0.25);
  EXPECT_EQ(largest(pressure), 0.0);
  EXPECT_EQ(*std::min_element(gap.begin(), gap.end()), 0.0);
}

TEST(LoadDrivenTest, AFlatPunchAndANearlyFlatOne)
{
  // Everything touches from the start, or nearly so: no cell to begin with is better than another.
  const SurfaceGrid g{15, 15, 0.1, 0.1};
  for (const double scale : {0.0, 1e-9})
  {
    const Solution s = under_load(g, 1.0, 1.0, 1e-12, scale);
    expect_complementary(s, 1e-12);
    EXPECT_NEAR(sum(s.pressure) * g.cell_area(), 1.0, 1e-12);
  }
}

TEST(LoadDrivenTest, ANumberThatIsNoneIsNotAConvergedOne)
{
  const SurfaceGrid g{5, 5, 0.1, 0.1};
  const halfspace::SurfaceCompliance compliance(g, 1.0);
  ElasticContact contact(compliance);
  std::vector<double> distance = paraboloid(g, 0.0);
  distance[7] = std::nan("");
  for (const Drive& drive : {Drive{Drive::Kind::load, 1.0}, Drive{Drive::Kind::approach, 0.02}})
  {
    std::vector<double> pressure(g.size(), 0.0), gap(g.size());
    EXPECT_FALSE(contact.solve(distance, drive, 1e-9, 50, pressure, gap).converged);
  }
}

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
    const halfspace::SurfaceCompliance compliance(grid, 1.0);
    ElasticContact contact(compliance);
    Solution s{{}, std::vector<double>(grid.size()), std::vector<double>(grid.size())};
    s.report = contact.solve(distance, drive, tolerance, max_iterations, s.pressure, s.gap);
    return s;
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
} // namespace brinell::contact
