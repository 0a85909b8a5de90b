// SPDX-License-Identifier: BSD-3-Clause
// The scenario fretting: what it refuses, and what it shares with an indentation.
#include "brinell/quality/quality.hpp"
#include "brinell/simulation/fretting.hpp"

#include "brinell/simulation/indentation.hpp"
#include "brinell/simulation/run.hpp"
#include "scenario_checks.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

namespace brinell::simulation::fretting_test
{
namespace
{

const constitutive::Material steel{{210e9, 0.3}, constitutive::LinearHardening{1e9, 10e9}};

/// A ball on a flat of the same steel, moved by less than would make all of the contact slide.
FrettingCase sample()
{
  FrettingCase c;
  c.lower = {Plane{}, steel};
  c.upper = {Paraboloid{1e-3, 1e-3}, steel};
  c.press = {contact::Drive::Kind::load, 2.0};
  c.press_steps = 3;
  c.amplitude = 1e-7;
  c.steps_per_cycle = 8;
  c.resolution = 4.0;
  c.friction.coefficient = 0.3;
  return c;
}

template <typename Change>
void expect_refused(const std::string& key, const std::string& part, const Change& change)
{
  expect_refused(key, part, sample(), change);
}

TEST(FrettingTest, RefusesWhatHasNoSolution)
{
  using Kind = FrettingCase::Kind;
  EXPECT_NO_THROW(static_cast<void>(plan(sample())));
  expect_refused("interface.friction", "fretting.displacement = 1e-07 m",
                 [](auto& c) { c.friction.coefficient = 0.0; });
  expect_refused("fretting.displacement", "-1e-07", [](auto& c) { c.amplitude = -1e-7; });
  expect_refused("fretting.displacement", "radius of the contact", [](auto& c) { c.amplitude = 1e-3; });
  expect_refused("fretting.force", "-1", [](auto& c) { c.kind = Kind::force, c.amplitude = -1.0; });
  expect_refused("fretting.force", "below 0.6 N", [](auto& c) { c.kind = Kind::force, c.amplitude = 0.6; });
  expect_refused("fretting.displacement", "error of the approach", [](auto& c) { c.amplitude = 1e-14; });
  expect_refused("fretting.force", "error of the approach", [](auto& c) { c.kind = Kind::force, c.amplitude = 1e-7; });
  expect_refused("interface.friction", "at least 1e-10", [](auto& c) { c.friction.coefficient = 1e-11; });
  expect_refused("fretting.load", "= -2", [](auto& c) { c.press.value = -2.0; });
  expect_refused("fretting.approach", "= 0", [](auto& c) { c.press = {contact::Drive::Kind::approach, 0.0}; });
  expect_refused("fretting.press_steps", "= 0", [](auto& c) { c.press_steps = 0; });
  expect_refused("fretting.steps_per_cycle", "= 6", [](auto& c) { c.steps_per_cycle = 6; });
  expect_refused("fretting.cycles", "= -1", [](auto& c) { c.cycles = -1; });
  expect_refused("fretting.direction", "nan", [](auto& c) { c.direction = std::numeric_limits<double>::quiet_NaN(); });
  expect_refused("interface.friction", "two rigid bodies",
                 [](auto& c)
                 {
                   for (ShapedBody* body : {&c.lower, &c.upper})
                     body->material = {{std::numeric_limits<double>::infinity(), 0.3}, {}};
                 });
}

/// Elastic bodies of one material under an approach, and a force along them.
FrettingCase forced_under_approach()
{
  FrettingCase c = sample();
  c.lower.material.hardening.reset();
  c.upper.material.hardening.reset();
  c.press = {contact::Drive::Kind::approach, 5e-7};
  c.kind = FrettingCase::Kind::force;
  return c;
}

TEST(FrettingTest, AForceThatNoContactUnderTheApproachCanHoldIsRefusedBefore)
{
  // Hertz (1882): 4/3 E' sqrt(R) approach^1.5. Between equal bodies sticking makes no difference; a tenth is left to the cells.
  const double load = 4.0 / 3.0 * contact_modulus(steel.elastic, steel.elastic) * std::sqrt(1e-3) * std::pow(5e-7, 1.5);
  const double stuck = 0.7 * std::log(1.8) / 0.4; // at most, of a Poisson ratio of 0.3: Spence (1968)
  const double most = 1.1 * stuck * 0.3 * load;
  const auto with_force = [](double force)
  {
    FrettingCase c = forced_under_approach();
    c.amplitude = force;
    return c;
  };
  EXPECT_NO_THROW(static_cast<void>(plan(with_force(0.999 * most))));
  expect_refused("fretting.force", "under fretting.approach = 5e-07 m", [&](auto& c) { c = with_force(1.001 * most); });
  FrettingCase rough = with_force(1.001 * most); // touches earlier or later than smooth bodies
  rough.upper.texture = Dent{0.0, 0.0, 1e-8, 1e-5};
  EXPECT_NO_THROW(static_cast<void>(plan(rough)));
}

TEST(FrettingTest, AForceThatFrictionCannotCarryIsNamedWhenItIsFound)
{
  // Near the limit only the run tells the load.
  FrettingCase c = forced_under_approach();
  c.amplitude =
      0.32 * 4.0 / 3.0 * contact_modulus(steel.elastic, steel.elastic) * std::sqrt(1e-3) * std::pow(5e-7, 1.5);
  simulation::Run run(c);
  try
  {
    while (!run.is_done())
      run.step();
    ADD_FAILURE() << "not refused";
  }
  catch (const InputError& error)
  {
    EXPECT_NE(std::string(error.what()).find("friction cannot hold"), std::string::npos) << error.what();
  }
}

TEST(FrettingTest, ARingOfSlipThinnerThanTwoCellsIsWarnedOf)
{
  // Mindlin: the radius of the part that sticks is a sqrt(1 - shift / sliding displacement), and a cbrt(1 - force / (friction load)).
  const auto is_told = [](const FrettingCase& c)
  {
    const std::vector<quality::Warning> list = quality::expected(c, plan(c)).warnings;
    return std::any_of(list.begin(), list.end(), [](const quality::Warning& w) { return w.key == "thin_slip"; });
  };
  const double ring = 0.25;
  FrettingCase shifted = sample(), forced = sample();
  shifted.amplitude = (1.0 - (1.0 - ring) * (1.0 - ring)) * plan(shifted).sliding_displacement;
  forced.kind = FrettingCase::Kind::force;
  forced.amplitude = (1.0 - std::pow(1.0 - ring, 3.0)) * forced.friction.coefficient * forced.press.value;
  for (FrettingCase c : {shifted, forced})
  {
    c.resolution = 0.9 * 2.0 / ring;
    EXPECT_TRUE(is_told(c));
    c.resolution = 1.15 * 2.0 / ring; // an even number of cells may be added to the diameter, or taken from it
    EXPECT_FALSE(is_told(c));
    c.resolution = 4.0;
    c.amplitude = 0.0;
    EXPECT_FALSE(is_told(c));
  }
  shifted.amplitude = 1.1 * plan(shifted).sliding_displacement; // all of it slides
  EXPECT_FALSE(is_told(shifted));
}

TEST(FrettingTest, WithoutMotionItIsAnIndentation)
{
  // Of equal bodies friction holds what does not move: to the last digit; of all without friction.
  for (const bool has_friction : {true, false})
  {
    FrettingCase c = sample();
    c.amplitude = 0.0;
    c.steps_per_cycle = 4;
    c.solver.mirror = false;
    c.solver.symmetry = false; // what may stick is not solved by halves, and the order of sums is one of digits
    if (!has_friction)
    {
      c.friction.coefficient = 0.0;
      c.upper.material.elastic.young_modulus *= 2.0;
    }
    IndentationCase i;
    static_cast<Numerics&>(i) = c;
    i.friction = {};
    i.lower = c.lower;
    i.upper = c.upper;
    i.sequence = {c.press};
    i.steps = c.press_steps;
    const std::vector<FrettingRecord> rows = history(c);
    ASSERT_EQ(rows.size(), 7U);
    simulation::Run run(i);
    for (int step = 0; step < i.steps; ++step)
    {
      const IndentationRecord& r = run.step();
      const FrettingRecord& f = rows[static_cast<std::size_t>(step)];
      EXPECT_EQ(f.F_n, r.F_n);
      EXPECT_EQ(f.approach, r.approach);
      EXPECT_EQ(f.contact_area, r.contact_area);
      EXPECT_EQ(f.max_pressure, r.max_pressure);
      EXPECT_EQ(f.dissipation_lower, r.dissipation_lower);
      if (r.dissipation_lower > 0.0) // before, that of an indentation is exact, and not that of a few steps
      {
        EXPECT_DOUBLE_EQ(f.work, r.work); // summed in another order
      }
    }
    EXPECT_EQ(rows.back().force, 0.0);
    EXPECT_EQ(rows.back().dissipation_friction, 0.0);
    EXPECT_GT(rows.back().dissipation_lower, 0.0);
    // Nothing moves any more, but within the tolerance of the yield condition.
    EXPECT_NEAR(rows.back().dissipation_lower / rows[2].dissipation_lower, 1.0, c.solver.yield_tolerance);
  }
}

TEST(FrettingTest, SmallFrictionOrMotionHasTheSameShape)
{
  // Shears of little friction leave the pressure alone: all of them, and the displacement, are proportional to it. Motion that is
  // small beside what slips meets a stiffness that does not depend on it.
  const constitutive::Material elastic{{210e9, 0.3}, {}}, glass{{70e9, 0.17}, {}};
  for (const constitutive::Material& upper : {elastic, glass})
  {
    const auto cycle = [&](double friction, double amplitude)
    {
      FrettingCase c = sample();
      c.lower.material = elastic;
      c.upper.material = upper;
      c.friction.coefficient = friction;
      c.amplitude = amplitude;
      c.cycles = 1;
      c.resolution = 6.0;
      return history(c);
    };
    const auto at_turn = [&](double friction, double amplitude)
    { return cycle(friction, amplitude)[sample().press_steps + 2U].force; };
    const auto force = [&](double friction) { return at_turn(friction, 2e-7 * friction) / friction; };
    const auto heat = [&](double friction) // of the cycle
    {
      const std::vector<FrettingRecord> rows = cycle(friction, 2e-7 * friction);
      const double of_pressing = rows[static_cast<std::size_t>(sample().press_steps)].dissipation_friction;
      return (rows.back().dissipation_friction - of_pressing) / (friction * friction);
    };
    for (const double friction : {1e-4, 1e-6, 1e-9})
    {
      EXPECT_NEAR(force(friction) / force(1e-3), 1.0, 1e-3) << friction; // ten times the share of the tolerance
      EXPECT_NEAR(heat(friction) / heat(1e-3), 1.0, 3e-3) << friction;
    }
    if (upper == glass) // has shears at their bound from the pressing: what of them sticks grows as the motion falls
      continue;
    const auto stiffness = [&](double amplitude) { return at_turn(0.3, amplitude) / amplitude; };
    for (const double amplitude : {1e-12, 2e-13})
      EXPECT_NEAR(stiffness(amplitude) / stiffness(1e-10), 1.0, 3e-3) << amplitude;
  }
}

TEST(FrettingTest, CyclesBeginAndEndInTheMiddle)
{
  FrettingCase c = sample();
  c.cycles = 2;
  std::vector<FrettingRecord> rows;
  simulation::Run run(c);
  while (!run.is_done())
    rows.push_back(run.step());
  ASSERT_EQ(rows.size(), 19U);
  const double share[] = {0.0, 0.0, 0.0, 0.5, 1.0, 0.5, 0.0, -0.5, -1.0, -0.5, 0.0, 0.5};
  for (std::size_t i = 0; i < std::size(share); ++i)
  {
    EXPECT_NEAR(rows[i].displacement, share[i] * c.amplitude, 1e-15 * c.amplitude);
    EXPECT_EQ(rows[i].cycle, i < 3 ? 0 : (i < 11 ? 1 : 2));
  }
  const FrettingSummary s = run.summary();
  ASSERT_EQ(s.cycles.size(), 2U);
  double heat = 0.0, plastic = rows[2].dissipation_lower + rows[2].dissipation_upper;
  for (const FrettingCycle& cycle : s.cycles)
  {
    heat += cycle.dissipation_friction;
    plastic += cycle.dissipation_plastic;
    EXPECT_GT(cycle.slip_amplitude, 0.0);
    EXPECT_LT(cycle.slip_amplitude, c.amplitude); // what is elastic of it does not slip
    EXPECT_EQ(cycle.max_displacement, c.amplitude);
    EXPECT_GT(cycle.stick_share, 0.0);
    EXPECT_LT(cycle.stick_share, 1.0);
  }
  EXPECT_NEAR(heat / s.dissipation_friction, 1.0, 1e-12);
  EXPECT_NEAR(plastic / (s.dissipation_lower + s.dissipation_upper), 1.0, 1e-12);
  // The area of the second loop, which begins and ends within the steady state: more than that of the polygon of its eight
  // points, beyond which the curve bulges.
  double area = 0.0;
  for (std::size_t i = 11; i < rows.size(); ++i)
    area += 0.5 * (rows[i].force + rows[i - 1].force) * (rows[i].displacement - rows[i - 1].displacement);
  EXPECT_GT(s.cycles[1].work / area, 1.0);
  EXPECT_LT(s.cycles[1].work / area, 1.2);
  EXPECT_EQ(s.final_state.shear[0].size(), s.final_state.pressure.size());
  EXPECT_EQ(s.final_state.slip[1].size(), s.final_state.pressure.size());
}

TEST(FrettingTest, TheDirectionTurnsWithTheCase)
{
  // A round contact on square cells: along y as along x.
  FrettingCase c = sample();
  const FrettingRecord along_x = history(c).back();
  c.direction = 0.5 * std::numbers::pi;
  const FrettingRecord along_y = history(c).back();
  EXPECT_NEAR(along_y.F_y, along_x.F_x, 1e-4 * std::abs(along_x.F_x));
  EXPECT_NEAR(along_y.force, along_x.force, 1e-4 * std::abs(along_x.force));
  EXPECT_NEAR(along_y.F_x, 0.0, 1e-4 * std::abs(along_x.F_x));
  EXPECT_NEAR(along_y.dissipation_friction / along_x.dissipation_friction, 1.0, 1e-3);
  EXPECT_NEAR(along_y.dissipation_lower / along_x.dissipation_lower, 1.0, 1e-3);
}

TEST(FrettingTest, EqualBodiesAreSolvedOnce)
{
  FrettingCase c = sample();
  c.cycles = 2;
  EXPECT_EQ(plan(c).twin, elastoplastic::Twin::mirror_image);
  const std::vector<FrettingRecord> one = history(c);
  c.solver.mirror = false;
  EXPECT_EQ(plan(c).twin, elastoplastic::Twin::none);
  const std::vector<FrettingRecord> both = history(c);
  for (std::size_t i = 0; i < one.size(); ++i)
  {
    EXPECT_NEAR(one[i].force, both[i].force, 1e-4 * std::abs(both[4].force));
    EXPECT_NEAR(one[i].dissipation_friction, both[i].dissipation_friction, 1e-3 * both.back().dissipation_friction);
    EXPECT_NEAR(one[i].dissipation_upper, both[i].dissipation_upper, 1e-3 * both.back().dissipation_upper);
    EXPECT_NEAR(one[i].max_residual_upper, both[i].max_residual_upper, 1e-3 * both.back().max_residual_upper);
  }
  EXPECT_GT(both.back().dissipation_upper, both[2].dissipation_upper);
  c.solver.mirror = true;
  c.direction = 0.1;
  EXPECT_EQ(plan(c).twin, elastoplastic::Twin::none);
}

TEST(FrettingTest, GridsGrowWithTheShear)
{
  FrettingCase c = sample();
  c.upper.material.elastic.young_modulus *= 2.0;
  simulation::Run wide(c);
  while (!wide.is_done())
    wide.step();
  c.extent = 0.5;
  simulation::Run run(c);
  while (!run.is_done())
    run.step();
  const FrettingSummary one = run.summary(), other = wide.summary();
  EXPECT_FALSE(one.grid_changes.empty());
  EXPECT_NEAR(one.dissipation_friction / other.dissipation_friction, 1.0, 2e-3);
  EXPECT_NEAR(one.dissipation_lower / other.dissipation_lower, 1.0, 2e-3);
  EXPECT_NEAR(one.last.slip_path / other.last.slip_path, 1.0, 2e-3);
}

TEST(FrettingTest, SlipAmplitudeIsThatOfThePointThatSlipsMostInTheCycle)
{
  // Bodies that differ slip while they are pressed together, and not where they slip most as they move to and fro.
  FrettingCase c = sample();
  c.lower.material = {{70e9, 0.25}, {}};
  c.upper.material = {{2000e9, 0.0}, {}};
  c.press = {contact::Drive::Kind::load, 20.0};
  c.press_steps = 10;
  c.cycles = 2;
  simulation::Run run(c);
  std::vector<std::vector<double>> paths; // at the end of the pressing and of each cycle
  std::vector<double> largest;
  while (!run.is_done())
  {
    const FrettingRecord r = run.step();
    const int moved = r.step + 1 - c.press_steps;
    if (moved < 0 || moved % c.steps_per_cycle != 0)
      continue;
    paths.push_back(run.fields().surfaces.slip_path);
    largest.push_back(r.slip_path);
  }
  const FrettingSummary summary = run.summary();
  ASSERT_EQ(paths.size(), 3U);
  for (std::size_t cycle = 0; cycle < 2; ++cycle)
  {
    double growth = 0.0;
    for (std::size_t i = 0; i < paths[cycle].size(); ++i)
      growth = std::max(growth, paths[cycle + 1][i] - paths[cycle][i]);
    EXPECT_NEAR(4.0 * summary.cycles[cycle].slip_amplitude / growth, 1.0, 1e-12) << cycle;
    EXPECT_TRUE(cycle > 0 || growth > 1.1 * (largest[cycle + 1] - largest[cycle])) << "the test needs another point";
  }
}

} // namespace
} // namespace brinell::simulation::fretting_test
