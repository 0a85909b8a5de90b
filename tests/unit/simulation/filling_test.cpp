// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/foundation/error.hpp"
#include "brinell/simulation/filling.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

/// Smooth surfaces in place of points that were not measured.
namespace brinell::simulation::filling_test
{

namespace
{

constexpr double gap = std::numeric_limits<double>::quiet_NaN();

/// The slow, obvious way: each filled height becomes the mean of its neighbours, over and over.
std::vector<double> averaged(const std::vector<double>& holed, int nx, int ny)
{
  std::vector<double> heights = holed;
  for (double& height : heights)
    height = std::isfinite(height) ? height : 0.0;
  for (int sweep = 0; sweep < 20000; ++sweep)
    for (int j = 0; j < ny; ++j)
      for (int i = 0; i < nx; ++i)
      {
        if (std::isfinite(holed[static_cast<std::size_t>(j * nx + i)]))
          continue;
        double sum = 0.0;
        int count = 0;
        for (const auto& [x, y] : {std::pair{i - 1, j}, {i + 1, j}, {i, j - 1}, {i, j + 1}})
          if (x >= 0 && x < nx && y >= 0 && y < ny)
          {
            sum += heights[static_cast<std::size_t>(y * nx + x)];
            ++count;
          }
        heights[static_cast<std::size_t>(j * nx + i)] = sum / count;
      }
  return heights;
}

TEST(Filling, IsTheMeanOfTheNeighbours)
{
  constexpr int nx = 17, ny = 11;
  std::mt19937 random(4);
  std::vector<double> heights(static_cast<std::size_t>(nx * ny));
  for (double& height : heights)
    height = random() % 5 == 0 ? gap : 100.0 + static_cast<double>(random() % 1000) / 1000.0;
  for (int i = 0; i < 6; ++i) // a corner and a hole of several points
    heights[static_cast<std::size_t>(i)] = heights[static_cast<std::size_t>(5 * nx + 5 + i)] = gap;
  const std::vector<double> found = filled(heights, nx), expected = averaged(heights, nx, ny);
  for (std::size_t k = 0; k < heights.size(); ++k)
    EXPECT_NEAR(found[k], expected[k], 1e-8) << k; // the residual is 1e-9 of differences of about 1
}

TEST(Filling, KeepsWhatWasMeasured)
{
  const std::vector<double> whole{1.0, 2.0, 3.0, 4.0};
  EXPECT_EQ(filled(whole, 2), whole);
  EXPECT_EQ(filled({1.0, gap, 3.0}, 3), (std::vector<double>{1.0, 2.0, 3.0}));
  EXPECT_EQ(filled({7.0, std::numeric_limits<double>::infinity()}, 1), (std::vector<double>{7.0, 7.0}));
  EXPECT_THROW((void)filled({gap, gap}, 2), InputError);
}

} // namespace

} // namespace brinell::simulation::filling_test
