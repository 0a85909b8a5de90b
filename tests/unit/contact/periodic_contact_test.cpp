// SPDX-License-Identifier: BSD-3-Clause
// Contact of surfaces that go on without end: Westergaard's and Johnson's waves, rows of cells as long rollers, and rough
// surfaces from the first touch to nearly full contact.
#include "brinell/foundation/error.hpp"
#include "contact_solution.hpp"
#include "order.hpp"
#include "random_field.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <string>
#include <vector>

namespace brinell::contact::periodic_contact_test
{
namespace
{

constexpr double pi = std::numbers::pi;

using Solution = test::ContactSolution;
using test::expect_complementary;

Solution solved(const SurfaceGrid& grid, double modulus, const std::vector<double>& distance, const Drive& drive,
                double tolerance, double reference = 0.0)
{
  constexpr int iterations = 500; // by far: tens are usual
  return test::solved(halfspace::SurfaceCompliance(grid, modulus, reference), distance, drive, tolerance, iterations);
}

double share_in_contact(const Solution& s)
{
  return static_cast<double>(s.cells_in_contact()) / static_cast<double>(s.pressure.size());
}

SurfaceGrid periodic(int nx, int ny, double lx, double ly)
{
  return {nx, ny, lx / nx, ly / ny, Boundary::periodic, Boundary::periodic};
}

/// A wave along x, or one along each axis, whose summit is in the middle of the grid.
std::vector<double> wavy(const SurfaceGrid& g, double height, bool along_both)
{
  std::vector<double> distance;
  for (int j = 0; j < g.ny; ++j)
    for (int i = 0; i < g.nx; ++i)
    {
      const double x = std::cos(2.0 * pi * g.x(i) / (g.nx * g.dx));
      const double y = std::cos(2.0 * pi * g.y(j) / (g.ny * g.dy));
      distance.push_back(height * (along_both ? 2.0 - x - y : 1.0 - x));
    }
  return distance;
}

TEST(WestergaardTest, PressureAndAreaOfAWave)
{
  // Westergaard 1939; Johnson 1985, eq. 13.7: h (1 - cos(2 pi x / L)) closes under the mean pressure pi E' h / L.
  constexpr double height = 0.01, length = 2.0, modulus = 3.0;
  const double full = pi * modulus * height / length;
  for (const double share : {0.02, 0.2, 0.5, 0.8, 0.97})
  {
    const double a = length / pi * std::asin(std::sqrt(share)); // half-width of the contact
    for (const int n : {65, 129, 257})
    {
      const SurfaceGrid g = periodic(n, 3, length, 0.1);
      const double load = share * full * length * 0.1;
      const Solution s = solved(g, modulus, wavy(g, height, false), {Drive::Kind::load, load}, 1e-10 * height);
      expect_complementary(s, 1e-10 * height);
      EXPECT_NEAR(share_in_contact(s), 2.0 * a / length, 2.0 / n); // a cell at either edge
      double error = 0.0;
      for (int i = 0; i < n; ++i)
      {
        const double x = g.x(i),
                     inside = std::pow(std::sin(pi * a / length), 2) - std::pow(std::sin(pi * x / length), 2);
        const double exact = inside > 0.0 ? 2.0 * share * full * std::cos(pi * x / length) /
                                                std::pow(std::sin(pi * a / length), 2) * std::sqrt(inside)
                                          : 0.0;
        error += std::abs(s.pressure[g.index(i, 1)] - exact) / n;
      }
      // A strip of one cell at the edge carries a share (dx / a)^1.5 of the load; where in its cell the edge lies is chance.
      EXPECT_LT(error, share * full * 0.5 * std::pow(g.dx / a, 1.5)) << share << ' ' << n;
    }
  }
}

TEST(WestergaardTest, FullContactOfWaves)
{
  // The pressure that keeps a wave flat is the wave itself, pi E' h / L high; Johnson, Greenwood, Higginson 1985 for two
  // waves across: each has its own. The operator has these waves exactly: rounding.
  constexpr double height = 0.01, length = 2.0, modulus = 3.0;
  for (const bool along_both : {false, true})
  {
    const SurfaceGrid g = periodic(32, 30, length, length);
    const std::vector<double> distance = wavy(g, height, along_both);
    const double full = pi * modulus * height / length * (along_both ? 2.0 : 1.0);
    const Solution s = solved(g, modulus, distance, {Drive::Kind::load, 1.1 * full * length * length}, 1e-13 * height);
    EXPECT_TRUE(s.report.converged);
    EXPECT_EQ(share_in_contact(s), 1.0);
    const double mean = std::accumulate(distance.begin(), distance.end(), 0.0) / static_cast<double>(g.size());
    EXPECT_NEAR(s.report.approach, mean, 1e-12 * height);
    for (std::size_t i = 0; i < g.size(); ++i)
      ASSERT_NEAR(s.pressure[i], 1.1 * full + pi * modulus / length * (mean - distance[i]), 1e-9 * full);
    // Just below, the valley is open: it opens with the square root of what the pressure is short of.
    const Solution less =
        solved(g, modulus, distance, {Drive::Kind::load, 0.9 * full * length * length}, 1e-9 * height);
    EXPECT_TRUE(less.report.converged);
    EXPECT_LT(share_in_contact(less), 1.0);
    EXPECT_GT(share_in_contact(less), 0.7);
  }
}

TEST(WestergaardTest, ApproachAndLoadAreTheSameContact)
{
  const SurfaceGrid g = periodic(40, 36, 2.0, 1.8);
  const std::vector<double> distance = wavy(g, 0.01, true);
  for (const double share : {1e-3, 0.1, 0.6, 0.95})
  {
    const Solution by_load = solved(g, 3.0, distance, {Drive::Kind::load, share * pi * 3.0 * 0.01 * 1.8}, 1e-13);
    const Solution by_approach = solved(g, 3.0, distance, {Drive::Kind::approach, by_load.report.approach}, 1e-13);
    expect_complementary(by_load, 1e-13);
    expect_complementary(by_approach, 1e-13);
    // Near full contact a little approach is a lot of load.
    EXPECT_NEAR(by_approach.load(g), by_load.load(g), 1e-6 * by_load.load(g)) << share;
  }
}

TEST(WestergaardTest, NoApproachBeyondFullContact)
{
  const SurfaceGrid g = periodic(24, 20, 2.0, 2.0);
  const std::vector<double> distance = wavy(g, 0.01, true); // 0.02 in the mean
  EXPECT_TRUE(solved(g, 3.0, distance, {Drive::Kind::approach, 0.02 - 1e-5}, 1e-9).report.converged);
  const Solution full = solved(g, 3.0, distance, {Drive::Kind::approach, 0.02}, 1e-9);
  EXPECT_TRUE(full.report.converged);
  try
  {
    (void)solved(g, 3.0, distance, {Drive::Kind::approach, 0.0201}, 1e-9);
    FAIL() << "accepted";
  }
  catch (const InputError& e)
  {
    EXPECT_NE(
        std::string(e.what()).find("approach = 0.0201 m; allowed: at most the mean distance of the surfaces, 0.02 m"),
        std::string::npos)
        << e.what();
  }
}

TEST(RowOfCellsTest, IsHertzsLineContact)
{
  // One row whose cells have copies along y: a roller of radius 1. a = sqrt(4 P R / (pi E')), p0 = 2 P / (pi a).
  constexpr double modulus = 2.0, load = 1e-3; // per length
  const double a = std::sqrt(4.0 * load / (pi * modulus)), peak = 2.0 * load / (pi * a);
  std::vector<double> errors;
  for (const int cells : {10, 20, 40}) // to the half-width
  {
    const int n = 4 * cells + 1;
    const SurfaceGrid g{n, 1, a / cells, 0.7, Boundary::open, Boundary::periodic};
    std::vector<double> distance;
    for (int i = 0; i < n; ++i)
      distance.push_back(0.5 * g.x(i) * g.x(i));
    const Solution s = solved(g, modulus, distance, {Drive::Kind::load, load * 0.7}, 1e-12 * a * a, 10.0);
    expect_complementary(s, 1e-12 * a * a);
    EXPECT_NEAR(share_in_contact(s) * n, 2.0 * cells, 2.0);
    double error = 0.0;
    for (int i = 0; i < n; ++i)
    {
      const double inside = 1.0 - std::pow(g.x(i) / a, 2);
      error +=
          std::abs(s.pressure[g.index(i, 0)] - (inside > 0.0 ? peak * std::sqrt(inside) : 0.0)) / (2.0 * cells * peak);
    }
    errors.push_back(error);
    // The approach, from the point that counts as zero: P / (pi E') (2 ln(2 d / a) + 1) with the reference d.
    EXPECT_NEAR(s.report.approach, load / (pi * modulus) * (2.0 * std::log(20.0 / a) + 1.0), 0.02 * s.report.approach);
  }
  EXPECT_GT(test::Orders("Hertz, line", errors).overall, 1.2);
  EXPECT_LT(errors.back(), 0.5 * std::pow(40.0, -1.5));
}

/// Waves of random phase with heights as k^-(1 + H), H = 0.8, of every length from the period to `shortest` cells; mean 0,
/// largest about 3.
std::vector<double> rough(const SurfaceGrid& g, int shortest, unsigned seed)
{
  const int most = std::max(1, std::min(g.nx, g.ny) / shortest);
  const std::vector<double> phase =
      test::random_field(static_cast<std::size_t>((2 * most + 1) * (most + 1)), seed, 0.0, 2.0 * pi);
  // Summed along x for every row of waves first: n^3.
  std::vector<double> height(g.size(), 0.0);
  double squares = 0.0;
  for (int ky = -most; ky <= most; ++ky)
  {
    std::vector<double> even(static_cast<std::size_t>(g.nx), 0.0), odd(even);
    for (int kx = 0; kx <= most; ++kx)
    {
      const double k = std::hypot(kx, ky);
      if (k < 1.0 || k > most)
        continue;
      const double wave = std::pow(k, -1.8), turn = phase[static_cast<std::size_t>((ky + most) * (most + 1) + kx)];
      squares += 0.5 * wave * wave;
      for (int i = 0; i < g.nx; ++i)
      {
        even[static_cast<std::size_t>(i)] += wave * std::cos(2.0 * pi * kx * i / g.nx + turn);
        odd[static_cast<std::size_t>(i)] += wave * std::sin(2.0 * pi * kx * i / g.nx + turn);
      }
    }
    for (int j = 0; j < g.ny; ++j)
      for (int i = 0; i < g.nx; ++i)
        height[g.index(i, j)] += even[static_cast<std::size_t>(i)] * std::cos(2.0 * pi * ky * j / g.ny) -
                                 odd[static_cast<std::size_t>(i)] * std::sin(2.0 * pi * ky * j / g.ny);
  }
  for (double& h : height)
    h /= std::sqrt(squares);
  return height;
}

/// Mean pressure that presses the valleys flat, of which a share then gives about any area [Pa]: E' = 1.
double flattening(const SurfaceGrid& g, const std::vector<double>& distance)
{
  const Solution s =
      solved(g, 1.0, distance, {Drive::Kind::load, 1e6 * g.cell_area() * static_cast<double>(g.size())}, 1e-6);
  const double mean = 1e6;
  return mean - *std::min_element(s.pressure.begin(), s.pressure.end());
}

TEST(RoughPeriodicTest, AHundredSurfacesFromTheFirstTouchToNearlyFullContact)
{
  std::vector<double> shares;
  int most = 0;
  for (unsigned seed = 1; seed <= 100; ++seed)
  {
    const bool is_open = seed % 4 == 0;
    const Boundary boundary = is_open ? Boundary::open : Boundary::periodic;
    const int n = seed % 3 == 0 ? 63 : 64;
    const SurfaceGrid g{n, 64, 1.0 / n, 1.0 / 64, boundary, boundary};
    const int shortest[] = {2, 4, 8, 16};
    const std::vector<double> distance = rough(g, shortest[seed % 5 % 4], seed);
    // The loads of the series are spread so that the first ones press a few cells and the last ones nearly all.
    const double full = flattening({n, 64, 1.0 / n, 1.0 / 64, Boundary::periodic, Boundary::periodic}, distance);
    const double load = full * std::pow(10.0, -4.0 + 3.95 * (seed - 1) / 99.0) * (is_open ? 0.3 : 1.0);
    const Solution s = solved(g, 1.0, distance, {Drive::Kind::load, load}, 1e-6);
    expect_complementary(s, 1e-6);
    EXPECT_NEAR(s.load(g), load, 1e-12 * load);
    most = std::max(most, s.report.iterations);
    shares.push_back(share_in_contact(s));
  }
  EXPECT_LT(*std::min_element(shares.begin(), shares.end()), 0.005);
  EXPECT_GT(*std::max_element(shares.begin(), shares.end()), 0.98);
  EXPECT_LE(most, 60);
}

TEST(RoughPeriodicTest, UnitsDoNotMatter)
{
  // Lengths in micrometres, moduli in nanopascals: the same steps, and the same answer but for rounding.
  constexpr double length = 1e-6, stiffness = 1e9;
  const SurfaceGrid g = periodic(64, 60, 1.0, 1.0), small = periodic(64, 60, length, length);
  const std::vector<double> distance = rough(g, 4, 7);
  std::vector<double> scaled = distance;
  for (double& d : scaled)
    d *= length;
  for (const Drive::Kind kind : {Drive::Kind::load, Drive::Kind::approach})
  {
    const bool is_load = kind == Drive::Kind::load;
    const Drive drive{kind, is_load ? 1.0 : -0.5};
    const Drive scaled_drive{kind, drive.value * (is_load ? stiffness * length * length : length)};
    const Solution a = solved(g, 1.0, distance, drive, 1e-9);
    const Solution b = solved(small, stiffness, scaled, scaled_drive, 1e-9 * length);
    EXPECT_TRUE(a.report.converged && b.report.converged);
    EXPECT_EQ(a.report.iterations, b.report.iterations);
    EXPECT_NEAR(b.report.approach / length, a.report.approach, 1e-10 * std::abs(a.report.approach));
    const double largest = *std::max_element(a.pressure.begin(), a.pressure.end());
    for (std::size_t i = 0; i < g.size(); ++i)
      ASSERT_NEAR(b.pressure[i] / stiffness, a.pressure[i], 1e-10 * largest);
  }
}

} // namespace
} // namespace brinell::contact::periodic_contact_test
