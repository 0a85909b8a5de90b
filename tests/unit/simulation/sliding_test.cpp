// SPDX-License-Identifier: BSD-3-Clause
// The scenario sliding: what it refuses, where its strokes go, and what it shares with other scenarios and with itself.
#include "brinell/simulation/sliding.hpp"

#include "brinell/foundation/error.hpp"
#include "brinell/simulation/rolling.hpp"
#include "brinell/simulation/run.hpp"
#include "scenario_checks.hpp"
#include "sliding_cases.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

namespace brinell::simulation::sliding_test
{
namespace
{

using Kind = contact::Drive::Kind;
using cases::ball;
using cases::cell;
using cases::computed;
using cases::hard_steel;
using cases::period;
using cases::SlidingResult;
using cases::soft_steel;
using cases::waves;

TEST(SlidingTest, RefusesWhatHasNoSolution)
{
  EXPECT_NO_THROW(static_cast<void>(plan(waves())));
  EXPECT_NO_THROW(static_cast<void>(plan(ball())));
  expect_refused("lower.shape", "flat lower body", ball(), [](auto& c) { std::swap(c.lower.shape, c.upper.shape); });
  expect_refused("sliding.distance", "= 0 m", waves(), [](auto& c) { c.distance = 0.0; });
  expect_refused("sliding.shift", "up to sliding.distance", waves(), [](auto& c) { c.shift = 1e-3; });
  expect_refused("sliding.shift", "> 0", waves(), [](auto& c) { c.shift = 0.0; });
  expect_refused("sliding.strokes", "= 0", waves(), [](auto& c) { c.strokes = 0; });
  expect_refused("sliding.strokes", "to_and_fro", ball(), [](auto& c) { c.strokes = 2; });
  expect_refused("sliding.press_steps", "= 0", waves(), [](auto& c) { c.press_steps = 0; });
  expect_refused("sliding.mean_gap", "first touch at", waves(), [](auto& c) { c.press = {Kind::mean_gap, 1e-6}; });
  expect_refused("interface.friction", "-0.1", waves(), [](auto& c) { c.friction.coefficient = -0.1; });
  for (const double load : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()})
  {
    SlidingCase c = waves();
    c.press.value = load;
    EXPECT_THROW(static_cast<void>(plan(c)), InputError) << load;
  }
}

TEST(SlidingTest, AFailureBetweenSurfacesThatDoNotHardenSaysWhy)
{
  SlidingCase c;
  c.upper = {Paraboloid{1e-3, 1e-3}, {{210e9, 0.3}, {}}};
  c.press = {contact::Drive::Kind::load, 20.0};
  c.press_steps = 1;
  c.distance = 1e-4;
  c.resolution = 4.0;
  c.friction.coefficient = 0.4;
  c.solver.max_evaluations = 1;
  const auto failure = [&](const constitutive::HardeningLaw& law)
  {
    c.lower = {Plane{}, {{210e9, 0.3}, law}};
    try
    {
      static_cast<void>(run(c));
    }
    catch (const ConvergenceError& error)
    {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_NE(failure(constitutive::PerfectPlasticity{9e8}).find("does not harden"), std::string::npos);
  const std::string of_hardening = failure(constitutive::LinearHardening{9e8, 1e9});
  EXPECT_NE(of_hardening.find("no convergence"), std::string::npos);
  EXPECT_EQ(of_hardening.find("does not harden"), std::string::npos) << of_hardening;
}

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

/// An elastic ball on a flat whose surfaces do not stretch under pressure: the slope under shear does no work then.
SlidingCase incompressible(double stiffness)
{
  SlidingCase c = ball();
  c.lower = {Plane{}, {{210e9, 0.4999}, {}}};
  c.upper.material = {{stiffness * 210e9, 0.4999}, {}};
  c.friction.coefficient = 0.3;
  return c;
}

TEST(SlidingTest, WorkOfASlideIsFrictionTimesLoadTimesDistance)
{
  // Bodies that slide do so under the full shear from the first step on, however few steps there are. The elastic energy of the shear
  // comes from the same work, and becomes heat when the bodies part.
  for (const double stiffness : {1.0, 0.25})
    for (const double steps : {1.0, 3.0})
    {
      SlidingCase c = incompressible(stiffness);
      c.distance = 60e-6;
      c.shift = c.distance / steps;
      const double friction_work = c.friction.coefficient * c.press.value * c.distance;
      const SlidingResult slide = computed(c);
      const SlidingRecord &pressed = slide.history.at(0), &slid = slide.history.at(slide.history.size() - 2);
      const double stored = slid.energy_elastic - pressed.energy_elastic;
      EXPECT_GT(stored, 0.0);
      EXPECT_NEAR((slid.work - pressed.work) / friction_work, 1.0, 1e-4) << stiffness << ", " << steps;
      EXPECT_NEAR((slid.dissipation_friction + stored) / friction_work, 1.0, 1e-4) << stiffness << ", " << steps;
      EXPECT_NEAR(slide.summary.dissipation_friction / friction_work, 1.0, 1e-4) << stiffness << ", " << steps;
    }
}

TEST(SlidingTest, StrokesToAndFroWorkEachAsTheFirst)
{
  SlidingCase c = incompressible(1.0);
  c.distance = 30e-6;
  c.shift = 15e-6;
  c.strokes = 3;
  c.to_and_fro = true;
  const SlidingResult result = computed(c);
  const double friction_work = c.friction.coefficient * c.press.value * c.distance;
  for (std::size_t stroke = 1; stroke <= 3; ++stroke)
    EXPECT_NEAR((result.history.at(2 * stroke).work - result.history.at(2 * stroke - 2).work) / friction_work, 1.0,
                1e-4)
        << stroke;
  EXPECT_NEAR(result.summary.dissipation_friction / (3.0 * friction_work), 1.0, 1e-4);
}

TEST(SlidingTest, HeatOfASlideEntersTheBodiesFromTheFirstStepOn)
{
  SlidingCase c = incompressible(1.0);
  for (ShapedBody* body : {&c.lower, &c.upper})
    body->material.thermal = Thermal{50.0, 7800.0, 470.0, 1.2e-5};
  c.heat.displacement = c.heat.stress = false;
  c.speed = 1.0;
  c.distance = c.shift.emplace(60e-6);
  const SlidingResult slide = computed(c);
  const SlidingRecord &pressed = slide.history.at(0), &slid = slide.history.at(1);
  const double stored = slid.energy_elastic - pressed.energy_elastic;
  EXPECT_NEAR((slid.heat_lower + slid.heat_upper + stored) / (c.friction.coefficient * c.press.value * c.distance), 1.0,
              1e-4);
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
} // namespace brinell::simulation::sliding_test
