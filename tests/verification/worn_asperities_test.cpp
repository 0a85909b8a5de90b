// SPDX-License-Identifier: BSD-3-Clause
// Wear of two asperities that pass each other.
#include "brinell/simulation/tugging.hpp"
#include "scenario_checks.hpp"
#include "sliding_cases.hpp"
#include "worn_runs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace brinell::simulation::worn_asperities_test
{
namespace
{

using cases::hard_steel;
using cases::soft_steel;

constexpr double radius = 1e-3;

/// Two balls of two steels that yield and wear.
TuggingCase balls()
{
  TuggingCase c;
  c.lower = {Paraboloid{radius, radius}, soft_steel};
  c.upper = {Paraboloid{1.5 * radius, 1.5 * radius}, hard_steel};
  c.interference = 2e-6;
  c.resolution = 4.0;
  c.friction.coefficient = 0.2;
  c.wear = {.lower = 2e-13, .upper = 1e-13};
  return c;
}

TuggingCase equal_balls()
{
  TuggingCase c = balls();
  c.upper = c.lower;
  c.wear.upper = c.wear.lower;
  return c;
}

/// Way by which the surfaces slip on each other between two rows: the distance of the centres times the angle between them.
double slip(const TuggingCase& c, const TuggingRecord& before, const TuggingRecord& now)
{
  const auto radius_of = [](const ShapedBody& body) { return passing_radius(body.shape).value(); };
  const double sum = radius_of(c.lower) + radius_of(c.upper);
  const double interference = c.load ? before.interference : 0.5 * (before.interference + now.interference);
  return (sum - interference) * (now.theta - before.theta);
}

// Without a speed, too: the way of the surfaces is known from the motion.
TEST(TuggingWear, OfEachBodyIsLoadTimesWay)
{
  TuggingCase by_load = balls();
  by_load.load = 2.0;
  by_load.interference = elastic_approach(by_load.lower, by_load.upper, *by_load.load);
  TuggingCase twice = balls();
  twice.passes = 2;
  TuggingCase offset = balls();
  offset.offset = 0.02 * radius;
  for (const TuggingCase& c : {balls(), by_load, twice, offset})
  {
    const WornRun<TuggingCase> r = worn(c);
    double load_times_way = 0.0;
    for (std::size_t i = 1; i < r.history.size(); ++i)
      if (r.history[i].pass == r.history[i - 1].pass)
        load_times_way += r.history[i].F_n * slip(c, r.history[i - 1], r.history[i]);
    ASSERT_GT(load_times_way, 0.0);
    EXPECT_NEAR(r.summary.worn_volume_lower / (c.wear.lower * load_times_way), 1.0, 1e-9);
    EXPECT_NEAR(r.summary.worn_volume_upper / (c.wear.upper * load_times_way), 1.0, 1e-9);
    EXPECT_NEAR(worn_volume(r.summary.final_state.lower) / r.summary.worn_volume_lower, 1.0, 1e-12);
    EXPECT_NEAR(worn_volume(r.summary.final_state.upper) / r.summary.worn_volume_upper, 1.0, 1e-12);
  }
}

// By friction work the coefficient counts per work: friction 0.2 leaves a fifth.
TEST(TuggingWear, OfFrictionWorkIsThatShareOfIt)
{
  TuggingCase c = balls();
  for (ShapedBody* body : {&c.lower, &c.upper})
    body->material.hardening.reset();
  c.friction.coupling = false;
  c.wear = {.lower = 2e-16, .upper = 1e-16}; // too little to change the pressure
  const WornRun<TuggingCase> by_pressure = worn(c);
  c.wear.kind = elastoplastic::WearLaw::Kind::energy;
  const WornRun<TuggingCase> by_work = worn(c);
  EXPECT_NEAR(by_work.summary.worn_volume_lower / by_pressure.summary.worn_volume_lower, 0.2,
              1e-5); // tolerance of the contact
  c.friction.coefficient = 0.0;
  expect_refused(c, "interface.wear.law", "interface.friction = 0");
}

// Equal bodies are mirror images of each other, whether one of them or both are solved: to the tolerances of the solver.
TEST(TuggingWear, OfEqualBodiesIsTheSame)
{
  TuggingCase c = equal_balls();
  c.passes = 2;
  ASSERT_EQ(plan(c).twin, elastoplastic::Twin::mirror_image);
  const WornRun<TuggingCase> one = worn(c);
  c.solver.mirror = false;
  const WornRun<TuggingCase> both = worn(c);
  for (const WornRun<TuggingCase>* r : {&one, &both})
  {
    const BodySnapshot &lower = r->summary.final_state.lower, &upper = r->summary.final_state.upper;
    ASSERT_EQ(lower.effect("worn_depth").size(), upper.effect("worn_depth").size());
    const SurfaceGrid& grid = lower.grid.surface;
    for (int j = 0; j < grid.ny; ++j)
      for (int i = 0; i < grid.nx; ++i)
        EXPECT_NEAR(lower.effect("worn_depth")[grid.index(i, j)],
                    upper.effect("worn_depth")[grid.index(grid.nx - 1 - i, j)], 1e-4 * r->summary.max_worn_depth_lower);
    EXPECT_EQ(r->summary.worn_volume_lower, r->summary.worn_volume_upper);
  }
  for (std::size_t i = 0; i < one.history.size(); ++i)
  {
    EXPECT_NEAR(one.history[i].F_X, both.history[i].F_X, 1e-4 * both.summary.peak_F_X) << i;
    EXPECT_NEAR(one.history[i].worn_volume_lower, both.history[i].worn_volume_lower,
                1e-4 * both.summary.worn_volume_lower)
        << i;
  }
  EXPECT_NEAR(one.summary.dissipation_lower / both.summary.dissipation_lower, 1.0, 1e-3);
  c.solver.mirror = true;
  c.wear.upper *= 2.0;
  EXPECT_EQ(plan(c).twin, elastoplastic::Twin::none);
}

TEST(TuggingWear, OfNearlyNothingIsTheRunWithout)
{
  TuggingCase c = balls();
  c.wear = {.lower = 1e-40, .upper = 1e-40};
  const WornRun<TuggingCase> nearly = worn(c);
  c.wear = {};
  const WornRun<TuggingCase> without = worn(c);
  ASSERT_EQ(nearly.history.size(), without.history.size());
  for (std::size_t i = 0; i < without.history.size(); ++i)
    EXPECT_EQ(nearly.history[i].F_X, without.history[i].F_X) << i;
  EXPECT_GT(nearly.summary.worn_volume_lower, 0.0);
  EXPECT_TRUE(without.summary.final_state.lower.effect("worn_depth").empty());
}

// The work of the pressure on what is worn is a large part of the whole: left out, the balance would be off by as much.
TEST(TuggingWear, KeepsTheBalanceOfEnergy)
{
  TuggingCase c = balls();
  for (ShapedBody* body : {&c.lower, &c.upper})
    body->material.hardening.reset();
  c.resolution = 8.0;
  c.friction.coefficient = 0.05;
  c.wear = {.lower = 1e-12, .upper = 2e-12};
  const WornRun<TuggingCase> r = worn(c);
  EXPECT_GT(r.summary.work_of_wear, 0.05 * r.summary.work);
  EXPECT_LT(std::abs(r.summary.energy_balance_error), 0.1 * r.summary.work_of_wear / r.summary.work);
}

// What is worn off no longer stands in the way. Where wear removes the pile-up, too, the bodies touch later and part earlier.
TEST(TuggingWear, TakesTheForcesFromPassToPass)
{
  TuggingCase c = balls();
  c.passes = 4;
  c.wear = {.lower = 2e-12, .upper = 2e-12};
  const WornRun<TuggingCase> r = worn(c);
  std::vector<double> peaks(4);
  for (const TuggingRecord& row : r.history)
    peaks.at(static_cast<std::size_t>(row.pass - 1)) =
        std::max(peaks.at(static_cast<std::size_t>(row.pass - 1)), row.F_n);
  for (std::size_t i = 1; i < peaks.size(); ++i)
    EXPECT_LT(peaks[i], 0.8 * peaks[i - 1]) << i;
}

TEST(TuggingWear, GoesOnFromACheckpointToTheLastDigit)
{
  TuggingCase c = balls();
  c.passes = 2;
  expect_taken_up(c);
}

} // namespace
} // namespace brinell::simulation::worn_asperities_test
