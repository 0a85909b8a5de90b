// SPDX-License-Identifier: BSD-3-Clause
// Resistance of a circular contact on plated conductors against an integral equation.
#include "brinell/contact/constriction.hpp"

#include "brinell/contact/elastic_contact.hpp"
#include "gauss.hpp"
#include "random_field.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>
#include <vector>

namespace brinell::contact::coated_constriction_test
{
namespace
{

using halfspace::SurfaceCompliance;
using std::numbers::pi;

constexpr double modulus = 1e11;

/// Resistance of an equipotential disc of unit radius on a layer [ohm]. The layer reflects the potential of a point again and
/// again, which is a series of images with the ratio g. With j as the transform of f(t) cos(kt), the potential is uniform on the
/// disc if f(s) + 2/pi integral_0^1 f(t) M(s, t) dt = 1, as in Love's (1949) problem of two discs.
double resistance_of_disc(double layer, double substrate, double thickness)
{
  const double g = (substrate - layer) / (substrate + layer);
  const auto images = [&](double u) // integral of 2 sum g^n e^{-2nkh} cos(ku) over k
  {
    double sum = 0.0, power = g;
    for (int n = 1; std::abs(power) > 1e-17; ++n, power *= g)
      sum += power * 2.0 * n * thickness / (std::pow(2.0 * n * thickness, 2) + u * u);
    return 2.0 * sum;
  };
  const int panels = 4 + static_cast<int>(2.0 / thickness);
  std::vector<double> point, weight;
  for (int p = 0; p < panels; ++p)
  {
    const test::Gauss rule(6, static_cast<double>(p) / panels, static_cast<double>(p + 1) / panels);
    point.insert(point.end(), rule.point.begin(), rule.point.end());
    weight.insert(weight.end(), rule.weight.begin(), rule.weight.end());
  }
  const std::size_t n = point.size();
  std::vector<double> matrix(n * n), f(n, 1.0);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j)
      matrix[n * i + j] =
          (i == j ? 1.0 : 0.0) + weight[j] / pi * (images(point[i] - point[j]) + images(point[i] + point[j]));
  for (std::size_t c = 0; c < n; ++c) // elimination; the matrix is that of a definite operator
    for (std::size_t i = c + 1; i < n; ++i)
    {
      const double factor = matrix[n * i + c] / matrix[n * c + c];
      for (std::size_t j = c; j < n; ++j)
        matrix[n * i + j] -= factor * matrix[n * c + j];
      f[i] -= factor * f[c];
    }
  for (std::size_t i = n; i-- > 0;)
  {
    for (std::size_t j = i + 1; j < n; ++j)
      f[i] -= matrix[n * i + j] * f[j];
    f[i] /= matrix[n * i + i];
  }
  return layer / (4.0 * std::inner_product(f.begin(), f.end(), weight.begin(), 0.0));
}

/// A ball in Hertzian contact over a circle of unit radius.
struct Ball
{
  SurfaceGrid grid;
  std::vector<double> pressure, gap;

  explicit Ball(int cells) : Ball(2 * cells + 8, 1.0 / (cells + 0.31)) {}
  Ball(int n, double cell) : grid{n, n, cell, cell}, pressure(grid.size()), gap(grid.size())
  {
    std::vector<double> undeformed(grid.size());
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i)
        undeformed[grid.index(i, j)] = 0.5 * (std::pow(grid.x(i), 2) + std::pow(grid.y(j), 2));
    const SurfaceCompliance compliance(grid, modulus);
    EXPECT_TRUE(ElasticContact(compliance)
                    .solve(undeformed, {Drive::Kind::approach, 1.0}, 1e-9, 1000, pressure, gap)
                    .converged);
  }
};

double resistance(const Ball& ball, const ConductiveStack& lower, const ConductiveStack& upper,
                  const std::vector<double>& film = {})
{
  const SurfaceCompliance conductors = SurfaceCompliance::of_conductors(ball.grid, lower, upper);
  const double tops = lower.top() + upper.top();
  return 1.0 /
         Constriction::of_layers(conductors, tops, modulus).flow({ball.pressure, ball.gap}, tops, film).conductance;
}

/// Conducts so well that it adds a millionth to the resistance.
constexpr double best = 1e-6;

TEST(CoatedConstriction, OracleHasItsLimits)
{
  EXPECT_NEAR(resistance_of_disc(1.0, 1.0, 0.3), 0.25, 1e-12);
  EXPECT_NEAR(resistance_of_disc(3.0, 1.0, 200.0), 0.75, 3e-3); // the image at 400 radii
  // A thin layer that conducts badly is a resistance over an area that is wider by 2 ln 2/pi of its thickness, and gives the
  // substrate a uniform flux, with 8/(3 pi^2) of the mean potential; that of the rim is left out.
  const double thickness = 0.05, wider = 1.0 + 2.0 * std::log(2.0) / pi * thickness;
  EXPECT_NEAR(resistance_of_disc(100.0, 1.0, thickness),
              100.0 * thickness / (pi * wider * wider) + 8.0 / (3.0 * pi * pi), thickness * 8.0 / (3.0 * pi * pi));
}

