// SPDX-License-Identifier: BSD-3-Clause
// The scenario sliding: what it refuses, and that its work and its heat balance.
#include "brinell/simulation/sliding.hpp"

#include "brinell/foundation/error.hpp"
#include "brinell/simulation/run.hpp"
#include "scenario_checks.hpp"
#include "sliding_cases.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <string>

namespace brinell::simulation::sliding_test
{
namespace
{

using Kind = contact::Drive::Kind;
using cases::ball;
using cases::computed;
using cases::SlidingResult;
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

} // namespace
} // namespace brinell::simulation::sliding_test
