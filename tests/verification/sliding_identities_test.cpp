// SPDX-License-Identifier: BSD-3-Clause
// What slides does not know where the period begins or which body is below, and shares its numbers with other scenarios.
#include "brinell/simulation/sliding.hpp"

#include "brinell/simulation/rolling.hpp"
#include "brinell/simulation/run.hpp"
#include "sliding_cases.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace brinell::simulation::sliding_identities_test
{
namespace
{

using cases::ball;
using cases::cell;
using cases::computed;
using cases::period;
using cases::SlidingResult;
using cases::waves;

TEST(SlidingTest, StrokesGoOnOrToAndFro)
{
  for (const bool to_and_fro : {false, true})
  {
    SlidingCase c = waves();
    c.distance = 3e-6;
    c.strokes = 3;
    c.to_and_fro = to_and_fro;
    const SlidingResult result = computed(c);
    ASSERT_EQ(result.history.size(), 2U + 9U + 2U);
    for (int i = 0; i < 9; ++i)
    {
      const SlidingRecord& r = result.history[static_cast<std::size_t>(i) + 2];
      const int stroke = i / 3, along = i % 3 + 1;
      EXPECT_EQ(r.pass, stroke + 1);
      EXPECT_NEAR(r.way, (i + 1) * cell, 1e-15);
      EXPECT_NEAR(r.slid, (to_and_fro ? (stroke == 1 ? 3 - along : along) : i + 1) * cell, 1e-15) << i;
      EXPECT_NEAR(r.F_n, 0.2, 1e-6);
      EXPECT_NEAR(r.contact_fraction, r.contact_area / (period * period), 1e-12);
      EXPECT_NEAR(r.nominal_pressure, r.F_n / (period * period), 1e-3);
    }
    EXPECT_EQ(result.history.back().F_n, 0.0);
    ASSERT_EQ(result.summary.strokes.size(), 3U);
    for (int i = 0; i < 3; ++i)
      EXPECT_EQ(result.summary.strokes[static_cast<std::size_t>(i)].stroke, i + 1);
  }
}

TEST(SlidingTest, OfABallIsARollingThatDoesNotTurn)
{
  SlidingCase c = ball();
  c.friction.coefficient = 0.1;
  RollingCase rolling;
  static_cast<Numerics&>(rolling) = c;
  rolling.lower = c.lower;
  rolling.upper = c.upper;
  rolling.drive = c.press;
  rolling.load_steps = 1;
  rolling.slide_to_roll = 2.0;
  rolling.distance = c.distance;
  simulation::Run run(rolling);
  std::vector<RollingRecord> rolled;
  while (!run.is_done())
    rolled.push_back(run.step());
  c.distance = (static_cast<double>(rolled.size()) - 2.0) * plan(rolling).shift;
  const SlidingResult slid = computed(c);
  ASSERT_EQ(slid.history.size(), rolled.size());
  for (std::size_t i = 0; i < rolled.size(); ++i)
  {
    EXPECT_NEAR(slid.history[i].F_n, rolled[i].F_n, 1e-6 * rolled[1].F_n);
    EXPECT_NEAR(slid.history[i].max_residual_lower, rolled[i].max_residual_lower, 1e-3 * rolled[i].max_residual_lower);
    EXPECT_NEAR(slid.history[i].F_friction, rolled[i].F_friction, 1e-4 * rolled[1].F_friction);
    // Rolling reads the slope of the lower surface, sliding that of both: they differ at the edge of the contact.
    EXPECT_NEAR(slid.history[i].F_X, rolled[i].F_X, 0.01 * rolled[1].F_n) << i;
  }
  EXPECT_NEAR(slid.summary.dissipation_friction, run.summary().dissipation_friction,
              1e-3 * slid.summary.dissipation_friction);
}

TEST(SlidingTest, NothingTellsWhereThePeriodBegins)
{
  SlidingCase c = waves();
  // A map below, waves above.
  HeightMap map = sampled(
      [](double x, double y)
      {
        const double k = 2.0 * std::numbers::pi / period;
        return 0.15e-6 * (std::cos(k * (x - 3e-6)) * std::cos(k * y) + 0.5 * std::sin(2.0 * k * x - k * y + 0.7));
      },
      33, 33, cell, cell);
  map.periodic = true;
  c.lower.texture = map;
  // Both runs solve the same problem; what is left is rounding, grown by the iterations up to where these stop.
  c.solver.contact_tolerance = 1e-12;
  c.solver.yield_tolerance = c.solver.displacement_tolerance = 1e-10;
  const SlidingResult here = computed(c);
  auto& below = std::get<HeightMap>(c.lower.texture.parts.front());
  auto& above = std::get<Sinusoid>(c.upper.texture.parts.front());
  for (double* x : {&below.x, &above.x})
    *x += 7.0 * cell;
  for (double* y : {&below.y, &above.y})
    *y -= 4.0 * cell;
  const SlidingResult there = computed(c);
  ASSERT_GT(here.summary.dissipation_lower, 0.0);
  const SlidingRecord& last = here.history.at(here.history.size() - 3); // that slides
  constexpr double bound = 1e-10;
  for (std::size_t i = 0; i < here.history.size(); ++i)
  {
    const SlidingRecord &a = here.history[i], &b = there.history[i];
    EXPECT_NEAR(a.F_X, b.F_X, bound * a.F_n + 1e-15) << i;
    EXPECT_NEAR(a.work, b.work, bound * here.summary.work) << i;
    EXPECT_NEAR(a.approach, b.approach, bound * std::abs(last.approach)) << i;
    EXPECT_NEAR(a.contact_area, b.contact_area, bound * last.contact_area) << i;
    EXPECT_NEAR(a.max_residual_lower, b.max_residual_lower, bound * last.max_residual_lower) << i;
    EXPECT_EQ(a.patches, b.patches) << i;
  }
}

TEST(SlidingTest, NothingTellsWhichBodyIsBelow)
{
  SlidingCase c = waves();
  c.friction.coefficient = 0.2;
  const SlidingResult upright = computed(c);
  std::swap(c.lower, c.upper);
  for (ShapedBody* body : {&c.lower, &c.upper}) // turned about y
    std::get<Sinusoid>(body->texture.parts.front()).x *= -1.0;
  const SlidingResult turned = computed(c);
  // The tolerances of the solver.
  for (std::size_t i = 0; i < upright.history.size(); ++i)
  {
    const SlidingRecord &a = upright.history[i], &b = turned.history[i];
    EXPECT_NEAR(a.F_X, b.F_X, 1e-4 * a.F_n + 1e-15) << i;
    EXPECT_NEAR(a.max_residual_lower, b.max_residual_upper, 1e-3 * upright.history.back().max_residual_lower) << i;
  }
  const SlidingStroke &a = upright.summary.strokes.front(), &b = turned.summary.strokes.front();
  EXPECT_NEAR(a.dissipation_plastic, b.dissipation_plastic, 1e-3 * a.dissipation_plastic);
  EXPECT_NEAR(a.dissipation_friction, b.dissipation_friction, 1e-4 * a.dissipation_friction);
  EXPECT_NEAR(a.rms_height_lower, b.rms_height_upper, 1e-6 * a.rms_height_lower);
  EXPECT_NEAR(a.mean_height_upper, b.mean_height_lower, 1e-6 * a.mean_height_upper);
}

} // namespace
} // namespace brinell::simulation::sliding_identities_test
