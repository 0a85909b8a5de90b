// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/foundation/error.hpp"
#include "brinell/simulation/shape.hpp"
#include "brinell/simulation/texture.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

namespace brinell::simulation::shape_test
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
  const Dent dent{1.0, 2.0, 3.0, 1.0};
  EXPECT_NEAR(depth(dent, 1.0, 2.0), 3.0, rounding);
  EXPECT_NEAR(depth(dent, 2.0, 2.0), 0.0, rounding) << "the surface is crossed at the edge";
  EXPECT_NEAR(depth(dent, 1.5, 2.0), 0.5 * 3.0, 0.01 * 3.0) << "half of the depth at half of the edge's radius";
  double highest = 0.0, at = 0.0;
  for (double r = 0.0; r < 3.0; r += 1e-3)
    if (const double height = -depth(dent, 1.0 + r, 2.0); height > highest)
      highest = height, at = r;
  EXPECT_NEAR(at, 1.26, 5e-3) << "crest of the shoulder";
  EXPECT_NEAR(highest, 0.040 * 3.0, 1e-3 * 3.0);
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

TEST(TextureTest, SampledFunction)
{
  const auto waves = [](double x, double y) { return 1e-6 * std::cos(2.0 * pi * x / 1e-3) + 2e-3 * y; };
  const HeightMap map = sampled(waves, 41, 21, 25e-6, 50e-6, 1e-4, -2e-4);
  EXPECT_EQ(map.heights.size(), 41u * 21u);
  for (const auto& [i, j] : {std::pair{0, 0}, {17, 4}, {40, 20}})
  {
    const double x = 1e-4 + (i - 20) * 25e-6;
    const double y = -2e-4 + (j - 10) * 50e-6;
    EXPECT_NEAR(depth(map, x, y), -waves(x, y), 1e-18) << i << " " << j; // depth is into the body
  }
  EXPECT_EQ(sampled(waves, 41, 21, 25e-6, 50e-6, 1e-4, -2e-4), map) << "it can be compared, as a function could not";
  EXPECT_THROW(static_cast<void>(sampled(waves, 0, 1, 1.0, 1.0)), InputError);
  EXPECT_THROW(static_cast<void>(sampled(waves, 1, 1, 0.0, 1.0)), InputError);
  try
  {
    static_cast<void>(sampled([](double x, double) { return 1.0 / x; }, 3, 1, 1e-3, 1e-3));
    FAIL();
  }
  catch (const InputError& error)
  {
    EXPECT_NE(std::string(error.what()).find("the height at x = 0 m, y = 0 m is inf"), std::string::npos)
        << error.what();
  }
}

TEST(TextureTest, ReachHoldsAllHeights)
{
  const Dent dent{.x = 0.3, .y = -0.2, .depth = 2e-3, .edge_radius = 0.025};
  const Dent bump{.x = 0.3, .y = -0.2, .depth = -2e-3, .edge_radius = 0.025};
  EXPECT_EQ(reach(Texture{}).height, 0.0);
  EXPECT_EQ(reach(bump).height, 2e-3);
  double highest = 0.0;
  for (double r = 0.0; r < 4.0; r += 1e-4)
    highest = std::max(highest, -depth(dent, 0.3 + r * dent.edge_radius, -0.2));
  EXPECT_GE(reach(dent).height, highest);
  EXPECT_LE(reach(dent).height, 1.05 * highest);
  EXPECT_LT(std::abs(depth(bump, 0.3, -reach(bump).half_width_y)), 0.04 * 2e-3);
  const HeightMap map{2, 3, 1.0, 2.0, 0.0, 5.0, {-1.0, 0.5, 0.25, 3.0, -2.0, 0.0}};
  EXPECT_EQ(reach(map).height, 3.0);
  EXPECT_EQ(depth(map, 0.0, reach(map).half_width_y), 0.0);
  EXPECT_EQ(reach(HeightMap{1, 1, 1.0, 1.0, 0.0, 0.0, {-1.0}}).height, 0.0);
}

