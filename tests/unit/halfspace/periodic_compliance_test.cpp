// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/foundation/error.hpp"
#include "brinell/green/rectangle.hpp"
#include "brinell/green/strip.hpp"
#include "grid_fields.hpp"
#include "order.hpp"
#include "periodic_grids.hpp"
#include "random_field.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>
#include <vector>

/// Displacement under a pressure with one or both axes periodic.
namespace brinell::halfspace::periodic_compliance_test
{
namespace
{

using test::largest;
using test::sampled;

constexpr double pi = std::numbers::pi;
constexpr double modulus = 1.7; // E'

class PeriodicWaveTest : public testing::TestWithParam<std::tuple<int, int>>
{
};

INSTANTIATE_TEST_SUITE_P(Cells, PeriodicWaveTest,
                         testing::Values(std::tuple{16, 12}, std::tuple{15, 9}, std::tuple{32, 1}, std::tuple{1, 20},
                                         std::tuple{7, 10}));

TEST_P(PeriodicWaveTest, GivesADisplacementOfTwoOverModulusAndWavenumber)
{
  const auto [nx, ny] = GetParam();
  const SurfaceGrid g = periodic(nx, ny, 0.5, 0.7);
  const SurfaceCompliance compliance(g, modulus);
  for (const auto& [a, b] : {std::pair{1, 0}, {0, 1}, {1, 1}, {3, 2}})
  {
    if (2 * a >= nx + (a == 0) || 2 * b >= ny + (b == 0))
      continue; // not told from a longer one by these cells
    const auto wave = sampled(g, [&, nx = nx, ny = ny, a = a, b = b](int i, int j)
                              { return 3.0 + std::cos(2.0 * pi * (a * i / double(nx) + b * j / double(ny)) + 0.3); });
    const auto u = displacement(compliance, wave);
    const double k = 2.0 * pi * std::hypot(a / (nx * g.dx), b / (ny * g.dy));
    for (std::size_t n = 0; n < u.size(); ++n) // the uniform part counts as nothing
      EXPECT_NEAR(u[n], 2.0 / (modulus * k) * (wave[n] - 3.0), 1e-13 / k) << a << ' ' << b;
  }
}

TEST(PeriodicSurfaceTest, OneCellHasNoResponseAndFewOnesAFiniteOne)
{
  EXPECT_THROW(SurfaceCompliance(periodic(1, 1, 0.5, 0.7), modulus), InputError);
  for (const auto& [nx, ny] : {std::pair{2, 1}, {1, 2}, {2, 2}, {3, 1}, {1, 3}})
  {
    const SurfaceGrid g = periodic(nx, ny, 0.5, 0.7);
    const SurfaceCompliance compliance(g, modulus);
    SurfaceCompliance::Scratch scratch = compliance.make_scratch();
    std::vector<double> p(g.size(), 0.0), u(g.size()), back(g.size());
    p[0] = 1.0;
    compliance.apply({.pressure = p}, {.z = u}, scratch);
    compliance.apply_inverse(u, back, scratch);
    const double mean = 1.0 / static_cast<double>(g.size());
    for (std::size_t n = 0; n < p.size(); ++n) // the displacement has no uniform part
      EXPECT_NEAR(back[n], p[n] - mean, 1e-12) << nx << ' ' << ny;
  }
}

TEST(StripTest, IsALongRectangleButForAConstant)
{
  const double dx = 0.4;
  const double length = 1e6;
  const auto strip = [&](double x)
  { return green::strip_displacement_edge(x + 0.5 * dx, 5.0) - green::strip_displacement_edge(x - 0.5 * dx, 5.0); };
  const double constant = strip(0.0) - green::rectangle_displacement(0.0, 0.0, dx, length);
  for (const double x : {0.1, 0.2, 0.9, 7.0}) // a finite length leaves (x / length)^2 of it; rounding of its logarithm
    EXPECT_NEAR(strip(x) - green::rectangle_displacement(x, 0.0, dx, length), constant, 1e-5 * dx);
  for (const double x : {0.0, 0.15, 0.2, 1.0})
    for (const double z : {0.0, 0.05, 0.3, 2.0})
    {
      if (x == 0.2 && z == 0.0)
        continue; // on the edge
      const SymTensor left = green::strip_stress_edge(x - 0.5 * dx, z, 0.3);
      const SymTensor right = green::strip_stress_edge(x + 0.5 * dx, z, 0.3);
      const SymTensor rectangle = green::rectangle_stress(x, 0.0, z, dx, length, 0.3);
      for (std::size_t c = 0; c < 6; ++c)
        EXPECT_NEAR(right[c] - left[c], rectangle[c], dx / length) << "component " << c << " at " << x << ' ' << z;
    }
}

TEST(OnePeriodicAxisTest, OneRowIsAStrip)
{
  const SurfaceGrid g = periodic_in_y(9, 1, 0.5, 3.0);
  const auto p = test::random_field(g.size(), 1);
  const auto u = displacement(SurfaceCompliance(g, modulus, 20.0), p);
  for (int i = 0; i < g.nx; ++i)
  {
    double sum = 0.0;
    for (int m = 0; m < g.nx; ++m)
      sum += p[g.index(m, 0)] * (green::strip_displacement_edge((i - m + 0.5) * g.dx, 20.0) -
                                 green::strip_displacement_edge((i - m - 0.5) * g.dx, 20.0));
    EXPECT_NEAR(u[g.index(i, 0)], sum / (pi * modulus), 1e-12);
  }
}

/// Copies of a pressure, `count` to each side along y, on a grid that is open.
std::vector<double> with_copies(const SurfaceGrid& g, const std::vector<double>& pressure, int count)
{
  std::vector<double> copies;
  for (int copy = -count; copy <= count; ++copy)
    copies.insert(copies.end(), pressure.begin(), pressure.end());
  EXPECT_EQ(copies.size(), g.size() * static_cast<std::size_t>(2 * count + 1));
  return copies;
}

TEST(OnePeriodicAxisTest, IsTheMiddleOfALongRowOfCopies)
{
  // Differences of displacements, as a row of copies sinks by a constant that grows with its logarithm. What the copies that
  // are missing add varies over the period as 1 / count^2.
  const SurfaceGrid g = periodic_in_y(6, 5, 0.5, 0.8);
  const auto p = test::random_field(g.size(), 2);
  const auto u = displacement(SurfaceCompliance(g, modulus, 50.0), p);
  std::vector<double> errors;
  for (const int count : {10, 20, 40})
  {
    SurfaceGrid row = g;
    row.boundary_y = Boundary::open;
    row.ny = g.ny * (2 * count + 1);
    const auto of_row = displacement(SurfaceCompliance(row, modulus), with_copies(g, p, count));
    const std::size_t middle = row.index(0, g.ny * count);
    double error = 0.0;
    for (std::size_t n = 0; n < u.size(); ++n)
      error = std::max(error, std::abs(u[n] - u[0] - of_row[middle + n] + of_row[middle]));
    errors.push_back(error / largest(u));
  }
  EXPECT_GT(test::Orders("row of copies, displacement, copies doubled", errors).overall, 1.8);
  EXPECT_LT(errors.back(), 1e-4);
  // The exact limit: what is left is the sum over the near copies and the strip for the far ones.
  EXPECT_LT(std::abs(4.0 * errors[2] - errors[1]) / 3.0, 2e-6);
}

TEST(OnePeriodicAxisTest, WavesAlongItThatTheOtherDoesNotChangeAreThoseOfTheWholePlane)
{
  // Rows so wide that their ends are many wavelengths away: the middle sees a wave without ends, but for the cells, which
  // sample the closed form of the rectangle where the periodic operator has waves: second order.
  std::vector<double> errors;
  for (const int ny : {16, 32, 64})
  {
    const SurfaceGrid g = periodic_in_y(8 * ny + 1, ny, 1.0 / ny, 1.0 / ny);
    const auto p = sampled(g, [&](int, int j) { return std::cos(2.0 * pi * j / ny); });
    const auto u = displacement(SurfaceCompliance(g, modulus, 50.0), p);
    errors.push_back(std::abs(u[g.index(4 * ny, 0)] * modulus * pi - 1.0));
  }
  EXPECT_GT(test::Orders("wave along the periodic axis, cells halved", errors).last, 1.9);
}

} // namespace
} // namespace brinell::halfspace::periodic_compliance_test
