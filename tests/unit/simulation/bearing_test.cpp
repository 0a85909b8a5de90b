// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/simulation/bearing.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace brinell::simulation::bearing_test
{
namespace
{

/// Share of a Gaussian surface above z.
double share_above(double z)
{
  return 0.5 * std::erfc(z / std::numbers::sqrt2);
}

double density(double z)
{
  return std::exp(-0.5 * z * z) / std::sqrt(2.0 * std::numbers::pi);
}

/// Heights whose curve is the Gaussian one, each in the middle of its share.
std::vector<double> gaussian(int count)
{
  std::vector<double> heights;
  for (int i = 0; i < count; ++i)
  {
    double low = -9.0, high = 9.0;
    for (int k = 0; k < 60; ++k)
    {
      const double z = 0.5 * (low + high);
      (share_above(z) > (i + 0.5) / count ? low : high) = z;
    }
    heights.push_back(0.5 * (low + high));
  }
  return heights;
}

TEST(Bearing, OfAStraightCurveIsAllCore)
{
  std::vector<double> heights;
  for (int i = 0; i < 1000; ++i)
    heights.push_back(3e-6 * (i + 0.5) / 1000);
  const Bearing b = bearing_of(heights);
  EXPECT_NEAR(b.core_height, 3e-6, 1e-17);
  EXPECT_NEAR(b.peak_height, 0.0, 1e-17);
  EXPECT_NEAR(b.valley_depth, 0.0, 1e-17);
}

TEST(Bearing, OfAGaussianSurfaceHasClosedForms)
{
  // Of least fall are the 40 % in the middle, +-z1 with 70 % above -z1. Least squares there: the fall is the integral of (s - 1/2) z over
  // that of (s - 1/2)^2, 2/3 0.2^3; by parts the first one is erf(z1)/(2 sqrt(pi)) - 0.4 density(z1).
  const double z1 = 0.5244005127080407;
  ASSERT_NEAR(share_above(-z1), 0.7, 1e-15);
  const double fall = (0.5 * std::erf(z1) / std::sqrt(std::numbers::pi) - 0.4 * density(z1)) / (2.0 / 3.0 * 0.008);
  const double top = 0.5 * fall, share = share_above(top);
  const double triangle = 2.0 * (density(top) - top * share) / share;
  const Bearing b = bearing_of(gaussian(40000));
  // Sums over 40000 heights: 1e-4 of the area at the ends, where single heights are.
  EXPECT_NEAR(b.core_height, fall, 1e-4 * fall);
  EXPECT_NEAR(b.peak_share, share, 1e-4);
  EXPECT_NEAR(b.valley_share, 1.0 - share, 1e-4);
  EXPECT_NEAR(b.peak_height, triangle, 1e-3 * triangle);
  EXPECT_NEAR(b.valley_depth, triangle, 1e-3 * triangle);
}

TEST(Bearing, PeaksOfASurfaceAreValleysOfItsCast)
{
  std::mt19937 generator(5);
  std::gamma_distribution<double> skewed(2.0, 1e-6);
  std::vector<double> heights(5000), cast(5000), moved(5000);
  for (std::size_t i = 0; i < heights.size(); ++i)
  {
    heights[i] = skewed(generator);
    cast[i] = -heights[i];
    moved[heights.size() - 1 - i] = heights[i] + 1e-5;
  }
  const Bearing a = bearing_of(heights), b = bearing_of(cast), c = bearing_of(moved);
  ASSERT_GT(a.peak_height, 2.0 * a.valley_depth);
  EXPECT_NEAR(a.core_height, b.core_height, 1e-9 * a.core_height);
  EXPECT_NEAR(a.peak_height, b.valley_depth, 1e-9 * a.peak_height);
  EXPECT_NEAR(a.valley_depth, b.peak_height, 1e-9 * a.peak_height);
  EXPECT_NEAR(a.peak_share, 1.0 - b.valley_share, 1e-9);
  EXPECT_NEAR(a.core_height, c.core_height, 1e-9 * a.core_height);
  EXPECT_NEAR(a.peak_height, c.peak_height, 1e-9 * a.peak_height);
}

TEST(Bearing, OfAPlateauIsWhatStandsOutOfIt)
{
  // A tenth stands 2 high, a fifth lies 3 deep; between them there is no core. Triangles of the areas 0.2 and 0.6.
  std::vector<double> heights(1000, 0.0);
  std::fill(heights.begin(), heights.begin() + 100, 2.0);
  std::fill(heights.begin() + 100, heights.begin() + 300, -3.0);
  const Bearing b = bearing_of(heights);
  EXPECT_EQ(b.core_height, 0.0);
  EXPECT_NEAR(b.peak_share, 0.1, 1e-12);
  EXPECT_NEAR(b.peak_height, 4.0, 1e-12);
  EXPECT_NEAR(b.valley_share, 0.8, 1e-12);
  EXPECT_NEAR(b.valley_depth, 6.0, 1e-12);
  const Bearing flat = bearing_of(std::vector<double>(9, 1.5));
  EXPECT_EQ(flat.core_height, 0.0);
  EXPECT_EQ(flat.peak_height, 0.0);
  EXPECT_EQ(flat.valley_depth, 0.0);
  EXPECT_EQ(bearing_of({1.0}).core_height, 0.0);
}

} // namespace
} // namespace brinell::simulation::bearing_test