TEST(ShapeTest, CellsOfAnEqualGridLieOnThePointsOfAPeriodicMap)
{
  for (const auto& [nx, ny] : {std::pair{8, 6}, {7, 6}, {8, 5}, {7, 5}})
  {
    HeightMap map{nx, ny, 1e-6, 2e-6, 0.0, 0.0, {}, true};
    for (int i = 0; i < nx * ny; ++i)
      map.heights.push_back(std::cos(1.7 * i * i)); // of points that have nothing to do with each other
    const SurfaceGrid grid{nx, ny, map.dx, map.dy, Boundary::periodic, Boundary::periodic};
    // As the lower body has them: columns at whole cells from x = 0.
    std::vector<double> seen = cell_depths(map, grid, -((nx - 1) / 2) * map.dx, grid.y(0));
    for (double& depth : seen)
      depth = -depth;
    std::sort(seen.begin(), seen.end());
    std::sort(map.heights.begin(), map.heights.end());
    for (std::size_t i = 0; i < seen.size(); ++i)
      EXPECT_NEAR(seen[i], map.heights[i], 1e-12) << nx << " x " << ny;
  }
}

TEST(ShapeTest, ShortestWavesOfAMap)
{
  HeightMap waves{65, 50, 1e-6, 2e-6, 0.0, 0.0, {}}; // second differences over whole waves
  for (int j = 0; j < 50; ++j)
    for (int i = 0; i < 65; ++i)
      waves.heights.push_back(std::cos(2.0 * std::numbers::pi * i / 9.0) +
                              0.5 * std::cos(2.0 * std::numbers::pi * j / 12.0));
  EXPECT_NEAR(shortest_waves(waves)[0], 9e-6, 1e-15);
  EXPECT_NEAR(shortest_waves(waves)[1], 24e-6, 1e-15);
  for (std::size_t i = 0; i < waves.heights.size(); ++i)
    waves.heights[i] = i % 65 % 2 == 0 ? 1.0 : -1.0; // as fast along x as points can tell, not at all along y
  EXPECT_DOUBLE_EQ(shortest_waves(waves)[0], 2e-6);
  EXPECT_EQ(shortest_waves(waves)[1], std::numeric_limits<double>::infinity());
}

/// A sum of waves in all directions, amplitudes falling as those of a self-affine surface.
HeightMap sum_of_waves(int points, double shortest, double exponent)
{
  HeightMap map{points, points, 1e-6, 1e-6, 0.0, 0.0, std::vector<double>(static_cast<std::size_t>(points * points))};
  constexpr int count = 40;
  for (int n = 0; n < count; ++n)
  {
    const double wavelength = shortest * std::pow(8.0, n / (count - 1.0));
    const double angle = 2.4 * n, phase = 1.7 * n * n;
    const double qx = 2.0 * pi / wavelength * std::cos(angle), qy = 2.0 * pi / wavelength * std::sin(angle);
    for (int j = 0; j < points; ++j)
      for (int i = 0; i < points; ++i)
        map.heights[static_cast<std::size_t>(j * points + i)] +=
            1e-8 * std::pow(wavelength / shortest, exponent) * std::cos(qx * i + qy * j + phase);
  }
  return map;
}

TEST(ShapeTest, ShortestOfManyWavesOfAMap)
{
  for (const double exponent : {0.0, 0.5, 1.0, 1.8})
    for (const double shortest : {4.0, 9.0, 21.3})
    {
      const std::array<double, 2> found = shortest_waves(sum_of_waves(256, shortest, exponent));
      EXPECT_NEAR(std::min(found[0], found[1]), shortest * 1e-6, 0.15 * shortest * 1e-6) << shortest << " " << exponent;
    }
  HeightMap noisy = sum_of_waves(256, 21.3, 1.0);
  double size = 0.0;
  for (const double h : noisy.heights)
    size = std::max(size, std::abs(h));
  for (std::size_t i = 0; i < noisy.heights.size(); ++i)
    noisy.heights[i] += 1e-4 * size * std::cos(1.7 * static_cast<double>(i) * static_cast<double>(i));
  EXPECT_GT(shortest_waves(noisy)[0], 15e-6) << "noise of an instrument is no roughness";
}

TEST(ShapeTest, EquivalentRadiusIsThatOfRoundPairs)
{
  EXPECT_DOUBLE_EQ(equivalent_radius(Paraboloid{1.0, 1.0}, Paraboloid{3.0, 3.0}).value(), 0.75);
  EXPECT_DOUBLE_EQ(equivalent_radius(Paraboloid{1.0, 2.0}, Paraboloid{2.0, 1.0}).value(), 2.0 / 3.0);
  EXPECT_FALSE(equivalent_radius(Paraboloid{1.0, 2.0}, Plane{}).has_value());
  EXPECT_FALSE(equivalent_radius(Plane{}, Plane{}).has_value());
  EXPECT_FALSE(equivalent_radius(Cone{1.2, 0.0}, Plane{}).has_value());
}

} // namespace
} // namespace brinell::simulation::shape_test
