// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/foundation/error.hpp"
#include "brinell/quality/convergence.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

namespace brinell::quality::convergence_test
{

using namespace simulation;
namespace
{

constexpr double rounding = 1e-9; // of the bisection for the order

/// 7 + 3 h^order at cells that fall by `ratio`.
Convergence of_power(double order, double ratio, int runs = 3)
{
  std::vector<double> cells, values;
  for (int i = 0; i < runs; ++i)
  {
    cells.push_back(std::pow(ratio, -i));
    values.push_back(7.0 + 3.0 * std::pow(cells.back(), order));
  }
  return convergence(cells, values, 0.0);
}

TEST(Convergence, FindsTheOrderAndTheLimitOfAPower)
{
  for (const double order : {1.0, 1.5, 2.0})
    for (const double ratio : {std::sqrt(2.0), 1.5, 2.0})
    {
      const Convergence c = of_power(order, ratio);
      EXPECT_NEAR(c.order, order, rounding);
      EXPECT_NEAR(c.extrapolated, 7.0, 1e-8);
      EXPECT_LT(c.low, 7.0);
      EXPECT_GT(c.high, 7.0);
      EXPECT_NEAR(c.high - c.value, 1.25 * (c.value - 7.0), 1e-8) << "Roache's safety factor on the true error";
      EXPECT_NEAR(c.relative_error, (c.high - c.value) / c.value, 1e-12);
    }
}

TEST(Convergence, AnOrderAboveTheKnownOneIsAccidental)
{
  // Errors of first order, of which the coarsest is too large, so that the differences fall as of order 2.15.
  const double r = std::sqrt(2.0), limit = 7.0, error = 0.3;
  const double fine = error * (r - 1.0);
  const std::vector<double> cells{r * r, r, 1.0};
  const std::vector<double> values{limit + error + fine + fine * std::pow(r, 2.15), limit + error + fine,
                                   limit + error};
  const Convergence free = convergence(cells, values, 0.0), known = convergence(cells, values, 0.0, 0.0, 1.0);
  EXPECT_NEAR(known.order, 2.15, 1e-6);
  EXPECT_GT(free.low, limit);
  EXPECT_LT(known.low, limit);
  EXPECT_NEAR(known.extrapolated, limit, 1e-9);
  EXPECT_NEAR(known.high - known.value, 1.25 * error, 1e-9);
}

TEST(Convergence, TakesAnyRatiosOfCells)
{
  const std::vector<double> cells{3.0, 2.0, 1.7};
  std::vector<double> values;
  for (const double h : cells)
    values.push_back(1.0 - 0.1 * std::pow(h, 1.5));
  const Convergence c = convergence(cells, values, 0.0);
  EXPECT_NEAR(c.order, 1.5, 1e-8);
  EXPECT_NEAR(c.extrapolated, 1.0, 1e-8);
}

TEST(Convergence, OfTwoRunsAssumesTheFirstOrderAndDoublesTheSafety)
{
  const Convergence c = of_power(1.0, 2.0, 2);
  EXPECT_TRUE(std::isnan(c.order));
  EXPECT_TRUE(std::isnan(c.extrapolated));
  EXPECT_NEAR(c.high - c.value, 3.0 * (c.value - 7.0), 1e-9);
}

TEST(Convergence, ToAndFroHasNoOrderButAWideInterval)
{
  const Convergence c = convergence(std::vector{4.0, 2.0, 1.0}, std::vector{10.0, 10.4, 10.1}, 0.0);
  EXPECT_TRUE(std::isnan(c.order));
  EXPECT_TRUE(std::isnan(c.extrapolated));
  EXPECT_NEAR(c.high - c.value, 3.0 * 0.4, 1e-12);
}

TEST(Convergence, WithoutAnOrderNothingLessIsToldThanIsKnown)
{
  // Values that go to and fro may lie close by accident, values with an order do not, and values without any difference are there.
  const auto width = [](const std::vector<double>& values)
  {
    const Convergence c = convergence(std::vector{4.0, 2.0, 1.0}, values, 0.0, 0.2);
    return c.high - c.value;
  };
  EXPECT_NEAR(width({10.0, 10.01, 10.0}), 0.2 * 10.0, 1e-12);
  EXPECT_NEAR(width({10.0, 11.0, 10.0}), 3.0 * 1.0, 1e-12);
  EXPECT_LT(width({10.5, 10.1, 10.0}), 0.1);
  EXPECT_NEAR(width({10.0, 10.0, 10.0}), 1e-4 * 10.0, 1e-12);
}

TEST(Convergence, DivergenceHasNoOrderEither)
{
  const Convergence c = convergence(std::vector{4.0, 2.0, 1.0}, std::vector{10.0, 10.1, 10.4}, 0.0);
  EXPECT_TRUE(std::isnan(c.order));
  EXPECT_GE(c.high - c.value, 3.0 * 0.3);
}

TEST(Convergence, AnOrderThatIsTooGoodIsNotBelieved)
{
  // The last difference is small by accident: as if of second order it would be 0.25, not 0.001.
  const Convergence c = convergence(std::vector{4.0, 2.0, 1.0}, std::vector{11.0, 10.0, 9.999}, 0.0);
  EXPECT_GT(c.order, 2.0);
  EXPECT_NEAR(c.high - c.value, 3.0 * 0.25 / 3.0, 1e-9);
}

TEST(Convergence, ConvergedValuesKeepTheErrorOfTheSolver)
{
  const Convergence c = convergence(std::vector{4.0, 2.0, 1.0}, std::vector{5.0, 5.0, 5.0}, 0.0);
  EXPECT_EQ(c.extrapolated, 5.0);
  EXPECT_NEAR(c.relative_error, 1e-4, 1e-12);
}

TEST(Convergence, NumbersNearZeroAreMeasuredByTheirScale)
{
  const Convergence c = convergence(std::vector{4.0, 2.0, 1.0}, std::vector{4e-3, -1e-3, 1e-3}, 100.0);
  EXPECT_NEAR(c.relative_error, 3.0 * 5e-3 / 100.0, 1e-12);
  EXPECT_EQ(convergence(std::vector{2.0, 1.0}, std::vector{0.0, 0.0}, 0.0).relative_error, 0.0);
}

TEST(Convergence, RefusesWhatIsNoSeries)
{
  EXPECT_THROW((void)convergence(std::vector{1.0}, std::vector{1.0}, 0.0), InputError);
  EXPECT_THROW((void)convergence(std::vector{1.0, 2.0}, std::vector{1.0, 1.0}, 0.0), InputError);
  EXPECT_THROW((void)convergence(std::vector{2.0, 1.0}, std::vector{1.0}, 0.0), InputError);
}

TEST(Convergence, CellsOfAnotherSizeStayAnOddNumberAlongACylinder)
{
  const Shape ball = Paraboloid{1e-3, 1e-3}, roller = Roller{1e-3, 0.9e-3}, flat = Plane{};
  Numerics by_resolution;
  scale_cells(by_resolution, ball, flat, 0.5);
  EXPECT_DOUBLE_EQ(by_resolution.resolution, 2.0 * Numerics{}.resolution);
  const auto scaled = [&](const Shape& upper)
  {
    Numerics cells;
    cells.spacing = {1e-5, 1e-4, 5e-6}; // nine along y of the roller
    scale_cells(cells, flat, upper, 0.8);
    return *cells.spacing;
  };
  EXPECT_EQ(scaled(ball), (std::array{0.8 * 1e-5, 0.8 * 1e-4, 0.8 * 5e-6}));
  EXPECT_EQ(scaled(roller), (std::array{0.8 * 1e-5, 0.9e-3 / 11.0, 0.8 * 5e-6}));
}

TEST(ScaleCells, APeriodStaysAWholeNumberOfCells)
{
  const Shape flat = Plane{};
  Numerics by_number;
  by_number.domain = {{Boundary::periodic, 1e-4, 8}, {Boundary::periodic, 1.5e-4, 12}, 1e-6};
  const auto cells = [&](double size)
  {
    Numerics n = by_number;
    scale_cells(n, flat, flat, size);
    return std::array{n.domain.x.cells, n.domain.y.cells};
  };
  EXPECT_EQ(cells(2.0), (std::array{4, 6}));
  EXPECT_EQ(cells(std::sqrt(2.0)), (std::array{6, 8}));
  EXPECT_EQ(cells(1.0), (std::array{8, 12}));
  EXPECT_EQ(cells(0.5), (std::array{16, 24}));
  Numerics finer = by_number;
  scale_cells(finer, flat, flat, 0.5);
  EXPECT_DOUBLE_EQ(finer.domain.layer, 0.5e-6);

  Numerics by_size = by_number;
  by_size.domain.x.cells = by_size.domain.y.cells = 0;
  by_size.domain.y.size = 1e-5; // one cell: nothing varies along y
  by_size.spacing = {1.25e-5, 1e-5, 5e-6};
  scale_cells(by_size, flat, flat, std::sqrt(2.0));
  EXPECT_DOUBLE_EQ((*by_size.spacing)[0], 1e-4 / 6.0);
  EXPECT_DOUBLE_EQ((*by_size.spacing)[1], 1e-5);

  by_number.domain.y.cells = 1;
  EXPECT_EQ(cells(0.5)[1], 1);
  by_number.domain.y.cells = 3; // two sizes of a series would be the same
  EXPECT_THROW(static_cast<void>(cells(0.5)), GridError);
  by_size.spacing = {0.5e-4, 1e-5, 5e-6};
  EXPECT_THROW(scale_cells(by_size, flat, flat, 0.5), GridError);
}

} // namespace
} // namespace brinell::quality::convergence_test
