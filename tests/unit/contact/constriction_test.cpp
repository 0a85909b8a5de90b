// SPDX-License-Identifier: BSD-3-Clause
// Resistance of a contact against closed forms.
#include "brinell/contact/constriction.hpp"

#include "brinell/contact/elastic_contact.hpp"
#include "contact_areas.hpp"
#include "foundation/sharing.hpp"
#include "order.hpp"
#include "random_field.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <vector>

namespace brinell::contact::constriction_test
{
namespace
{

using areas::area, areas::Area, areas::in_discs, areas::infinite, areas::Inside, areas::modulus;

constexpr double pi = std::numbers::pi;

Flow flow(const Area& a, double spreading, std::vector<double> film = {})
{
  const halfspace::SurfaceCompliance compliance(a.grid, modulus);
  return Constriction(compliance, modulus).flow({a.pressure, a.gap}, spreading, film);
}

/// An elastic contact.
struct Pressed
{
  halfspace::SurfaceCompliance compliance;
  std::vector<double> pressure, gap;
};

Pressed pressed(const SurfaceGrid& grid, const std::function<double(double x, double y)>& distance, double approach)
{
  Pressed p{.compliance = halfspace::SurfaceCompliance(grid, modulus),
            .pressure = std::vector<double>(grid.size()),
            .gap = std::vector<double>(grid.size())};
  std::vector<double> undeformed(grid.size());
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i)
      undeformed[grid.index(i, j)] = distance(grid.x(i), grid.y(j));
  const Report report =
      ElasticContact(p.compliance)
          .solve(undeformed, {Drive::Kind::approach, approach}, 1e-9 * approach, 1000, p.pressure, p.gap);
  EXPECT_TRUE(report.converged);
  return p;
}

TEST(Constriction, OfABallIsThatOfACircle)
{
  // Holm: two bodies of resistivity rho each have rho/(2 a), with a of Hertz's contact; its edge is known from pressure and gap.
  constexpr double a = 1e-3, resistivity = 3e-8;
  std::vector<double> errors;
  for (const int cells : {4, 8, 16, 32})
  {
    double worst = 0.0;
    for (const double off : {0.0, 0.3, 0.5}) // of the middle of a cell
    {
      const double cell = a / (cells + 0.31), offset = off * cell;
      const int n = 2 * cells + 8;
      const Pressed ball = pressed(
          {n, n, cell, cell}, [&](double x, double y) { return 0.5 * (std::pow(x - offset, 2) + y * y); }, a * a);
      const Flow found = Constriction(ball.compliance, modulus).flow({ball.pressure, ball.gap}, 2.0 * resistivity, {});
      worst = std::max(worst, std::abs(found.conductance * resistivity / (2.0 * a) - 1.0));
    }
    errors.push_back(worst);
  }
  EXPECT_GT(test::Orders("conductance of a ball, cells halved", errors).overall, 1.5);
  EXPECT_LT(errors[0], 0.015);
  EXPECT_LT(errors[1], 4e-3);
  EXPECT_LT(errors.back(), 5e-4);
}

TEST(Constriction, OfEllipses)
{
  // rho K(e)/(2 pi a) of one body. Only the cells are known, so the area is right by chance to a fraction of a cell: mean over
  // several positions.
  for (const double ratio : {1.0, 2.0, 5.0, 10.0})
  {
    std::vector<double> errors;
    for (const int cells : {4, 8, 16})
    {
      double sum = 0.0;
      const double cell = 1.0 / cells;
      constexpr int positions = 4;
      for (int m = 0; m < positions; ++m)
        for (int n = 0; n < positions; ++n)
          sum += flow(area(
                          2 * static_cast<int>(ratio * (cells + 1)) + 4, 2 * cells + 6, cell,
                          [&](double x, double y) { return std::pow(x / ratio, 2) + y * y < 1.0; },
                          (m + 0.5) / positions * cell, (n + 0.5) / positions * cell),
                      1.0)
                     .conductance;
      const double exact = 2.0 * pi * ratio / std::comp_ellint_1(std::sqrt(1.0 - 1.0 / (ratio * ratio)));
      errors.push_back(sum / (positions * positions * exact) - 1.0);
    }
    EXPECT_LT(std::abs(errors[1]), 4e-3) << ratio;
    EXPECT_LT(std::abs(errors[2]), 2e-3) << ratio;
  }
}

TEST(Constriction, OfASquareConvergesToItsCapacitance)
{
  // At edges along the cells, and corners, the correction is not complete: first order.
  std::vector<double> errors;
  for (const int n : {8, 16, 32, 64})
    errors.push_back(
        flow(area(n + 2, n + 2, 1.0 / n, [](double x, double y) { return std::max(std::abs(x), std::abs(y)) < 0.5; }),
             1.0)
                .conductance *
            0.43391 -
        1.0);
  EXPECT_GT(test::Orders("conductance of a square, cells halved", errors).last, 0.85);
  EXPECT_LT(std::abs(2.0 * errors[3] - errors[2]), 1e-3); // extrapolated
}

TEST(Constriction, OfStripsInAPeriod)
{
  // Half-width a every L: the conductance per area is pi/(S L ln(1/sin(pi a/L))), by Barber's analogy from Westergaard's waves.
  for (const int pressed_cells : {2, 8, 14}) // of 16
  {
    std::vector<double> errors;
    for (const int finer : {1, 2, 4})
    {
      constexpr double length = 2.0;
      const int n = 16 * finer;
      Area strips{.grid = {n, 2, length / n, 0.3, Boundary::periodic, Boundary::periodic}, .pressure = {}, .gap = {}};
      for (int j = 0; j < 2; ++j)
        for (int i = 0; i < n; ++i)
        {
          strips.pressure.push_back(i < pressed_cells * finer ? 1.0 : 0.0);
          strips.gap.push_back(i < pressed_cells * finer ? 0.0 : infinite);
        }
      const double exact = pi / (length * -std::log(std::sin(pi * pressed_cells / 32.0)));
      errors.push_back(flow(strips, 1.0).conductance / (length * 0.6) / exact - 1.0);
    }
    EXPECT_GT(test::Orders("conductance of strips, cells halved", errors).overall, 1.4) << pressed_cells;
    EXPECT_LT(std::abs(errors.back()), 6e-3) << pressed_cells;
  }
}

TEST(Constriction, OfSeveralSpots)
{
  constexpr int cells = 16;
  const double one = flow(area(2 * cells + 6, 2 * cells + 6, 1.0 / cells, in_discs({{0.0, 0.0}})), 1.0).conductance;
  // Boundary elements: R/R_1 of two discs.
  for (const auto& [distance, expected] :
       std::vector<std::array<double, 2>>{{2.5, 0.6308}, {3.0, 0.6084}, {4.0, 0.5807}, {6.0, 0.5534}})
  {
    const Flow two = flow(area(2 * static_cast<int>((0.5 * distance + 1.2) * cells), 2 * cells + 6, 1.0 / cells,
                               in_discs({{-0.5 * distance, 0.0}, {0.5 * distance, 0.0}})),
                          1.0);
    EXPECT_NEAR(one / two.conductance, expected, 2e-3) << distance;
    EXPECT_EQ(two.of_patch.size(), 2U);
    EXPECT_NEAR(two.of_patch[0] / two.conductance, 0.5, 1e-3);
  }
  // Seven, in the middle and around it: in units of that of one; boundary elements, and Greenwood (1966), 1/(4 n a) + sum 1/s/(2 pi n^2), 0.28979.
  std::vector<std::array<double, 2>> middles{{0.0, 0.0}};
  for (int n = 0; n < 6; ++n)
    middles.push_back({3.0 * std::cos(pi * n / 3), 3.0 * std::sin(pi * n / 3)});
  const Flow seven = flow(area(9 * cells, 9 * cells, 1.0 / cells, in_discs(middles)), 1.0);
  EXPECT_NEAR(4.0 / seven.conductance, 0.2897, 1e-3);
  EXPECT_LT(seven.of_patch[3], seven.of_patch[0]); // the middle one, in the order of cells, is screened by the others
}

TEST(Constriction, OfOneSpotInAGrowingPeriod)
{
  // (rho/4a)(1 - c a/L), with c from the sum over the lattice: 2/pi times 3.900265 (square lattice of charges in a uniform
  // background).
  for (const double period : {8.0, 16.0, 32.0})
  {
    constexpr int cells = 8;
    Area spot =
        area(static_cast<int>(period) * cells, static_cast<int>(period) * cells, 1.0 / cells, in_discs({{0.0, 0.0}}));
    const double alone = flow(spot, 1.0).conductance;
    spot.grid.boundary_x = spot.grid.boundary_y = Boundary::periodic;
    EXPECT_NEAR(alone / flow(spot, 1.0).conductance, 1.0 - 2.0 / pi * 3.900265 / period,
                0.5 / (period * period * period) + 2.5e-3)
        << period;
  }
}

TEST(Constriction, OfADiscWithAFilm)
{
  // R - sigma/A between one potential, 1/4, and uniform density, 8/(3 pi^2): boundary elements (the first 0.8 % high).
  constexpr int cells = 24;
  const Area disc = area(2 * cells + 6, 2 * cells + 6, 1.0 / cells, in_discs({{0.0, 0.0}}));
  const std::vector<std::array<double, 2>> expected{{0.0, 0.25},
                                                    {0.1, 0.2588},
                                                    {0.5, 0.2654},
                                                    {2.0, 0.2686},
                                                    {10.0, 0.2699},
                                                    {100.0, 0.2702},
                                                    {1e4, 8.0 / (3.0 * pi * pi)}};
  double before = 0.0;
  for (const auto& [film, spread] : expected)
  {
    const Flow found = flow(disc, 1.0, std::vector<double>(disc.grid.size(), film));
    const double cells_in = static_cast<double>(std::count(disc.pressure.begin(), disc.pressure.end(), 1.0));
    const double rest = 1.0 / found.conductance - film / (cells_in * disc.grid.cell_area());
    EXPECT_NEAR(rest, spread, 0.006 * spread + 1e-6 * film) << film;
    EXPECT_GT(rest, before);
    before = rest;
    for (const double j : film == 100.0 ? found.density : std::vector<double>())
    {
      EXPECT_TRUE(j == 0.0 || std::abs(j * pi / found.conductance - 1.0) < 0.01) << j * pi / found.conductance;
    }
  }
}

TEST(Constriction, OfABallWithABadFilmIsThatOfItsArea)
{
  // sigma/(pi a^2) + 8 S/(3 pi^2 a): the area is that between the cells, too.
  constexpr double a = 1e-3, spreading = 1e-7, film = 1e-9;
  const double exact = film / (pi * a * a) + 8.0 * spreading / (3.0 * pi * pi * a);
  for (const double cells : {6.1, 8.3, 8.6, 12.4})
  {
    const double cell = a / cells;
    const int n = 2 * static_cast<int>(cells) + 8;
    const Pressed ball = pressed(
        {n, n, cell, cell}, [](double x, double y) { return 0.5 * (x * x + y * y); }, a * a);
    const std::vector<double> films(ball.pressure.size(), film);
    const Flow found = Constriction(ball.compliance, modulus).flow({ball.pressure, ball.gap}, spreading, films);
    EXPECT_NEAR(found.conductance * exact, 1.0, 0.01) << cells;
  }
}

TEST(Constriction, IsTheSlopeOfTheLoadOfARoughSurface)
{
  // Barber (2003): the conductance is 2/(E' S) dP/d(approach), whatever the area. Between these loads many cells come into contact,
  // so that the slope is that of the true area, not that of its cells.
  const SurfaceGrid grid{128, 128, 1.5e-6, 1.5e-6};
  std::mt19937_64 generator(5);
  std::array<std::array<double, 4>, 24> waves;
  for (auto& wave : waves)
    wave = {test::uniform(generator, -3.0, 3.0), test::uniform(generator, -3.0, 3.0),
            test::uniform(generator, 0.0, 2.0 * pi), test::uniform(generator, 0.5, 1.0)};
  const auto distance = [&](double x, double y)
  {
    double h = (x * x + y * y) / 2e-2;
    for (const auto& [kx, ky, phase, height] : waves)
      h += 3e-9 * height * (1.0 + std::cos(2e5 * (kx * x + ky * y) + phase));
    return h;
  };
  constexpr double middle = 1.1e-7, step = 0.5e-8;
  const auto load = [&](double approach) { return sum(pressed(grid, distance, approach).pressure) * grid.cell_area(); };
  const double slope =
      (8.0 * (load(middle + step) - load(middle - step)) - load(middle + 2 * step) + load(middle - 2 * step)) /
      (12.0 * step);
  const Pressed rough = pressed(grid, distance, middle);
  const Flow found = Constriction(rough.compliance, modulus).flow({rough.pressure, rough.gap}, 1.0, {});
  EXPECT_GE(found.of_patch.size(), 3U);
  EXPECT_NEAR(found.conductance * modulus / (2.0 * slope), 1.0, 2e-3);
}

TEST(Constriction, WithoutContactAndInFullContact)
{
  Area all = area(8, 8, 1.0, [](double, double) { return true; });
  all.grid.boundary_x = all.grid.boundary_y = Boundary::periodic;
  EXPECT_EQ(flow(all, 1.0).conductance, infinite);
  EXPECT_NEAR(flow(all, 1.0, std::vector<double>(64, 0.5)).conductance, 128.0, 1e-6); // the film alone
  const Flow none = flow(area(8, 8, 1.0, [](double, double) { return false; }), 1.0);
  EXPECT_EQ(none.conductance, 0.0);
  EXPECT_TRUE(none.of_patch.empty());
}

TEST(Constriction, OnAMirroredGridIsThatOfTheWhole)
{
  Area disc = area(20, 21, 1.0, [](double x, double y) { return std::hypot(x, y) < 7.3; });
  const Flow whole = flow(disc, 1.0, std::vector<double>(disc.grid.size(), 0.5));
  disc.grid.is_mirrored_y = true;
  const Flow mirrored = flow(disc, 1.0, std::vector<double>(disc.grid.size(), 0.5));
  EXPECT_NEAR(mirrored.conductance / whole.conductance, 1.0, 1e-9);
  for (std::size_t i = 0; i < whole.density.size(); ++i)
    EXPECT_NEAR(mirrored.density[i], whole.density[i], 1e-6);
}

} // namespace
} // namespace brinell::contact::constriction_test
