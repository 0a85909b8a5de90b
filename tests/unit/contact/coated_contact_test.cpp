// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/contact/elastic_contact.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace brinell::contact::coated_contact_test
{
namespace
{

constexpr double R = 1.0;
constexpr double rigid = std::numeric_limits<double>::infinity();
const ElasticStack stamp{{}, {rigid, 0.0}};

struct Pressed
{
  double load, peak, area;
};

/// A rigid sphere, or on a surface that is periodic along y with one row a rigid cylinder, on a body.
Pressed pressed(const SurfaceGrid& grid, const ElasticStack& body, const Drive& drive, double reference = 0.0)
{
  const halfspace::SurfaceCompliance compliance(grid, body, stamp, reference);
  std::vector<double> distance(grid.size()), pressure(grid.size()), gap(grid.size());
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i)
      distance[grid.index(i, j)] =
          (grid.x(i) * grid.x(i) + (grid.is_periodic_y() ? 0.0 : grid.y(j) * grid.y(j))) / (2.0 * R);
  ElasticContact solver(compliance);
  const Report report = solver.solve(distance, drive, 1e-8, 500, pressure, gap);
  EXPECT_TRUE(report.converged);
  Pressed result{0.0, *std::max_element(pressure.begin(), pressure.end()), 0.0};
  for (const double p : pressure)
  {
    result.load += p * grid.cell_area();
    result.area += p > 0.0 ? grid.cell_area() : 0.0;
  }
  return result;
}

/// Peak pressure of Hertz (Johnson 1985, Eqs. 4.22 to 4.24).
double hertz_peak(double load, const Elastic& body)
{
  const double modulus = 1.0 / body.contact_compliance();
  return std::cbrt(6.0 * load * modulus * modulus / (std::pow(std::numbers::pi, 3) * R * R));
}

constexpr Elastic coat{3.0, 0.25}, base{1.0, 0.3};
constexpr double load = 1e-3; // contact radius near 0.085
constexpr Drive by_load{Drive::Kind::load, load};

TEST(CoatedContactTest, ThickAndThinCoatingsAreHertzOfTheOneAndTheOther)
{
  const SurfaceGrid grid{49, 49, 0.005, 0.005};
  const auto peak = [&](double thickness) { return pressed(grid, {{{thickness, coat}}, base}, by_load).peak; };
  // The cells leave 1 % of the peak of a contact of 14 to 18 cells in radius, and the layer a share of radius over thickness
  // or the other way round: here 0.1 / 20 and 1.5e-3 / 0.1.
  EXPECT_NEAR(peak(20.0) / hertz_peak(load, coat), 1.0, 0.02);
  EXPECT_NEAR(peak(1.5e-3) / hertz_peak(load, base), 1.0, 0.04);
  // Between the limits the peak rises with the thickness of a stiffer coating.
  const double a = peak(0.02), b = peak(0.05), c = peak(0.2);
  EXPECT_LT(hertz_peak(load, base), a);
  EXPECT_LT(a, b);
  EXPECT_LT(b, c);
  EXPECT_LT(c, 1.01 * hertz_peak(load, coat));
}

TEST(CoatedContactTest, CoatingOfTheSameMaterialChangesNothing)
{
  const SurfaceGrid grid{33, 33, 0.01, 0.01};
  const Pressed plain = pressed(grid, {{}, base}, by_load);
  const Pressed coated = pressed(grid, {{{0.05, base}, {0.02, base}}, base}, by_load);
  EXPECT_NEAR(coated.peak / plain.peak, 1.0, 1e-7);
  EXPECT_EQ(coated.area, plain.area);
}

/// A compressible layer much thinner than the contact is a bed of springs with the modulus M = (1 - nu) E / ((1 + nu)(1 - 2 nu)):
/// p = M (delta - r^2 / 2R) / h (Johnson 1985, section 5.8).
TEST(CoatedContactTest, ThinLayerOnARigidBaseIsABedOfSprings)
{
  const double h = 0.01, delta = 0.005, nu = 0.2, E = 2.0; // contact radius 0.1
  const double M = (1.0 - nu) * E / ((1.0 + nu) * (1.0 - 2.0 * nu));
  const ElasticStack bed{{{h, {E, nu}}}, {rigid, 0.0}};
  const SurfaceGrid grid{65, 65, 0.004, 0.004};
  const Pressed sphere = pressed(grid, bed, {Drive::Kind::approach, delta});
  // The next order in thickness over radius, h / a = 0.1, times its square root at the edge: 5 %.
  EXPECT_NEAR(sphere.load / (std::numbers::pi * M * R * delta * delta / h), 1.0, 0.05);
  EXPECT_NEAR(sphere.peak / (M * delta / h), 1.0, 0.03);
  const SurfaceGrid line{65, 1, 0.004, 0.1, Boundary::open, Boundary::periodic};
  const Pressed cylinder = pressed(line, bed, {Drive::Kind::approach, delta}, 1.0);
  const double a = std::sqrt(2.0 * R * delta);
  EXPECT_NEAR(cylinder.load / (2.0 / 3.0 * M * a * a * a / (R * h) * 0.1), 1.0, 0.05);
}

TEST(CoatedContactTest, ResultDoesNotDependOnTheSizeOfTheGrid)
{
  for (const ElasticStack& body : {ElasticStack{{{0.05, coat}}, base}, ElasticStack{{{0.05, base}}, coat}})
  {
    const Pressed small = pressed({31, 31, 0.01, 0.01}, body, by_load);
    const Pressed wide = pressed({93, 93, 0.01, 0.01}, body, by_load);
    EXPECT_NEAR(small.peak / wide.peak, 1.0, 1e-4);
    EXPECT_EQ(small.area, wide.area);
  }
}

} // namespace
} // namespace brinell::contact::coated_contact_test
