// SPDX-License-Identifier: BSD-3-Clause
// The surfaces of bodies that slide: where they meet, and what is told of their contact and their roughness.
#include "brinell/simulation/bearing.hpp"
#include "brinell/simulation/sliding.hpp"
#include "scenario_checks.hpp"
#include "sliding_cases.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <variant>
#include <vector>

namespace brinell::simulation::sliding_surfaces_test
{
namespace
{

using Kind = contact::Drive::Kind;
using cases::ball;
using cases::cell;
using cases::computed;
using cases::period;
using cases::SlidingResult;
using cases::waves;

TEST(SlidingSurfaces, HeightsAreThoseOfTheTexturesUntilSomethingYields)
{
  SlidingCase c = waves();
  c.lower.material.hardening.reset();
  c.upper.material.hardening.reset();
  const SlidingStroke stroke = computed(c).summary.strokes.front();
  // Of cos cos, a half and (2/pi)^2; cells show the waves a little flatter than they are.
  EXPECT_NEAR(stroke.rms_height_lower / 0.2e-6, 0.5, 0.005);
  EXPECT_NEAR(stroke.mean_height_lower / 0.2e-6, 4.0 / 9.8696, 0.005);
  EXPECT_NEAR(stroke.rms_height_upper / 0.1e-6, 0.5, 0.01);
  EXPECT_EQ(stroke.dissipation_plastic, 0.0);
}

/// A cap of a sphere, on a flat or on the other one of a period.
HeightMap cap(double radius, double height, double x)
{
  const int half = static_cast<int>(std::ceil(std::sqrt(2.0 * radius * height) / cell));
  HeightMap map = sampled([&](double u, double v) { return std::max(0.0, height - (u * u + v * v) / (2.0 * radius)); },
                          2 * half + 1, 2 * half + 1, cell, cell);
  map.x = x;
  return map;
}

/// Two peaks a third of a period apart.
SlidingCase two_peaks()
{
  SlidingCase c = waves();
  c.lower.texture = cap(50e-6, 0.2e-6, 6e-6);
  c.upper.texture = cap(50e-6, 0.2e-6, -5e-6);
  c.press = {Kind::approach, -0.3e-6};
  c.distance = 20e-6;
  return c;
}

TEST(SlidingSurfaces, PeaksMeetOnTheWay)
{
  SlidingCase c = two_peaks();
  const SlidingResult result = computed(c);
  EXPECT_EQ(result.history.at(1).F_n, 0.0) << "pressed, but apart";
  EXPECT_NEAR(result.history.at(1).approach, -0.3e-6, 1e-20);
  EXPECT_EQ(result.history.back().F_n, 0.0);
  double first = 0.0, last = 0.0;
  for (const SlidingRecord& r : result.history)
    if (r.F_n > 0.0)
    {
      first = first > 0.0 ? first : r.slid;
      last = r.slid;
      EXPECT_EQ(r.patches, 1) << r.slid;
    }
  // Tops are 11 um apart; with an overlap of 0.1 um they touch within sqrt(2 (R1 + R2) 0.1 um) = 4.5 um of each other.
  EXPECT_NEAR(first, 7.0e-6, 1.1e-6);
  EXPECT_GE(last, 11e-6);
  EXPECT_LT(last, 16e-6);
  EXPECT_GT(result.summary.dissipation_lower, 0.0);
  const double before = std::abs(result.history.at(2).work);
  EXPECT_EQ(before, 0.0) << "nothing works on peaks that are apart";
}

TEST(SlidingSurfaces, SurfacesThatNeverTouchAreRefused)
{
  // Tops that overlap by nothing; beside each other; and a way that ends before they meet.
  expect_refused("sliding.approach", "first touch at -4e-07 m", two_peaks(), [](auto& c) { c.press.value = -0.45e-6; });
  expect_refused("sliding.approach", "on their way", two_peaks(), [](auto& c) { c.distance = 4e-6; });
  expect_refused("sliding.approach", "on their way", two_peaks(),
                 [](auto& c) { std::get<HeightMap>(c.lower.texture.parts.front()).y = 12e-6; });
  EXPECT_NO_THROW(static_cast<void>(plan(two_peaks())));
  expect_refused("sliding.approach", "smooth bodies", ball(),
                 [](auto& c)
                 {
                   c.lower.texture = {};
                   c.press = {Kind::approach, -1e-9};
                 });
  // The hollow of the dent is below, its shoulder 4 % of the depth above.
  expect_refused("sliding.approach", "on their way", ball(), [](auto& c) { c.press = {Kind::approach, -5e-9}; });
  EXPECT_NO_THROW(static_cast<void>(plan(
      [&]
      {
        SlidingCase c = ball();
        c.press = {Kind::approach, -2e-9};
        return c;
      }())));
}

TEST(SlidingSurfaces, PeaksMeetAtAMeanGap)
{
  // Elastic bodies over a period: an approach is a mean gap.
  SlidingCase c = two_peaks();
  c.lower.material.hardening.reset();
  c.upper.material.hardening.reset();
  const SlidingResult by_approach = computed(c);
  const double gap = by_approach.history.at(1).mean_gap;
  c.press = {Kind::mean_gap, gap};
  const SlidingResult by_gap = computed(c);
  ASSERT_EQ(by_gap.history.size(), by_approach.history.size());
  double largest = 0.0;
  for (std::size_t i = 0; i < by_gap.history.size(); ++i)
  {
    largest = std::max(largest, by_approach.history[i].F_n);
    EXPECT_NEAR(by_gap.history[i].F_n, by_approach.history[i].F_n, 1e-5 * largest) << i; // tolerance of the contact
    EXPECT_NEAR(by_gap.history[i].F_X, by_approach.history[i].F_X, 1e-5 * largest) << i;
  }
  EXPECT_GT(largest, 0.0);
  expect_refused("sliding.mean_gap", "first touch at", c, [&](auto& d) { d.press.value = 1.5 * gap; });
}

TEST(SlidingSurfaces, PatchesAreThoseOfTheContact)
{
  SlidingCase c = waves();
  const SlidingResult result = computed(c);
  const SlidingStroke& stroke = result.summary.strokes.front();
  double patches = 0.0, largest = 0.0;
  int steps = 0;
  for (const SlidingRecord& r : result.history)
  {
    EXPECT_EQ(r.patches > 0, r.contact_area > 0.0);
    EXPECT_LE(r.largest_patch, r.contact_area * (1.0 + 1e-12));
    EXPECT_GE(r.largest_patch * r.patches, r.contact_area * (1.0 - 1e-12));
    if (r.way > 0.0 && r.F_n > 0.19)
    {
      patches += r.patches;
      largest += r.largest_patch;
      ++steps;
    }
  }
  EXPECT_NEAR(stroke.patches, patches / steps, 1e-12 * patches);
  EXPECT_NEAR(stroke.largest_patch, largest / steps, 1e-12 * largest);
}

TEST(SlidingSurfaces, BearingCurvesAreThoseOfTheTexturesUntilSomethingYields)
{
  SlidingCase c = waves();
  c.lower.material.hardening.reset();
  c.upper.material.hardening.reset();
  const SlidingStroke stroke = computed(c).summary.strokes.front();
  const auto expected = [&](const Texture& texture)
  {
    std::vector<double> heights = depths(texture, plan(c).lower.surface, 0.0, -0.5 * period + 0.5 * cell);
    for (double& h : heights)
      h = -h;
    return bearing_of(heights);
  };
  const Bearing lower = expected(c.lower.texture), upper = expected(c.upper.texture);
  EXPECT_NEAR(stroke.core_height_lower, lower.core_height, 1e-9 * lower.core_height);
  EXPECT_NEAR(stroke.peak_height_lower, lower.peak_height, 1e-9 * lower.peak_height);
  EXPECT_NEAR(stroke.valley_depth_lower, lower.valley_depth, 1e-9 * lower.valley_depth);
  EXPECT_NEAR(stroke.core_height_upper, upper.core_height, 1e-9 * upper.core_height);
  EXPECT_NEAR(stroke.peak_height_upper, upper.peak_height, 1e-9 * upper.peak_height);
  EXPECT_NEAR(stroke.valley_depth_upper, upper.valley_depth, 1e-9 * upper.valley_depth);
}

} // namespace
} // namespace brinell::simulation::sliding_surfaces_test
