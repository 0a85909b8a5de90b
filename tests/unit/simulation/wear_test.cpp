// SPDX-License-Identifier: BSD-3-Clause
// Wear in sliding, fretting and rolling: what is refused, and what it shares with itself.
#include "brinell/foundation/error.hpp"
#include "brinell/quality/quality.hpp"
#include "brinell/simulation/fretting.hpp"
#include "brinell/simulation/rolling.hpp"
#include "brinell/simulation/sliding.hpp"
#include "scenario_checks.hpp"
#include "sliding_cases.hpp"
#include "worn_runs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace brinell::simulation::wear_test
{
namespace
{

using Kind = contact::Drive::Kind;
using cases::hard_steel;
using cases::period;
using cases::soft_steel;
using elastoplastic::WearLaw;

/// Waves on both of two steels, in a period, with friction and wear.
SlidingCase waves()
{
  SlidingCase c = cases::waves(15, 4);
  c.friction.coefficient = 0.2;
  c.wear = {.lower = 2e-13, .upper = 1e-13};
  return c;
}

/// A ball on a flat of another steel.
SlidingCase ball()
{
  SlidingCase c;
  c.lower = {Plane{}, soft_steel};
  c.upper = {Paraboloid{1e-3, 1e-3}, hard_steel};
  c.press = {Kind::load, 2.0};
  c.press_steps = 2;
  c.distance = 30e-6;
  c.resolution = 3.0;
  c.friction.coefficient = 0.2;
  c.wear = {.lower = 2e-13, .upper = 1e-13};
  return c;
}

FrettingCase fretting()
{
  FrettingCase c;
  c.lower = {Plane{}, soft_steel};
  c.upper = {Paraboloid{1e-3, 1e-3}, hard_steel};
  c.press = {Kind::load, 2.0};
  c.press_steps = 2;
  c.amplitude = 3e-7;
  c.steps_per_cycle = 8;
  c.resolution = 3.0;
  c.friction.coefficient = 0.3;
  c.wear = {.lower = 4e-13, .upper = 1e-13};
  return c;
}

RollingCase rolling()
{
  RollingCase c;
  c.lower = {Plane{}, soft_steel};
  c.upper = {Paraboloid{1e-3, 1e-3}, hard_steel};
  c.drive = {Kind::load, 2.0};
  c.load_steps = 2;
  c.distance = 30e-6;
  c.resolution = 3.0;
  c.slide_to_roll = 0.4;
  c.friction.coefficient = 0.2;
  c.wear = {.lower = 2e-13, .upper = 1e-13};
  return c;
}

TEST(WearTest, IsRefusedWhereItMakesNoSense)
{
  SlidingCase s = waves();
  s.wear.lower = -1e-15;
  expect_refused(s, "interface.wear.lower", "-1e-15");
  s = waves();
  s.wear.upper = std::numeric_limits<double>::infinity();
  expect_refused(s, "interface.wear.upper", "inf");
  s = waves();
  s.wear.kind = WearLaw::Kind::energy;
  s.friction.coefficient = 0.0;
  expect_refused(s, "interface.wear.law", "interface.friction = 0");
  RollingCase r = rolling();
  r.slide_to_roll = 0.0;
  r.friction.coefficient = 0.0;
  r.wear.lower = 0.0;
  expect_refused(r, "interface.wear.upper", "rolling.slide_to_roll = 0");
  FrettingCase f = fretting();
  f.amplitude = 0.0;
  expect_refused(f, "interface.wear.lower", "the surfaces do not slide");
  f = fretting();
  f.cycles = 0;
  expect_refused(f, "interface.wear.lower", "the surfaces do not slide");
}

// Under a mean gap that is kept the load changes, and the volume is coefficient x load x way step by step.
TEST(WearTest, OfSlidingAtAMeanGapKeepsTheGap)
{
  SlidingCase c = waves();
  c.lower.material.hardening.reset();
  c.upper.material.hardening.reset();
  const double gap = worn(c).history.at(1).mean_gap;
  c.press = {Kind::mean_gap, gap};
  c.wear = {.lower = 2e-12, .upper = 1e-12}; // a step wears a tenth of the gap
  const WornRun<SlidingCase> r = worn(c);
  double load_times_way = 0.0;
  for (std::size_t i = 1; i < r.history.size(); ++i)
    if (const double moved = r.history[i].way - r.history[i - 1].way; moved > 0.0)
    {
      load_times_way += r.history[i].F_n * moved;
      EXPECT_NEAR(r.history[i].mean_gap, gap, 1e-6 * gap) << i; // tolerance of the contact
      EXPECT_GT(r.history[i].approach, r.history[i - 1].approach) << i;
    }
  ASSERT_GT(r.summary.max_wear_step, 0.01 * gap);
  EXPECT_NEAR(r.summary.worn_volume_lower / (c.wear.lower * load_times_way), 1.0, 1e-9);
  EXPECT_NEAR(r.summary.worn_volume_upper / (c.wear.upper * load_times_way), 1.0, 1e-9);
  // Over the period the worn depths in the mean are what the mean planes have come together by.
  const double area = period * period;
  const double depth = (r.summary.worn_volume_lower + r.summary.worn_volume_upper) / area;
  const std::size_t last = r.history.size() - 1 - static_cast<std::size_t>(c.press_steps);
  EXPECT_NEAR(r.history.at(last).approach - r.history.at(1).approach, depth, 1e-5 * gap);
  EXPECT_LT(std::abs(r.summary.energy_balance_error), 0.1 * r.summary.work_of_wear / r.summary.work);
}

// Of what slides everywhere under a constant load the volume is coefficient x load x way, however it is shared out.
TEST(WearTest, OfSlidingBalancesLoadTimesWay)
{
  for (SlidingCase c : {waves(), ball()})
  {
    c.shift = 0.7 * (c.domain.is_periodic() ? period / 15 : 5e-6); // between the columns of the upper body
    const WornRun<SlidingCase> r = worn(c);
    const double way = r.history.back().way, load = c.press.value;
    EXPECT_NEAR(r.history.back().worn_volume_lower / (c.wear.lower * load * way), 1.0, 1e-12);
    EXPECT_NEAR(r.history.back().worn_volume_upper / (c.wear.upper * load * way), 1.0, 1e-12);
    const Snapshot& end = r.summary.final_state;
    EXPECT_NEAR(worn_volume(end.lower) / r.history.back().worn_volume_lower, 1.0, 1e-12);
    EXPECT_NEAR(worn_volume(end.upper) / r.history.back().worn_volume_upper, 1.0, 1e-12);
    for (const BodySnapshot* body : {&end.lower, &end.upper})
      EXPECT_GE(*std::min_element(body->effect("worn_depth").begin(), body->effect("worn_depth").end()), 0.0);
    EXPECT_EQ(r.summary.max_worn_depth_lower,
              *std::max_element(end.lower.effect("worn_depth").begin(), end.lower.effect("worn_depth").end()));
    EXPECT_GT(r.summary.work_of_wear, 0.0);
  }
}

TEST(WearTest, OfRollingBalancesLoadTimesSlip)
{
  const RollingCase c = rolling();
  const WornRun<RollingCase> r = worn(c);
  // Under load alone the surfaces slip by (1 - share) times the way: load steps press, and nothing slides in them.
  const double slipped = (1.0 - upper_share(c)) * c.distance;
  const RollingPlan p = plan(c);
  EXPECT_NEAR(p.rolling_steps * p.shift, c.distance, 0.5 * p.shift * 2.0);
  const double way = slipped * p.rolling_steps * p.shift / c.distance;
  EXPECT_NEAR(r.summary.worn_volume_lower / (c.wear.lower * c.drive.value * way), 1.0, 1e-12);
  EXPECT_NEAR(worn_volume(r.summary.final_state.lower) / r.summary.worn_volume_lower, 1.0, 1e-12);
  EXPECT_NEAR(worn_volume(r.summary.final_state.upper) / r.summary.worn_volume_upper, 1.0, 1e-12);
  EXPECT_NEAR(r.summary.worn_volume_lower, 2.0 * r.summary.worn_volume_upper, 1e-12 * r.summary.worn_volume_lower);
}

// With the energy law the volume is coefficient x heat of friction: of the work of the shear at the end of each increment, so to
// first order in the step.
TEST(WearTest, OfFrictionWorkFollowsTheHeat)
{
  SlidingCase s = waves();
  s.wear.kind = WearLaw::Kind::energy;
  const WornRun<SlidingCase> slid = worn(s);
  double work = 0.0; // of a constant load, but for what the shear does on the deformation
  for (std::size_t i = 1; i < slid.history.size(); ++i)
    work += slid.history[i].F_friction * (slid.history[i].way - slid.history[i - 1].way);
  EXPECT_NEAR(slid.summary.worn_volume_lower / (s.wear.lower * work), 1.0, 1e-12);

  FrettingCase f = fretting();
  f.wear.kind = WearLaw::Kind::energy;
  f.steps_per_cycle = 40;
  f.lower.material.hardening.reset();
  f.upper.material.hardening.reset();
  const WornRun<FrettingCase> fretted = worn(f);
  EXPECT_NEAR(fretted.summary.worn_volume_lower / (f.wear.lower * fretted.summary.dissipation_friction), 1.0, 0.03);
}

TEST(WearTest, GoesOnFromACheckpointToTheLastDigit)
{
  expect_taken_up(waves());
  expect_taken_up(ball());
  expect_taken_up(fretting());
  expect_taken_up(rolling());
}

// What does not wear keeps its surface; and without wear nothing has changed, to the last digit.
TEST(WearTest, LeavesAloneWhatHasNoCoefficient)
{
  SlidingCase one = ball();
  one.wear.lower = 0.0;
  const WornRun<SlidingCase> r = worn(one);
  EXPECT_EQ(r.summary.worn_volume_lower, 0.0);
  EXPECT_EQ(r.summary.max_worn_depth_lower, 0.0);
  EXPECT_GT(r.summary.worn_volume_upper, 0.0);
  SlidingCase none = ball();
  none.wear = {};
  const WornRun<SlidingCase> without = worn(none);
  EXPECT_TRUE(without.summary.final_state.lower.effect("worn_depth").empty());
  EXPECT_EQ(without.summary.work_of_wear, 0.0);
}

// Mirror images that wear alike, whether one of them or both are solved: to the tolerances of the solver.
TEST(WearTest, OfMirrorImagesInFrettingIsTheSame)
{
  FrettingCase c = fretting();
  c.lower = c.upper = {Paraboloid{1e-3, 1e-3}, soft_steel};
  c.wear = {.lower = 2e-13, .upper = 2e-13};
  ASSERT_EQ(plan(c).twin, elastoplastic::Twin::mirror_image);
  const WornRun<FrettingCase> one = worn(c);
  c.solver.mirror = false;
  const WornRun<FrettingCase> both = worn(c);
  for (std::size_t i = 0; i < one.history.size(); ++i)
    EXPECT_NEAR(one.history[i].force, both.history[i].force, 1e-4 * c.friction.coefficient * c.press.value) << i;
  EXPECT_GT(both.summary.dissipation_lower, 0.0);
  EXPECT_NEAR(one.summary.dissipation_lower / both.summary.dissipation_lower, 1.0, 1e-3);
  EXPECT_NEAR(one.summary.worn_volume_lower / both.summary.worn_volume_lower, 1.0, 1e-4);
  EXPECT_NEAR(one.summary.max_worn_depth_upper / both.summary.max_worn_depth_upper, 1.0, 1e-3);
  c.solver.mirror = true;
  c.wear.upper = 1e-13;
  EXPECT_EQ(plan(c).twin, elastoplastic::Twin::none);
}

// A coefficient so small that nothing it wears is seen by a double gives the run without wear, through all of its arithmetic.
TEST(WearTest, OfNearlyNothingIsTheRunWithout)
{
  FrettingCase c = fretting();
  c.solver.mirror = false;
  c.wear = {.lower = 1e-40, .upper = 1e-40};
  const WornRun<FrettingCase> nearly = worn(c);
  c.wear = {};
  const WornRun<FrettingCase> without = worn(c);
  for (std::size_t i = 0; i < without.history.size(); ++i)
  {
    EXPECT_EQ(nearly.history[i].force, without.history[i].force) << i;
    EXPECT_EQ(nearly.history[i].approach, without.history[i].approach) << i;
    EXPECT_EQ(nearly.history[i].dissipation_lower, without.history[i].dissipation_lower) << i;
  }
  EXPECT_GT(nearly.summary.worn_volume_lower, 0.0);
}

TEST(WearTest, MirrorsWithTheBodies)
{
  const SlidingCase c = waves();
  const WornRun<SlidingCase> upright = worn(c);
  SlidingCase s = c;
  // Upside down the upper body slides the other way: turned about the vertical axis as well, it is the same run.
  std::swap(s.lower, s.upper);
  std::swap(s.wear.lower, s.wear.upper);
  for (ShapedBody* body : {&s.lower, &s.upper})
    std::get<Sinusoid>(body->texture.parts.front()).x *= -1.0;
  const WornRun<SlidingCase> turned = worn(s);
  const double volume = upright.summary.worn_volume_lower;
  EXPECT_NEAR(turned.summary.worn_volume_upper, volume, 1e-12 * volume);
  // The tolerances of the solver.
  EXPECT_NEAR(turned.summary.max_worn_depth_upper / upright.summary.max_worn_depth_lower, 1.0, 1e-3);
  EXPECT_NEAR(turned.summary.max_worn_depth_lower / upright.summary.max_worn_depth_upper, 1.0, 1e-3);
}

TEST(WearTest, KeepsTheBalanceOfEnergy)
{
  SlidingCase c = ball();
  c.lower.material.hardening.reset();
  c.upper.material.hardening.reset();
  c.wear = {.lower = 0.0, .upper = 4e-12};
  const WornRun<SlidingCase> r = worn(c);
  // The work of the pressure on what is worn is a large part of the whole: left out, the balance would be off by as much.
  EXPECT_GT(r.summary.work_of_wear, 0.01 * r.summary.work);
  EXPECT_LT(std::abs(r.summary.energy_balance_error), 0.1 * r.summary.work_of_wear / r.summary.work);
}

// Where wear ends, the gap has a kink, which only two open cells beside the contact tell from an elastic edge: the grid grows to
// have them. Left with one, the area on these grids is 4 % and 2 % smaller.
TEST(WearTest, AreaOfAScarDoesNotDependOnTheSizeOfTheGrid)
{
  FrettingCase c = fretting();
  c.lower.material = c.upper.material = {{210e9, 0.3}, {}};
  c.upper.shape = Paraboloid{10e-3, 10e-3};
  c.press.value = 50.0;
  c.amplitude = 4e-6;
  c.steps_per_cycle = 32;
  c.cycles = 3;
  c.friction.coefficient = 0.6;
  c.wear = {.lower = 2e-11, .upper = 2e-11};
  for (const double resolution : {4.0, 5.0})
  {
    c.resolution = resolution;
    c.extent = 1.0;
    const WornRun<FrettingCase> usual = worn(c);
    c.extent = 1.6;
    const WornRun<FrettingCase> wide = worn(c);
    EXPECT_FALSE(usual.summary.grid_changes.empty());
    EXPECT_NEAR(usual.history.back().contact_area / wide.history.back().contact_area, 1.0, 1e-4) << resolution;
  }
}

TEST(WearTest, IsToldWhereItIsAnEstimate)
{
  SlidingCase c = ball();
  c.wear = {.lower = 0.0, .upper = 1e-10};
  const WornRun<SlidingCase> r = worn(c);
  const quality::Quality q = quality::judged(c, plan(c), r.summary);
  const auto has = [&](const std::string& key) {
    return std::any_of(q.warnings.begin(), q.warnings.end(), [&](const quality::Warning& w) { return w.key == key; });
  };
  EXPECT_TRUE(has("long_wear_step"));
  const quality::Quality usual = quality::judged(ball(), plan(ball()), worn(ball()).summary);
  for (const quality::Warning& w : usual.warnings)
    EXPECT_NE(w.key, "long_wear_step") << w.text;
}

TEST(WearTest, CoatsThatAreWornThinAreTold)
{
  struct Told
  {
    double share; ///< worn depth over the thickness of the coat
    std::vector<std::string> keys, texts;
  };
  const auto told_of = [](double coefficient, double modulus, double thickness = 10e-6, double conductivity = 0.0)
  {
    SlidingCase c = ball();
    c.lower.material = {{210e9, 0.3}, {}};
    c.lower.material.layers = {{thickness, {modulus, 0.3}}};
    c.upper.material.hardening.reset();
    c.wear = {.lower = coefficient, .upper = 0.0};
    if (conductivity > 0.0)
    {
      c.lower.material.thermal = c.upper.material.thermal = Thermal{50.0, 7800.0, 470.0, 0.0};
      c.lower.material.layers.front().thermal = Thermal{conductivity, 2000.0, 900.0, 0.0};
      c.speed = 1.0;
    }
    const WornRun<SlidingCase> r = worn(c);
    Told told{r.history.back().max_worn_depth_lower / thickness, {}, {}};
    for (const quality::Warning& w : quality::judged(c, plan(c), r.summary).warnings)
      if (w.key.starts_with("worn_"))
      {
        told.keys.push_back(w.key);
        told.texts.push_back(w.text);
      }
    return told;
  };
  using Keys = std::vector<std::string>;
  const Told little = told_of(1e-13, 420e9);
  EXPECT_GT(little.share, 0.0);
  EXPECT_LT(little.share, 0.002);
  EXPECT_EQ(little.keys, Keys{});
  for (const auto& [modulus, word] : {std::pair{420e9, "more than"}, {70e9, "less than"}})
  {
    const Told much = told_of(3e-11, modulus);
    EXPECT_GT(much.share, 0.02);
    ASSERT_EQ(much.keys, Keys{"worn_coat"}) << much.share;
    EXPECT_NE(much.texts[0].find(word), std::string::npos) << much.texts[0];
  }
  EXPECT_EQ(told_of(3e-11, 211e9).keys, Keys{}); // nearly the substrate
  const Told insulating = told_of(3e-11, 210.5e9, 10e-6, 1.0);
  ASSERT_EQ(insulating.keys, Keys{"worn_coat"}); // of elastic constants that hardly matter
  EXPECT_NE(insulating.texts[0].find("warms by up to"), std::string::npos) << insulating.texts[0];
  EXPECT_NE(insulating.texts[0].find("less than it is computed"), std::string::npos) << insulating.texts[0];
  EXPECT_EQ(insulating.texts[0].find("gives way"), std::string::npos) << insulating.texts[0];
  const Told all = told_of(1e-9, 420e9, 4e-6);
  EXPECT_GT(all.share, 1.0);
  EXPECT_EQ(all.keys, Keys{"worn_through"});
}

} // namespace
} // namespace brinell::simulation::wear_test