TEST(CoatedConstriction, OfABallIsThatOfADisc)
{
  // The error is that of a disc on a homogeneous body with as many cells, and that of layers thinner than a cell, in which the
  // current fills less than a cell beyond the edge.
  for (const int cells : {8, 16})
  {
    const Ball ball(cells);
    for (const auto& [layer, thickness] :
         {std::pair{1.3, 0.05}, {1.3, 0.5}, {6.5, 0.05}, {6.5, 0.2}, {6.5, 1.0}, {0.2, 0.1}, {0.2, 1.0}, {50.0, 0.05}})
    {
      const double expected = resistance_of_disc(layer, 1.0, thickness);
      const double found = resistance(ball, {{{thickness, layer}}, 1.0}, {{}, best});
      const bool is_resolved = thickness * cells > 0.75;
      EXPECT_NEAR(found, expected, (is_resolved ? 5e-3 : 3e-2) * expected) << layer << ' ' << thickness << ' ' << cells;
    }
  }
}

TEST(CoatedConstriction, LayersOfOneMaterialAreTheHomogeneousBody)
{
  const Ball ball(8);
  const SurfaceCompliance compliance(ball.grid, modulus);
  const double plain = 1.0 / Constriction(compliance, modulus).flow({ball.pressure, ball.gap}, 3.0, {}).conductance;
  EXPECT_NEAR(resistance(ball, {{{0.1, 2.0}, {0.3, 2.0}}, 2.0}, {{}, 1.0}), plain, 1e-9 * plain);
  EXPECT_NEAR(resistance(ball, {{{0.1, 2.0 * (1.0 + 1e-9)}, {0.3, 2.0}}, 2.0}, {{}, 1.0}), plain, 1e-7 * plain);
  // Nor does it matter whether the layers are merged.
  EXPECT_NEAR(resistance(ball, {{{0.1, 5.0}, {0.3, 5.0}}, 2.0}, {{}, 1.0}),
              resistance(ball, {{{0.4, 5.0}}, 2.0}, {{}, 1.0}), 1e-9 * plain);
}

TEST(CoatedConstriction, AThinResistiveLayerIsAFilm)
{
  // Current flows through it straight but at the edge, on a width of its thickness.
  const Ball ball(16);
  for (const double thickness : {0.02, 0.04})
  {
    const std::vector<double> film(ball.grid.size(), 20.0 * thickness);
    const double as_film = resistance(ball, {{}, 1.0}, {{}, best}, film);
    EXPECT_NEAR(resistance(ball, {{{thickness, 20.0}}, 1.0}, {{}, best}), as_film, 2.0 * thickness * as_film);
  }
}

TEST(CoatedConstriction, EqualBodiesHaveTwiceTheResistance)
{
  const Ball ball(8);
  const ConductiveStack plated{{{0.1, 6.5}, {0.05, 4.0}}, 1.0};
  const double one = resistance(ball, plated, {{}, best}), both = resistance(ball, plated, plated);
  EXPECT_NEAR(both, 2.0 * one, 1e-5 * both);
}

TEST(CoatedConstriction, TheOperatorIsSymmetricAndPositive)
{
  for (const auto& [x, y] : {std::pair{Boundary::open, Boundary::open},
                             {Boundary::periodic, Boundary::open},
                             {Boundary::periodic, Boundary::periodic}})
  {
    const SurfaceGrid grid{12, 10, 0.2, 0.3, x, y};
    const ConductiveStack plated{{{0.4, 6.5}, {0.3, 0.4}}, 1.0};
    const SurfaceCompliance conductors = SurfaceCompliance::of_conductors(grid, plated, {{}, 2.0}, 10.0);
    const std::vector<double> a = test::random_field(grid.size(), 1), b = test::random_field(grid.size(), 2);
    std::vector<double> of_a(grid.size()), of_b(grid.size());
    conductors.apply({.pressure = a}, {.z = of_a});
    conductors.apply({.pressure = b}, {.z = of_b});
    const double aa = std::inner_product(a.begin(), a.end(), of_a.begin(), 0.0);
    EXPECT_GT(aa, 0.0);
    EXPECT_NEAR(std::inner_product(a.begin(), a.end(), of_b.begin(), 0.0),
                std::inner_product(b.begin(), b.end(), of_a.begin(), 0.0), 1e-12 * aa);
  }
}

} // namespace
} // namespace brinell::contact::coated_constriction_test
