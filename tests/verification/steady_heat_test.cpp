// SPDX-License-Identifier: BSD-3-Clause
#include "record.hpp"
#include "scenario_runs.hpp"

#include "brinell/foundation/error.hpp"
#include "brinell/io/member_keys.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

/// The steady regime: bodies that swell, yield and soften under a source that has always moved as it does.
namespace brinell::verification::steady_heat_test
{
namespace
{

using elastoplastic::HeatRegime;
using simulation::RollingCase;
using simulation::RollingRecord;

/// The skidding ball of cases/rolling-heat on coarser cells, that softens; over so many half-lengths of its contact.
RollingCase skidding_ball(HeatRegime regime, double half_widths)
{
  RollingCase c = ball_on_flat(elastic_material(), 3.4e9, 1e-3);
  for (simulation::ShapedBody* body : {&c.lower, &c.upper})
  {
    body->material.elastic = {210e9, 0.3};
    body->material.hardening = constitutive::LinearHardening{1.6e9, 20e9};
    body->material.thermal = Thermal{45.0, 7800.0, 470.0, 12e-6};
    body->material.temperature = 80.0;
    body->material.softening = constitutive::LinearSoftening{80.0, 1500.0};
  }
  c.slide_to_roll = 0.1;
  c.speed = 2.0;
  c.friction.coefficient = 0.15;
  c.resolution = slow_build ? 3.0 : 4.0;
  c.heat.regime = regime;
  c.heat.of_plastic_work = 0.0;
  c.distance = half_widths * simulation::plan(c).half_width_x;
  return c;
}

/// In the middle of the last quarter of the track, under full load.
const RollingRecord& late(const RollingRun& run, double distance)
{
  return *std::min_element(run.history.begin(), run.history.end(),
                           [&](const RollingRecord& a, const RollingRecord& b)
                           { return std::abs(a.x - 0.375 * distance) < std::abs(b.x - 0.375 * distance); });
}

TEST(SteadyHeat, ASkiddingBallAfterALongWay)
{
  const RollingCase transient = skidding_ball(HeatRegime::transient, 8.0);
  RollingCase steady = transient;
  steady.heat.regime = HeatRegime::steady;
  const RollingRun long_way = computed(transient), always = computed(steady);
  const RollingRecord &a = late(long_way, transient.distance), &b = late(always, transient.distance);
  const std::string origin = "where transient heat ends: V^2 t/4 kappa above 100";
  const double rise = a.max_temperature_lower - 80.0;
  EXPECT_GT(rise, 30.0);
  test::expect_close("largest rise of the lower surface, steady / transient", (b.max_temperature_lower - 80.0) / rise,
                     1.0, 5e-3, origin);
  test::expect_close("largest rise of the upper surface, steady / transient",
                     (b.max_temperature_upper - 80.0) / (a.max_temperature_upper - 80.0), 1.0, 5e-3, origin);
  test::expect_close("approach, steady / transient", b.approach / a.approach, 1.0, 2e-3, origin);
  test::expect_close("resistance, steady / transient", b.F_X / a.F_X, 1.0, 2e-2, origin);
  const auto& pass = long_way.summary.passes.front();
  const auto& other = always.summary.passes.front();
  test::expect_close("rut, steady / transient", other.rut_depth / pass.rut_depth, 1.0, 1e-2, origin);
  test::expect_close("plastic strain of the track, steady / transient",
                     other.track_plastic_strain / pass.track_plastic_strain, 1.0, 1e-2, origin);

  // What heat does at all is far more than what both differ by.
  RollingCase cold = steady;
  cold.heat.fraction = 0.0;
  const RollingRun without = computed(cold);
  const double effect = late(without, cold.distance).approach - b.approach;
  EXPECT_GT(std::abs(effect), 3.0 * std::abs(a.approach - b.approach));
  std::printf("approach: without heat %.6g, steady %.6g, transient %.6g m\n", late(without, cold.distance).approach,
              b.approach, a.approach);
}

/// An elastic ball that does not turn and keeps all of the heat that is given to it.
RollingCase resting_ball(double reference)
{
  RollingCase c = skidding_ball(HeatRegime::steady, 2.0);
  for (simulation::ShapedBody* body : {&c.lower, &c.upper})
  {
    body->material.hardening = {};
    body->material.softening = {};
  }
  c.drive = load(100.0);
  c.slide_to_roll = 2.0;
  c.speed = 0.1;
  c.heat.partition = 0.0;
  c.heat.reference = reference;
  return c;
}

TEST(SteadyHeat, TheReferenceOfABodyThatRests)
{
  // Under a load the distance at which its surface counts as not displaced moves the approach alone.
  const RollingCase near = resting_ball(10e-3), far = resting_ball(20e-3);
  const RollingRun one = computed(near), other = computed(far);
  const RollingRecord &a = late(one, near.distance), &b = late(other, far.distance);
  const double flow = near.friction.coefficient * 100.0 * *near.speed; // all of it into the ball
  const double shift = 1.3 * 12e-6 * flow * std::log(2.0) / (2.0 * 3.14159265358979323846 * 45.0);
  test::expect_close("approach by the reference of a ball at rest, 20 mm less 10 mm",
                     (b.approach - a.approach) / -shift, 1.0, 1e-3,
                     "exact: Barber (1971), (1 + nu) alpha Q ln 2/(2 pi K)");
  EXPECT_NEAR(b.max_pressure / a.max_pressure, 1.0, 1e-5);
  EXPECT_NEAR(b.max_temperature_upper, a.max_temperature_upper, 1e-6 * a.max_temperature_upper);
}

/// The contact grid follows the contact by whole columns, the heat does as the contact moves.
TEST(SteadyHeat, OfStepsThatAreNoWholeCells)
{
  RollingCase c = resting_ball(10e-3);
  c.heat.partition = 1.0; // all of it into the lower body, over which the contact moves
  c.speed = 2.0;
  const RollingRun whole = computed(c);
  const double cell = simulation::plan(c).contact.dx, rise = late(whole, c.distance).max_temperature_lower - 80.0;
  EXPECT_GT(rise, 10.0);
  for (const double columns : {0.5, 0.8, 1.5})
  {
    c.shift = columns * cell;
    const RollingRun other = computed(c);
    for (const RollingRecord& r : other.history)
      if (std::abs(r.x) < 0.4 * c.distance)
      {
        // To the cells, on which the contact lies otherwise from step to step.
        EXPECT_NEAR((r.max_temperature_lower - 80.0) / rise, 1.0, 0.04) << columns << " columns, x = " << r.x;
      }
  }
}

// A source passes the bodies while they are pressed together and part as it does while they roll. At rest it would be hotter by the
// root of the Peclet number, 70, and that would be the largest temperature of the run, and what yields.
TEST(SteadyHeat, ASourceNeverRests)
{
  RollingCase c = resting_ball(10e-3);
  c.friction.coefficient = 0.0;
  c.slide_to_roll = 0.0;
  c.speed = 20.0;
  c.heat.partition.reset();
  c.heat.reference.reset();
  c.heat.displacement = false;
  using Source = elastoplastic::HeatSource;
  c.heat.source = {.shape = Source::Shape::disc, .on = Source::Side::lower, .power = 50.0, .radius = 0.1e-3};
  const RollingRun run = computed(c);
  double rolling = 0.0, all = 0.0;
  for (std::size_t i = 0; i + 1 < run.history.size(); ++i) // in the last step the source is off
  {
    const double rise = run.history[i].max_temperature_lower - 80.0;
    const bool rolls = i >= 6 && i + 6 < run.history.size();
    (rolls ? rolling : all) = std::max(rolls ? rolling : all, rise);
  }
  EXPECT_GT(rolling, 10.0);
  EXPECT_LE(all, rolling * (1.0 + 1e-3));
  EXPECT_NEAR(run.summary.max_temperature[0] - 80.0, rolling, 1e-9 * rolling);
  // At rest: q a/K.
  EXPECT_LT(rolling, 0.2 * 50.0 / (3.14159265358979323846 * 0.1e-3 * 45.0));
}

// The shear of surfaces that hardly slide is set free as they part, within the time of a cell: the finer the cells, the hotter.
TEST(SteadyHeat, TheLargestTemperatureIsThatOfTheMotion)
{
  RollingCase c = skidding_ball(HeatRegime::transient, 4.0);
  for (simulation::ShapedBody* body : {&c.lower, &c.upper})
  {
    body->material.hardening = {};
    body->material.softening = {};
  }
  c.drive = load(100.0);
  c.resolution = 8.0;
  c.slide_to_roll = 0.005;
  c.speed = 50.0;
  c.friction.coefficient = 0.3;
  const RollingRun run = computed(c);
  double rolling = 0.0, all = 0.0;
  for (std::size_t i = 0; i < run.history.size(); ++i)
  {
    const double rise = run.history[i].max_temperature_upper - 80.0;
    all = std::max(all, rise);
    if (i + static_cast<std::size_t>(c.load_steps) < run.history.size())
      rolling = std::max(rolling, rise);
  }
  EXPECT_GT(all, 1.3 * rolling);
  EXPECT_NEAR(run.summary.max_temperature[1] - 80.0, rolling, 1e-9 * rolling);
}

TEST(SteadyHeat, WhatThereIsNotIsRefused)
{
  const auto refused = [](const RollingCase& c, const std::string& part)
  {
    try
    {
      static_cast<void>(simulation::plan(c));
      ADD_FAILURE() << "not refused: " << part;
    }
    catch (const InputError& error)
    {
      EXPECT_NE(io::with_keys(error.what()).find(part), std::string::npos) << error.what();
    }
  };
  RollingCase c = resting_ball(10e-3);
  c.heat.reference.reset();
  refused(c, "thermal.reference is missing");
  c.heat.displacement = false;
  static_cast<void>(simulation::plan(c));
  c = resting_ball(0.0);
  refused(c, "thermal.reference = 0 m; allowed: > 0, or none");
  // Heat that passes between bodies of different temperatures moves over both of them, also while they are pressed together.
  c = skidding_ball(HeatRegime::steady, 2.0);
  c.upper.material.temperature = 120.0;
  static_cast<void>(simulation::plan(c));
  c.upper.shape = simulation::Roller{10e-3, std::numeric_limits<double>::infinity()};
  c.domain.y = {Boundary::periodic, 1e-3, 1};
  static_cast<void>(simulation::plan(c));
  c = skidding_ball(HeatRegime::steady, 2.0);
  c.heat.of_plastic_work = 0.9;
  refused(c, "allowed: thermal.heat_of_plastic_work = 0, or \"transient\"");
}

TEST(SteadyHeat, GoesOnFromACheckpointToTheLastDigit)
{
  // At 0.9 the shear reaches the limit of the softened surfaces.
  for (const auto& [regime, coefficient] : {std::pair{HeatRegime::steady, 0.15}, {HeatRegime::transient, 0.9}})
  {
    RollingCase c = skidding_ball(regime, 1.5);
    c.resolution = 3.0;
    c.friction.coefficient = coefficient;
    simulation::Run<RollingCase> whole(c);
    std::vector<Archive::Fields> checkpoints;
    while (!whole.is_done())
    {
      whole.step();
      checkpoints.push_back(whole.checkpoint());
    }
    for (std::size_t step = 0; step + 1 < checkpoints.size(); ++step)
    {
      simulation::Run<RollingCase> later(c, {}, &checkpoints[step]);
      later.step();
      const Archive::Fields now = later.checkpoint();
      for (const auto& [name, values] : checkpoints[step + 1])
        EXPECT_TRUE(now.at(name) == values) << name << ", from step " << step << " on";
    }
  }
}

TEST(SteadyHeat, Energy)
{
  const RollingRun run = computed(skidding_ball(HeatRegime::steady, 3.0));
  EXPECT_LT(std::abs(run.summary.energy_balance_error), 5e-3);
}

} // namespace
} // namespace brinell::verification::steady_heat_test
