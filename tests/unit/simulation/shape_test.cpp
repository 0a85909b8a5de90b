// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/simulation/shape.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace brinell::simulation
{
namespace
{

constexpr double pi = std::numbers::pi;
constexpr double degree = pi / 180.0;
constexpr double rounding = 1e-12;

TEST(ShapeTest, ParaboloidAndRoller)
{
  EXPECT_NEAR(height(Paraboloid{2.0, 4.0}, 0.2, 0.4), 0.01 + 0.02, rounding);
  EXPECT_NEAR(height(Roller{2.0, 1.0}, 0.2, 0.5), 0.01, rounding);
  EXPECT_GT(height(Roller{2.0, 1.0}, 0.2, 0.51), 2.0) << "beyond the end";
  EXPECT_EQ(height(Plane{}, 3.0, 4.0), 0.0);
}

TEST(ShapeTest, SharpConeAndPyramid)
{
  const double slope = 1.0 / std::tan(70.3 * degree);
  EXPECT_NEAR(height(Cone{70.3 * degree, 0.0}, 3.0, 4.0), 5.0 * slope, rounding);
  EXPECT_EQ(height(Cone{70.3 * degree, 0.0}, 0.0, 0.0), 0.0);
  // A Vickers pyramid: faces across x and y, edges between them.
  const double face = 1.0 / std::tan(68.0 * degree);
  for (const auto& [x, y] : {std::pair{1.0, 0.3}, {0.3, -1.0}, {-1.0, 0.9}, {0.7, 0.7}})
    EXPECT_NEAR(height(Pyramid{4, 68.0 * degree, 0.0}, x, y), face * std::max(std::abs(x), std::abs(y)), 1e-6);
}

TEST(ShapeTest, ProjectedAreaOfVickersAndBerkovich)
{
  // 24.5 times the depth squared, for both: cells of a fine grid below the depth 1.
  for (const Pyramid& pyramid : {Pyramid{4, 68.0 * degree, 0.0}, Pyramid{3, 65.27 * degree, 0.0}})
  {
    constexpr int n = 800;
    constexpr double size = 12.0, cell = size / n;
    int count = 0;
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i)
        count += height(pyramid, (i + 0.5) * cell - 0.5 * size, (j + 0.5) * cell - 0.5 * size) < 1.0 ? 1 : 0;
    EXPECT_NEAR(count * cell * cell, 24.5, 0.1) << pyramid.faces;
  }
}

TEST(ShapeTest, TipsAreBallsThatTouchTheFlanks)
{
  const double R = 2.0;
  const double slope = 1.0 / std::tan(70.0 * degree);
  const Cone cone{70.0 * degree, R};
  EXPECT_NEAR(height(cone, 0.1, 0.2), 0.05 / (2.0 * R), rounding);
  // Beyond the circle of tangency, slope R, the flank: lower than the sharp one by slope^2 R / 2.
  EXPECT_NEAR(height(cone, 3.0, 4.0), 5.0 * slope - 0.5 * R * slope * slope, rounding);
  for (const double angle : {0.1, 0.8, 2.0})
    for (const double r : {0.5 * slope * R, slope * R, 2.0 * slope * R}) // no kink where they meet
    {
      const auto at = [&](double s) {
        return height(Pyramid{4, 70.0 * degree, R}, s * std::cos(angle), s * std::sin(angle));
      };
      const double step = 1e-6 * r;
      EXPECT_NEAR((at(r + step) - at(r)) / step, (at(r) - at(r - step)) / step, 1e-5);
    }
}

TEST(ShapeTest, DentsAndHeightMaps)
{
  const Dent dent{1.0, 2.0, 3.0, 4.0};
  EXPECT_NEAR(depth(dent, 1.0, 2.0), 3.0, rounding);
  EXPECT_NEAR(depth(dent, 2.0, 2.0), 0.0, rounding) << "the surface is crossed at a quarter of the radius";
  EXPECT_LT(depth(dent, 2.4, 2.0), 0.0) << "the shoulder";
  HeightMap map{3, 2, 0.5, 1.0, 0.0, 0.0, {1.0, 2.0, 3.0, 4.0, 5.0, 6.0}};
  EXPECT_NEAR(depth(map, -0.5, -0.5), -1.0, rounding);
  EXPECT_NEAR(depth(map, 0.25, 0.0), -0.5 * (2.5 + 5.5), rounding);
  EXPECT_EQ(depth(map, 1.1, 0.0), 0.0);
  EXPECT_EQ(depth(map, 1e300, 0.0), 0.0);
}

TEST(ShapeTest, CurvaturesAdd)
{
  const auto k = relative_curvature(Paraboloid{2.0, -4.0}, Roller{0.5, 1.0});
  ASSERT_TRUE(k);
  EXPECT_NEAR((*k)[0], 2.5, rounding);
  EXPECT_NEAR((*k)[1], -0.25, rounding);
  EXPECT_FALSE(relative_curvature(Plane{}, Cone{1.0, 0.0}));
}

} // namespace
} // namespace brinell::simulation
