// SPDX-License-Identifier: BSD-3-Clause
#include "simulation/stepping/stress_samples.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace brinell::simulation::stress_samples_test
{
namespace
{

constexpr VolumeGrid grid{{5, 3, 1e-6, 1e-6}, 2, 1e-6};
constexpr int numbers = 6;

/// A smooth closed path for each cell, sampled in so many points.
struct Winding
{
  std::vector<double> amplitudes;

  explicit Winding(unsigned seed) : amplitudes(grid.size() * numbers * 4)
  {
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    for (double& a : amplitudes)
      a = normal(random);
  }
  [[nodiscard]] float operator()(std::size_t number, double angle) const
  {
    const double* a = amplitudes.data() + 4 * number;
    return static_cast<float>(a[0] * std::cos(angle) + a[1] * std::sin(angle) + 0.4 * a[2] * std::cos(2.0 * angle) +
                              0.4 * a[3] * std::sin(3.0 * angle));
  }
};

StressSamples followed(const Winding& path, int points)
{
  StressSamples samples(grid, numbers);
  for (int i = 0; i < points; ++i)
  {
    Sample& sample = samples.add(0, grid.surface.nx);
    for (std::size_t n = 0; n < sample.values.size(); ++n)
      sample.values[n] = path(n, 2.0 * std::numbers::pi * i / points);
    samples.thin();
  }
  return samples;
}

// In any direction the samples of each cell reach as far as its whole path, but for the error that the container states.
TEST(StressSamples, KeepTheHullToTheErrorThatTheyState)
{
  const Winding path(3);
  constexpr int points = 400, columns = grid.surface.nx;
  const StressSamples samples = followed(path, points);
  EXPECT_LE(samples.samples().size(), static_cast<std::size_t>(fatigue_samples));
  EXPECT_LT(samples.error(), 0.5); // of some 3, the size of a path
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  double worst = 0.0;
  for (int strip = 0; strip < samples.strips(); ++strip)
    for (int i = 0; i < columns; ++i)
      for (int trial = 0; trial < 50; ++trial)
      {
        std::array<double, numbers> direction{};
        double length = 0.0;
        for (double& c : direction)
          c = normal(random), length += c * c;
        const auto along = [&](const auto& number)
        {
          double sum = 0.0;
          for (int n = 0; n < numbers; ++n)
            sum += direction[static_cast<std::size_t>(n)] / std::sqrt(length) * number(n);
          return sum;
        };
        double whole = -1e300, kept = -1e300;
        for (int p = 0; p < points; ++p)
          whole = std::max(whole, along(
                                      [&](int n) {
                                        return path(static_cast<std::size_t>((strip * numbers + n) * columns + i),
                                                    2.0 * std::numbers::pi * p / points);
                                      }));
        for (const Sample& sample : samples.samples())
          kept = std::max(kept, along([&](int n) { return samples.strip(sample, strip)[n * columns + i]; }));
        EXPECT_LE(kept, whole + 1e-6);
        worst = std::max(worst, whole - kept);
      }
  EXPECT_GT(worst, 0.0);
  EXPECT_LE(worst, samples.error() + 1e-6);
}

TEST(StressSamples, KeepAllThatFit)
{
  const StressSamples samples = followed(Winding(5), 20);
  EXPECT_EQ(samples.samples().size(), 20U);
  EXPECT_EQ(samples.error(), 0.0);
}

TEST(StressSamples, BeginACycleWhereTheLastOneEnded)
{
  StressSamples samples = followed(Winding(5), 20);
  const std::vector<float> last = samples.samples().back().values;
  samples.restart();
  ASSERT_EQ(samples.samples().size(), 1U);
  EXPECT_EQ(samples.samples().front().values, last);
}

TEST(StressSamples, AreStoredAndRestored)
{
  StressSamples samples = followed(Winding(1), 90);
  Archive saved;
  samples.exchange(saved);
  StressSamples other(grid, numbers);
  Archive restored(saved.fields());
  other.exchange(restored);
  ASSERT_EQ(other.samples().size(), samples.samples().size());
  EXPECT_EQ(other.error(), samples.error());
  for (std::size_t n = 0; n < samples.samples().size(); ++n)
    EXPECT_EQ(other.samples()[n].values, samples.samples()[n].values);
}

TEST(StressSamples, MoveToALargerGrid)
{
  StressSamples samples(grid, numbers);
  Sample& part = samples.add(1, 3);
  for (std::size_t n = 0; n < part.values.size(); ++n)
    part.values[n] = static_cast<float>(n + 1);
  const StressSamples before = samples;
  VolumeGrid larger = grid;
  larger.surface.nx += 4;
  larger.surface.ny += 2;
  larger.nz += 1;
  StressSamples one(larger, numbers);
  Sample untouched = one.add(0, larger.surface.nx);
  std::ranges::fill(untouched.values, -7.0F);
  samples.move_to(larger, 2, 1, untouched);
  const Sample& moved = samples.samples().front();
  EXPECT_EQ(moved.first, 3);
  EXPECT_EQ(moved.count, 3);
  const int rows = grid.surface.ny, more_rows = larger.surface.ny;
  for (int k = 0; k < larger.nz; ++k)
    for (int j = 0; j < more_rows; ++j)
      for (int i = 0; i < 3 * numbers; ++i)
        EXPECT_EQ(samples.strip(moved, k * more_rows + j)[i],
                  k < grid.nz && j >= 1 && j <= rows ? before.strip(before.samples().front(), k * rows + j - 1)[i]
                                                     : -7.0F);
}

} // namespace
} // namespace brinell::simulation::stress_samples_test
