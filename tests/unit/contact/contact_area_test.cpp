// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/contact/contact_area.hpp"

#include "brinell/contact/elastic_contact.hpp"
#include "brinell/reference/hertz.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

namespace brinell::contact::contact_area_test
{
namespace
{

constexpr double pi = std::numbers::pi;

using Surface = std::function<double(double x, double y)>;

/// A contact with E' = 1 around the middle of the grid.
struct Solved
{
  std::vector<double> pressure, gap;
};

Solved solved(const SurfaceGrid& grid, const Surface& distance, double load)
{
  const halfspace::SurfaceCompliance compliance(grid, 1.0);
  ElasticContact contact(compliance);
  Solved s{std::vector<double>(grid.size(), 0.0), std::vector<double>(grid.size())};
  std::vector<double> d(grid.size());
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i)
      d[grid.index(i, j)] = distance((i - 0.5 * (grid.nx - 1)) * grid.dx, (j - 0.5 * (grid.ny - 1)) * grid.dy);
  const Report report = contact.solve(d, {Drive::Kind::load, load}, 1e-10, 5000, s.pressure, s.gap);
  EXPECT_TRUE(report.converged);
  return s;
}

double area(const SurfaceGrid& grid, const Solved& s)
{
  return contact_area(grid, s.pressure, s.gap, 1.0);
}

double counted(const SurfaceGrid& grid, const Solved& s)
{
  return grid.cell_area() *
         static_cast<double>(std::count_if(s.pressure.begin(), s.pressure.end(), [](double p) { return p > 0.0; }));
}

/// Root mean square of the errors of the estimate, its scatter about their mean, and the error of counting cells.
struct Errors
{
  double rms = 0.0, spread = 0.0, counting = 0.0;
};

/// Contacts of about n cells to the radius, their middle anywhere between the cells.
/// @param shape  distance at (x, y) for a contact of radius a
/// @param load   and exact area for that radius
Errors errors_at(double n, const std::function<double(double x, double y, double a)>& shape,
                 const std::function<double(double a)>& load, const std::function<double(double a)>& exact)
{
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> anywhere(-0.5, 0.5);
  const int half = static_cast<int>(1.3 * n + 3.0);
  const SurfaceGrid grid{2 * half + 1, 2 * half + 1, 1.0, 1.0};
  const int count = n > 10.0 ? 8 : 20;
  double sum = 0.0, squares = 0.0, counting = 0.0;
  for (int k = 0; k < count; ++k)
  {
    const double a = n + anywhere(generator);
    const double x0 = anywhere(generator), y0 = anywhere(generator);
    const Solved s = solved(
        grid, [&](double x, double y) { return shape(x - x0, y - y0, a); }, load(a));
    const double error = area(grid, s) / exact(a) - 1.0;
    sum += error;
    squares += error * error;
    counting += std::pow(counted(grid, s) / exact(a) - 1.0, 2);
  }
  const double mean = sum / count;
  return {std::sqrt(squares / count), std::sqrt(std::max(0.0, squares / count - mean * mean)),
          std::sqrt(counting / count)};
}

constexpr double R = 1e3; ///< so that the slopes are small

void expect_order(const std::function<Errors(double)>& errors)
{
  // Both the chords of the line and the cells at the edge are of the order of (cell/radius)^1.5 at least, where counting cells is
  // of first order in its mean.
  std::vector<Errors> found;
  for (const double n : {3.0, 6.0, 12.0, 24.0})
  {
    const Errors e = found.emplace_back(errors(n));
    EXPECT_LT(e.rms, 0.15 * std::pow(n, -1.5)) << n << " cells to the radius";
    EXPECT_LT(e.spread, 0.1 * std::pow(n, -1.5)) << n << " cells to the radius";
    EXPECT_LT(e.rms, 0.25 * e.counting) << n << " cells to the radius";
  }
  EXPECT_GT(std::log(found.front().rms / found.back().rms) / std::log(8.0), 1.1);
  EXPECT_GT(std::log(found.front().spread / found.back().spread) / std::log(8.0), 1.4);
}

TEST(ContactArea, ABallsIsHertz)
{
  expect_order(
      [](double n)
      {
        return errors_at(
            n, [](double x, double y, double) { return (x * x + y * y) / (2.0 * R); },
            [](double a) { return 4.0 / 3.0 * a * a * a / R; }, [](double a) { return pi * a * a; });
      });
}

TEST(ContactArea, AConesIsSneddons)
{
  expect_order(
      [](double n)
      {
        return errors_at(
            n, [](double x, double y, double) { return 1e-3 * std::hypot(x, y); },
            [](double a) { return 0.5 * pi * a * a * 1e-3; }, [](double a) { return pi * a * a; });
      });
}

TEST(ContactArea, AnEllipsoidsIsHertz)
{
  // Turned by 30 degrees; the short half axis has about 0.6 n cells.
  const double c = std::cos(pi / 6.0), s = std::sin(pi / 6.0);
  const auto at = [](double a)
  { return reference::elliptical_contact_at_load(R, 0.5 * R, 1.0, 4.0 / 3.0 * a * a * a / R); };
  for (const double n : {5.0, 10.0, 20.0})
  {
    const Errors e = errors_at(
        n,
        [&](double x, double y, double)
        {
          const double u = c * x + s * y, v = c * y - s * x;
          return u * u / (2.0 * R) + v * v / R;
        },
        [](double a) { return 4.0 / 3.0 * a * a * a / R; },
        [&](double a) { return pi * at(a).semi_axis_x * at(a).semi_axis_y; });
    EXPECT_LT(e.rms, 0.15 * std::pow(0.6 * n, -1.5)) << n;
    EXPECT_LT(e.rms, 0.25 * e.counting) << n;
  }
}

TEST(ContactArea, TwoContactsAreTwice)
{
  const SurfaceGrid grid{81, 25, 1.0, 1.0};
  const double a = 5.3;
  const Solved s = solved(
      grid, [](double x, double y) { return (std::pow(std::abs(x) - 25.2, 2) + y * y) / (2.0 * R); },
      2.0 * 4.0 / 3.0 * a * a * a / R);
  // The other one's displacement bends the surface by (a/distance)^3 of the ball's curvature: 0.1 %.
  EXPECT_NEAR(area(grid, s) / (2.0 * pi * a * a), 1.0, 0.15 * std::pow(a, -1.5) + 2e-3);
}

TEST(ContactArea, GrowsSmoothlyFromNothing)
{
  // From a fraction of a cell to some: the area neither jumps nor falls where a cell comes into contact.
  const SurfaceGrid grid{13, 13, 1.0, 1.0};
  double before = 0.0;
  for (double a = 0.2; a < 4.0; a += 0.02)
  {
    const Solved s = solved(
        grid, [](double x, double y) { return (std::pow(x - 0.13, 2) + std::pow(y - 0.31, 2)) / (2.0 * R); },
        4.0 / 3.0 * a * a * a / R);
    const double now = area(grid, s);
    EXPECT_GE(now, before - 1e-6) << a;
    EXPECT_LT(now - before, 0.4 + 0.05 * a) << a; // exact growth: 2 pi a 0.02 = 0.13 a
    before = now;
  }
}

TEST(ContactArea, StraightEdgeIsExact)
{
  // p = K sqrt(s) inside and gap = 4 K s^1.5 / (3 E') outside, s the distance from the edge: along the axes there is no error but
  // rounding, wherever the edge lies.
  const SurfaceGrid grid{12, 5, 0.3, 0.7};
  for (const double width : {1.0, 1.13, 1.2, 1.37})
  {
    Solved s{std::vector<double>(grid.size()), std::vector<double>(grid.size())};
    for (int j = 0; j < grid.ny; ++j)
      for (int i = 0; i < grid.nx; ++i)
      {
        const double inside = width - std::abs((i - 5.5) * grid.dx);
        s.pressure[grid.index(i, j)] = 1e-3 * std::sqrt(std::max(0.0, inside));
        s.gap[grid.index(i, j)] = 4e-3 / 3.0 * std::pow(std::max(0.0, -inside), 1.5);
      }
    // Along y the strip reaches the ends of the grid.
    EXPECT_NEAR(area(grid, s) / (2.0 * width * grid.ny * grid.dy), 1.0, 1e-9) << width;
  }
}

TEST(ContactArea, APunchesEdgeIsThatOfItsCells)
{
  const SurfaceGrid grid{15, 13, 1.0, 2.0};
  const Solved s = solved(
      grid, [](double x, double y) { return std::abs(x) < 4.5 && std::abs(y) < 7.0 ? 0.0 : 10.0; }, 1e-3);
  EXPECT_NEAR(area(grid, s), 9.0 * 14.0, 1e-9);
}

TEST(ContactArea, RoughSurfacesNeedFewerCells)
{
  // Waves of one length and random phase: small and large patches. The same surface on cells of a quarter is the reference.
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> any(0.0, 2.0 * pi);
  struct Wave
  {
    double kx, ky, phase;
  };
  std::vector<Wave> waves;
  for (int i = 0; i < 12; ++i)
  {
    const double angle = any(generator);
    waves.push_back({2.0 * pi / 9.0 * std::cos(angle), 2.0 * pi / 9.0 * std::sin(angle), any(generator)});
  }
  const auto rough = [&](double x, double y)
  {
    double h = 0.0;
    for (const Wave& w : waves)
      h += 1e-3 * std::cos(w.kx * x + w.ky * y + w.phase);
    return h;
  };
  const SurfaceGrid coarse{40, 40, 1.0, 1.0};
  const SurfaceGrid fine{160, 160, 0.25, 0.25};
  for (const double load : {0.05, 0.2})
  {
    const Solved on_coarse = solved(coarse, rough, load);
    const Solved on_fine = solved(fine, rough, load);
    const double reference = area(fine, on_fine);
    const double estimate = area(coarse, on_coarse) / reference - 1.0;
    const double cells = counted(coarse, on_coarse) / reference - 1.0;
    // Chords across patches of two or three cells lack some percent.
    EXPECT_LT(std::abs(estimate), 0.35 * std::abs(cells)) << estimate << " against " << cells;
  }
}

TEST(ContactArea, EdgeLiesWhereGapAndPressureMeet)
{
  for (double ratio = 1e-9; ratio < 1e9; ratio *= 1.7)
  {
    const double t = edge_position(ratio), square = ratio * ratio;
    ASSERT_TRUE(t >= 0.0 && t <= 1.0) << ratio;
    // The residual of the equation, over its slope: how far t is from the root.
    const double residual = std::pow(1.0 - t, 3) - square * t, slope = 3.0 * (1.0 - t) * (1.0 - t) + square;
    EXPECT_LT(std::abs(residual / slope), 4e-16) << ratio;
  }
  EXPECT_EQ(edge_position(0.0), 1.0);
  EXPECT_EQ(edge_position(1e200), 0.0);
  EXPECT_EQ(edge_position(std::numeric_limits<double>::infinity()), 0.5);
}

TEST(ContactArea, NoPressureIsNoContact)
{
  const SurfaceGrid grid{3, 2, 1.0, 1.0};
  EXPECT_EQ(contact_area(grid, std::vector<double>(6, 0.0), std::vector<double>(6, 0.0), 1.0), 0.0);
  EXPECT_EQ(contact_area(grid, std::vector<double>(6, 1.0), std::vector<double>(6, 0.0), 1.0), 6.0);
}

} // namespace
} // namespace brinell::contact::contact_area_test
