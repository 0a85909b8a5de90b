// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/green/rectangle.hpp"
#include "brinell/green/strip.hpp"

#include "gauss.hpp"
#include "point_force.hpp"
#include "tensors.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace brinell::green::shear_test
{
namespace
{

using std::numbers::pi;
constexpr double epsilon = std::numeric_limits<double>::epsilon();
constexpr double rounding = 16.0 * epsilon; // a few operations in each of four corner terms of order one

TEST(ShearedRectangleTest, StressIsTheIntegralOfPointForces)
{
  const double dx = 1.0, dy = 0.6, nu = 0.28;
  const test::Gauss along_x(40, -0.5 * dx, 0.5 * dx), along_y(40, -0.5 * dy, 0.5 * dy);
  for (const auto& [x, y, z] : {std::array{0.1, -0.05, 0.4}, {0.5, 0.3, 0.5}, {-0.9, 0.2, 0.3}, {2.0, 1.0, 0.05}})
  {
    SymTensor sum{};
    for (std::size_t i = 0; i < along_x.point.size(); ++i)
      for (std::size_t j = 0; j < along_y.point.size(); ++j)
      {
        const SymTensor part = test::point_force_along_x(x - along_x.point[i], y - along_y.point[j], z, nu);
        for (std::size_t c = 0; c < 6; ++c)
          sum[c] += along_x.weight[i] * along_y.weight[j] * part[c];
      }
    const SymTensor found = rectangle_stress(x, y, z, dx, dy, nu, Traction::shear_x);
    for (std::size_t c = 0; c < 6; ++c) // 40 points: below 1e-13 where the depth is half the sides
      EXPECT_NEAR(found[c], sum[c], 1e-12) << "component " << c << " at " << x << ' ' << y << ' ' << z;
  }
}

TEST(ShearedRectangleTest, AlongYIsAlongXWithTheAxesExchanged)
{
  const SymTensor along_y = rectangle_stress(0.3, -0.8, 0.4, 1.0, 0.7, 0.3, Traction::shear_y);
  const SymTensor along_x = rectangle_stress(-0.8, 0.3, 0.4, 0.7, 1.0, 0.3, Traction::shear_x);
  constexpr std::array<std::size_t, 6> other{1, 0, 2, 4, 3, 5};
  for (std::size_t c = 0; c < 6; ++c)
    EXPECT_NEAR(along_y[c], along_x[other[c]], rounding) << "component " << c;
}

TEST(ShearedRectangleTest, SurfaceIsLoadedByTheUnitShearOnly)
{
  for (const auto& [traction, loaded, other] : {std::tuple{Traction::shear_x, 4, 3}, {Traction::shear_y, 3, 4}})
    for (const auto& [x, y, expected] : {std::array{0.3, -0.2, -1.0}, {1.4, 0.1, 0.0}, {0.2, -0.7, 0.0}})
    {
      const SymTensor s = rectangle_stress(x, y, 0.0, 2.0, 1.0, 0.3, traction);
      EXPECT_NEAR(s[static_cast<std::size_t>(loaded)], expected, rounding);
      EXPECT_EQ(s[static_cast<std::size_t>(other)], 0.0);
      EXPECT_EQ(s[2], 0.0);
    }
}

TEST(ShearedRectangleTest, DivergenceVanishesInSecondOrder)
{
  const auto divergence = [](double h)
  {
    return test::divergence(0.42, 0.33, 0.3, h,
                            [](double x, double y, double z)
                            { return rectangle_stress(x, y, z, 1.0, 0.8, 0.3, Traction::shear_x); });
  };
  const double order = std::log2(divergence(2e-2) / divergence(1e-2));
  EXPECT_NEAR(order, 2.0, 0.05) << "central differences, h^4 terms of some (h/z)^2 = 1e-3";
}

TEST(ShearedRectangleTest, FarFieldIsThePointForce)
{
  // Next term of the multipole series: second moments dx^2/12 times second derivatives, of relative size 6 (dx/R)^2.
  const double x = 120.0, y = -160.0, z = 150.0, R = std::sqrt(x * x + y * y + z * z);
  const SymTensor far = rectangle_stress(x, y, z, 1.0, 1.0, 0.3, Traction::shear_x);
  const SymTensor force = test::point_force_along_x(x, y, z, 0.3);
  for (std::size_t c = 0; c < 6; ++c)
    EXPECT_NEAR(far[c], force[c], 12.0 / (R * R) * std::abs(force[c]) + rounding) << "component " << c;
}

TEST(ShearedStripTest, IsALongRectangle)
{
  const double dx = 0.4, length = 1e6;
  for (const Traction traction : {Traction::shear_x, Traction::shear_y})
    for (const double x : {0.0, 0.15, 1.0})
      for (const double z : {0.0, 0.05, 0.3, 2.0})
      {
        const SymTensor left = strip_stress_edge(x - 0.5 * dx, z, 0.3, traction);
        const SymTensor right = strip_stress_edge(x + 0.5 * dx, z, 0.3, traction);
        const SymTensor rectangle = rectangle_stress(x, 0.0, z, dx, length, 0.3, traction);
        for (std::size_t c = 0; c < 6; ++c)
          EXPECT_NEAR(right[c] - left[c], rectangle[c], dx / length) << "component " << c << " at " << x << ' ' << z;
      }
}

} // namespace
} // namespace brinell::green::shear_test
