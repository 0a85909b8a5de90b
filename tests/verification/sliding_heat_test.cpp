// SPDX-License-Identifier: BSD-3-Clause
#include "record.hpp"
#include "scenario_runs.hpp"
#include "taken_up.hpp"

#include "brinell/simulation/sliding.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

/// The heat of friction between bodies that slide past each other, with and without ends.
namespace brinell::verification::sliding_heat_test
{
namespace
{

using simulation::SlidingCase;
using simulation::SlidingRecord;

constexpr double wavelength = 1e-3;
constexpr Thermal steel{50.0, 7800.0, 470.0, 1.2e-5};

using SlidingRun = Computed<SlidingCase>;

/// Two flats without ends, elastic; one has waves that are nothing, as smooth flats have no first touch.
SlidingCase flats(int cells)
{
  SlidingCase c;
  c.lower = {simulation::Plane{}, {{200e9, 0.3}, {}}};
  c.upper = {simulation::Plane{}, {{200e9, 0.3}, {}}};
  for (simulation::ShapedBody* body : {&c.lower, &c.upper})
    body->material.thermal = steel;
  c.lower.texture = simulation::Sinusoid{1e-12, wavelength, wavelength};
  c.domain.x = c.domain.y = {Boundary::periodic, wavelength, cells};
  c.press = load(1e8 * wavelength * wavelength);
  c.press_steps = 1;
  c.distance = 2.0 * wavelength;
  c.friction.coefficient = 0.2;
  c.speed = 1.0;
  return c;
}

/// Waves on both, of two steels that yield.
SlidingCase rough_bodies(int cells, double speed)
{
  SlidingCase c = flats(cells);
  c.lower.material.hardening = constitutive::LinearHardening{0.6e9, 20e9};
  c.upper.material.hardening = constitutive::LinearHardening{1.2e9, 20e9};
  c.lower.texture = simulation::Sinusoid{4e-6, wavelength, wavelength};
  c.upper.texture = simulation::Sinusoid{2e-6, 0.5 * wavelength, wavelength};
  c.press = load(60.0);
  c.press_steps = 2;
  c.distance = 0.5 * wavelength;
  c.speed = speed;
  return c;
}

/// Temperature of the surface of a half space into which a flux has come, uniform, and constant from step to step [K].
double uniformly_heated(const Thermal& thermal, const std::vector<double>& fluxes, double duration)
{
  const double effusivity2 = thermal.conductivity * thermal.density * thermal.specific_heat;
  double rise = 0.0, before = 0.0;
  for (std::size_t n = 0; n < fluxes.size(); ++n)
  {
    const double since = static_cast<double>(fluxes.size() - n) * duration;
    rise += (fluxes[n] - before) * 2.0 * std::sqrt(since / (std::numbers::pi * effusivity2));
    before = fluxes[n];
  }
  return rise;
}

TEST(SlidingHeat, FlatsWithoutEndsGrowWarmWithTheRootOfTime)
{
  // Nothing but the wave of no number: the flux is uniform, and both bodies share it as their effusivities.
  SlidingCase c = flats(8);
  const Thermal ceramic{20.0, 3200.0, 700.0, 3e-6};
  c.upper.material.thermal = ceramic;
  c.distance = 40.0 * wavelength; // 320 steps
  const SlidingRun run = computed(c);
  const auto effusivity = [](const Thermal& t) { return std::sqrt(t.conductivity * t.density * t.specific_heat); };
  const double share = effusivity(steel) / (effusivity(steel) + effusivity(ceramic));
  const double step = wavelength / 8.0 / *c.speed, flux = 0.2 * 1e8 * *c.speed;
  std::vector<double> fluxes;
  double error = 0.0, rise = 0.0;
  for (const SlidingRecord& r : run.history)
    if (r.F_friction > 0.0)
    {
      fluxes.push_back(share * flux); // all of it from the first step on
      rise = uniformly_heated(steel, fluxes, step);
      error = std::max({error, std::abs((r.max_temperature_lower - 20.0) / rise - 1.0),
                        std::abs((r.max_temperature_upper - 20.0) / rise - 1.0)});
    }
  ASSERT_EQ(fluxes.size(), 320U);
  EXPECT_GT(rise, 100.0);
  // The memory is a sum of exponentials, right to some 1e-5 at each time; it errs alike in all steps.
  test::expect_close("flats without ends, 320 steps: error of both temperatures", error, 0.0, 1e-4,
                     "exact: 2 q sqrt(t/(pi K rho c)) of each step");
  test::expect_close("flats without ends: share of the lower body",
                     run.summary.last.heat_lower / (run.summary.last.heat_lower + run.summary.last.heat_upper), share,
                     1e-4, "exact: by effusivities");
}

TEST(SlidingHeat, AGivenPartitionIsTheShareOfTheLowerBody)
{
  SlidingCase c = flats(8);
  c.heat.partition = 0.3;
  c.heat.fraction = 0.9;
  const SlidingRun run = computed(c);
  const SlidingRecord& last = run.summary.last;
  EXPECT_NEAR(last.heat_lower / last.dissipation_friction, 0.27, 1e-9);
  EXPECT_NEAR(last.heat_upper / last.dissipation_friction, 0.63, 1e-9);
}

TEST(SlidingHeat, FrictionWorkIsHeatInBothBodies)
{
  for (const bool to_and_fro : {false, true})
  {
    SlidingCase c = rough_bodies(slow_build ? 12 : 24, 1.0);
    c.to_and_fro = to_and_fro;
    c.strokes = 2;
    const SlidingRun run = computed(c);
    const SlidingRecord& last = run.summary.last;
    const std::string name = to_and_fro ? "to and fro" : "on and on";
    EXPECT_GT(run.summary.max_temperature[0], 100.0);
    EXPECT_GT(last.dissipation_lower, 0.0);
    test::expect_close("rough bodies, " + name + ": (friction work - heat)/friction work",
                       (last.dissipation_friction - last.heat_lower - last.heat_upper) / last.dissipation_friction, 0.0,
                       1e-3, "exact: all of it is heat");
    // Cells and steps, as without heat.
    test::expect_close("rough bodies, " + name + ": energy unaccounted for / work", run.summary.energy_balance_error,
                       0.0, 1e-2, "exact: work, and work of expansion, is heat, plastic work and stored energy");
  }
}

TEST(SlidingHeat, WithoutSpeedThereIsOnlyFriction)
{
  SlidingCase c = rough_bodies(16, 1e-9);
  const SlidingRun slow = computed(c);
  for (simulation::ShapedBody* body : {&c.lower, &c.upper})
    body->material.thermal.reset();
  const SlidingRun cold = computed(c);
  double error = 0.0, largest = 0.0;
  ASSERT_EQ(slow.history.size(), cold.history.size());
  for (std::size_t n = 0; n < cold.history.size(); ++n)
  {
    error = std::max(error, std::abs(slow.history[n].F_X - cold.history[n].F_X));
    largest = std::max(largest, std::abs(cold.history[n].F_X));
  }
  // The temperature goes with the speed: 1e-9 of some 100 K at 1 m/s.
  test::expect_close("rough bodies: F_X at 1e-9 m/s against friction alone", error / largest, 0.0, 1e-6,
                     "isothermal run");
}

TEST(SlidingHeat, WhereThePeriodBeginsSaysNothing)
{
  constexpr int cells = 16, moved = 5;
  SlidingCase c = rough_bodies(cells, 1.0);
  // An evaluation more or less, by sums in another order, then counts less than the bounds.
  c.solver.yield_tolerance = 1e-7;
  c.solver.displacement_tolerance = 1e-7;
  const SlidingRun one = computed(c);
  for (simulation::ShapedBody* body : {&c.lower, &c.upper})
  {
    auto wave = std::get<simulation::Sinusoid>(body->texture.parts[0]);
    wave.x += moved * wavelength / cells;
    body->texture = wave;
  }
  const SlidingRun other = computed(c);
  ASSERT_EQ(one.history.size(), other.history.size());
  double force = 0.0, temperature = 0.0;
  for (std::size_t n = 0; n < one.history.size(); ++n)
  {
    const SlidingRecord &a = one.history[n], &b = other.history[n];
    force = std::max(force, std::abs(a.F_X - b.F_X) / std::max(1.0, std::abs(a.F_X)));
    temperature = std::max(temperature, std::abs(a.max_temperature_lower - b.max_temperature_lower) /
                                            std::max(1.0, a.max_temperature_lower - 20.0));
  }
  EXPECT_LT(force, 1e-6);
  EXPECT_LT(temperature, 1e-6);
}

TEST(SlidingHeat, ARunThatIsTakenUpGoesOnAsItWas)
{
  SlidingCase c = rough_bodies(12, 1.0);
  c.to_and_fro = true;
  c.strokes = 2;
  simulation::Run<SlidingCase> whole(c), first(c);
  int steps = 0;
  for (; !whole.is_done(); ++steps)
    static_cast<void>(whole.step());
  for (int step = 0; step < steps / 2 + 2; ++step)
    static_cast<void>(first.step());
  const Archive::Fields checkpoint = first.checkpoint();
  expect_same_end(whole, c, checkpoint);
}

TEST(SlidingHeat, OfABallIsThatOfRollingWithoutTurning)
{
  // A ball that slides over a flat, told in two ways.
  simulation::RollingCase rolling = ball_on_flat(track_steel(20e9), 3e9, 0.4e-3);
  rolling.slide_to_roll = 2.0;
  rolling.friction.coefficient = 0.1;
  for (simulation::ShapedBody* body : {&rolling.lower, &rolling.upper})
    body->material.thermal = steel;
  rolling.speed = 1.0;
  rolling.resolution = 4.0;
  SlidingCase sliding;
  static_cast<simulation::Numerics&>(sliding) = rolling;
  sliding.lower = rolling.lower;
  sliding.upper = rolling.upper;
  sliding.press = rolling.drive;
  sliding.press_steps = rolling.load_steps;
  sliding.distance = rolling.distance;
  sliding.speed = rolling.speed;
  const simulation::RollingPlan plan = simulation::plan(rolling);
  sliding.spacing = rolling.spacing = {plan.contact.dx, plan.contact.dy, plan.lower.dz};
  const RollingRun one = computed(rolling);
  const SlidingRun other = computed(sliding);
  double of_rolling = 0.0, of_sliding = 0.0;
  for (const auto& r : one.history)
    of_rolling = std::max(of_rolling, r.max_temperature_lower - 20.0);
  for (const auto& r : other.history)
    of_sliding = std::max(of_sliding, r.max_temperature_lower - 20.0);
  EXPECT_GT(of_rolling, 50.0);
  // Their numbers of steps are rounded in other ways, and what a longer grid knows of heat far away is another lattice of images.
  test::expect_close("ball that slides: rise / that of rolling with slide_to_roll = 2", of_sliding / of_rolling, 1.0,
                     5e-3, "the same bodies in the same motion");
  const auto heat = [](const auto& r) { return r.heat_lower / (r.heat_lower + r.heat_upper); };
  test::expect_close("ball that slides: share of the flat / the same",
                     heat(other.summary.last) / heat(one.summary.last), 1.0, 5e-3,
                     "the same bodies in the same motion");
}

} // namespace
} // namespace brinell::verification::sliding_heat_test
