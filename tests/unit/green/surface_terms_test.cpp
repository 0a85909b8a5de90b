// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/green/surface_terms.hpp"

#include "brinell/green/rectangle.hpp"
#include "brinell/green/strip.hpp"
#include "gauss.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace brinell::green::surface_terms_test
{
namespace
{

using std::numbers::pi;

/// The five functions of the distance.
SurfaceTerms functions(double x, double y)
{
  const double r2 = x * x + y * y, r3 = r2 * std::sqrt(r2);
  return {x * x / r3, y * y / r3, x * y / r3, x / r2, y / r2};
}

TEST(SurfaceTermsTest, AreTheIntegralsOverARectangle)
{
  const double dx = 1.0, dy = 0.6;
  const test::Gauss along_x(40, -0.5 * dx, 0.5 * dx), along_y(40, -0.5 * dy, 0.5 * dy);
  for (const auto& [x, y] : {std::pair{1.0, 0.0}, {0.0, -0.9}, {-1.3, 0.4}, {2.0, 7.0}})
  {
    SurfaceTerms sum{};
    for (std::size_t i = 0; i < along_x.point.size(); ++i)
      for (std::size_t j = 0; j < along_y.point.size(); ++j)
        for (std::size_t t = 0; t < sum.size(); ++t)
          sum[t] += along_x.weight[i] * along_y.weight[j] * functions(x - along_x.point[i], y - along_y.point[j])[t];
    const SurfaceTerms found = rectangle_surface_terms(x, y, dx, dy);
    for (std::size_t t = 0; t < sum.size(); ++t) // the rule is exact to rounding half a side away
      EXPECT_NEAR(found[t], sum[t], 1e-13) << "term " << t << " at " << x << ' ' << y;
  }
}

TEST(SurfaceTermsTest, AreTheIntegralsAroundAPointInside)
{
  // In polar form the functions of 1/r lose their singularity: integral of cos^2, sin^2, sin cos times the distance of the
  // edge; those of 1/r that are odd have logarithms of it instead. From corner to corner the integrands are smooth.
  const double dx = 1.0, dy = 0.6, x = 0.2, y = -0.1;
  const std::array<double, 5> corners{
      std::atan2(-0.5 * dy - y, -0.5 * dx - x) + 2.0 * pi, std::atan2(-0.5 * dy - y, 0.5 * dx - x) + 2.0 * pi,
      std::atan2(0.5 * dy - y, 0.5 * dx - x) + 2.0 * pi, std::atan2(0.5 * dy - y, -0.5 * dx - x) + 2.0 * pi,
      std::atan2(-0.5 * dy - y, -0.5 * dx - x) + 4.0 * pi};
  SurfaceTerms sum{};
  for (std::size_t side = 0; side < 4; ++side)
  {
    const test::Gauss rule(60, corners[side], corners[side + 1]);
    for (std::size_t n = 0; n < rule.point.size(); ++n)
    {
      const double c = std::cos(rule.point[n]), s = std::sin(rule.point[n]); // from the point to the load
      const std::array<double, 4> edge{(-0.5 * dy - y) / s, (0.5 * dx - x) / c, (0.5 * dy - y) / s,
                                       (-0.5 * dx - x) / c};
      const double distance = edge[side];
      const double w = rule.weight[n];
      // Integral of r dr of the functions at (-r c, -r s).
      sum[0] += w * c * c * distance;
      sum[1] += w * s * s * distance;
      sum[2] += w * c * s * distance;
      sum[3] -= w * c * distance;
      sum[4] -= w * s * distance;
    }
  }
  const SurfaceTerms found = rectangle_surface_terms(x, y, dx, dy);
  for (std::size_t t = 0; t < sum.size(); ++t)
    EXPECT_NEAR(found[t], sum[t], 1e-12) << "term " << t;
  EXPECT_NEAR(found[0] + found[1], rectangle_displacement(x, y, dx, dy), 1e-14);
}

TEST(SurfaceTermsTest, DisplacementAndStressOfAShearObeyHooke)
{
  // On the free surface sigma_xx = 2 mu/(1 - nu) (eps_xx + nu eps_yy) and sigma_xy = mu (u_x,y + u_y,x); central differences.
  const Elastic elastic{2.6, 0.28};
  const double nu = elastic.poisson_ratio, mu = elastic.shear_modulus(), x = 0.83, y = 0.47, h = 1e-4;
  const auto displacement = [&](double X, double Y)
  {
    const SurfaceTerms t = rectangle_surface_terms(X, Y, 1.0, 0.6);
    return std::pair{((1.0 - nu) * (t[0] + t[1]) + nu * t[0]) / (2.0 * pi * mu), nu * t[2] / (2.0 * pi * mu)};
  };
  const auto [east_x, east_y] = displacement(x + h, y);
  const auto [west_x, west_y] = displacement(x - h, y);
  const auto [north_x, north_y] = displacement(x, y + h);
  const auto [south_x, south_y] = displacement(x, y - h);
  const double e_xx = (east_x - west_x) / (2.0 * h), e_yy = (north_y - south_y) / (2.0 * h);
  const double gamma = (north_x - south_x + east_y - west_y) / (2.0 * h);
  const SymTensor stress = rectangle_stress(x, y, 0.0, 1.0, 0.6, nu, Traction::shear_x);
  EXPECT_NEAR(2.0 * mu / (1.0 - nu) * (e_xx + nu * e_yy), stress[0], 1e-7); // h^2 times third derivatives
  EXPECT_NEAR(2.0 * mu / (1.0 - nu) * (e_yy + nu * e_xx), stress[1], 1e-7);
  EXPECT_NEAR(mu * gamma, stress[5], 1e-7);
}

TEST(SurfaceTermsTest, StripIsALongRectangleButForConstants)
{
  const double dx = 0.4, length = 1e6;
  const auto difference = [&](double x)
  {
    SurfaceTerms t = rectangle_surface_terms(x, 0.0, dx, length);
    const SurfaceTerms right = strip_surface_edge(x + 0.5 * dx, 5.0), left = strip_surface_edge(x - 0.5 * dx, 5.0);
    for (std::size_t n = 0; n < t.size(); ++n)
      t[n] -= right[n] - left[n];
    return t;
  };
  const SurfaceTerms constant = difference(0.0);
  EXPECT_NEAR(constant[0], 2.0 * dx, 1e-5 * dx);
  for (const double x : {0.1, 0.2, 0.9, 7.0}) // a finite length leaves 4 x / length; rounding of logarithms
    for (std::size_t t = 0; t < constant.size(); ++t)
      EXPECT_NEAR(difference(x)[t], t < 2 ? constant[t] : 0.0, (1e-5 + 5.0 * x / length) * dx) << "term " << t;
}

TEST(SurfaceTermsTest, ConstantsOfAPair)
{
  const Elastic steel{210e9, 0.3}, polymer{3e9, 0.4};
  const PairConstants pair = pair_constants(steel, polymer), exchanged = pair_constants(polymer, steel);
  EXPECT_NEAR(pair.normal * pi * contact_modulus(steel, polymer), 1.0, 1e-15);
  EXPECT_NEAR(pair.coupling / exchanged.coupling, -1.0, 1e-15);
  EXPECT_LT(pair.coupling, 0.0);
  EXPECT_EQ(pair_constants(steel, steel).coupling, 0.0);
}

} // namespace
} // namespace brinell::green::surface_terms_test
