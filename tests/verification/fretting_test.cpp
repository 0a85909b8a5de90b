// SPDX-License-Identifier: BSD-3-Clause
#include "order.hpp"
#include "record.hpp"
#include "scenario_runs.hpp"

#include "brinell/simulation/fretting.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>
#include <string>
#include <vector>

/// Pressed bodies that are moved to and fro: closed forms of elastic ones, balance of energy, shakedown.
namespace brinell::verification::fretting_test
{
namespace
{

using simulation::FrettingCase;
using simulation::FrettingRecord;
using simulation::FrettingSummary;

using FrettingRun = Computed<FrettingCase>;

/// Two elastic balls of 1 m without Poisson's effect: Mindlin's solutions are exact then.
FrettingCase elastic_balls(double cells)
{
  FrettingCase c;
  c.lower = c.upper = {ball(1.0), {{200e9, 0.0}, {}}};
  c.press = load(1e5);
  c.press_steps = 1;
  c.friction.coefficient = 0.5;
  c.resolution = cells;
  c.steps_per_cycle = 16;
  c.cycles = 2;
  return c;
}

/// Displacement at which two equal balls slide everywhere: Mindlin (1949).
double sliding_displacement(const FrettingCase& c)
{
  const double E = c.lower.material.elastic.young_modulus, P = c.press.value, R = 0.5; // of the pair
  const double a = std::cbrt(0.75 * P * R / (0.5 * E));
  return 3.0 / 4.0 * c.friction.coefficient * P / (0.5 * E * a);
}

/// Force over friction times load: on first loading Cattaneo, Mindlin; afterwards Mindlin, Deresiewicz (1953).
/// @param x  displacement, and @param A its amplitude, over that at which all slides
double mindlin(double x, double A, bool is_first, int way)
{
  const auto virgin = [](double d) { return 1.0 - std::pow(1.0 - d, 1.5); };
  if (is_first)
    return virgin(x);
  return way < 0 ? virgin(A) - 2.0 * virgin(0.5 * (A - x)) : -virgin(A) + 2.0 * virgin(0.5 * (A + x));
}

TEST(Fretting, ElasticLoopIsThatOfMindlin)
{
  // The force is an integral of the shear, whose error is that of both rims: a root times a strip as wide as the cell, order 1.5. The
  // heat is exact for what the steps find, as bound and direction stay.
  std::vector<double> force_errors, heat_errors, stick_errors, slip_errors;
  for (const double cells : {8.0, 16.0, 32.0})
  {
    FrettingCase c = elastic_balls(cells);
    const double limit = c.friction.coefficient * c.press.value, to_slide = sliding_displacement(c);
    const double A = 0.7;
    c.amplitude = A * to_slide;
    EXPECT_NEAR(simulation::plan(c).sliding_displacement / to_slide, 1.0, 1e-6);
    const FrettingRun run = computed(c);
    double worst = 0.0;
    for (std::size_t i = 1; i < run.history.size(); ++i)
    {
      const FrettingRecord& r = run.history[i];
      const double way = r.displacement - run.history[i - 1].displacement;
      const double exact = mindlin(r.displacement / to_slide, A, i <= 4, way < 0.0 ? -1 : 1);
      worst = std::max(worst, std::abs(r.force / limit - exact));
      EXPECT_NEAR(r.F_y, 0.0, 1e-6 * limit);
    }
    force_errors.push_back(worst);
    const double Q = mindlin(A, A, true, 1);
    const double exact = 4.8 * to_slide * limit *
                         (1.0 - std::pow(1.0 - Q, 5.0 / 3.0) - 5.0 / 6.0 * Q * (1.0 + std::pow(1.0 - Q, 2.0 / 3.0)));
    heat_errors.push_back(run.summary.cycles[1].dissipation_friction / exact - 1.0);
    const FrettingRecord& turn = run.history[4];
    stick_errors.push_back(std::sqrt(turn.stick_share) / std::sqrt(1.0 - A) - 1.0);
    const double k = std::sqrt(1.0 - A); // stick radius over that of the contact
    const double rim = (1.0 - 2.0 / std::numbers::pi * std::asin(k)) * (1.0 - 2.0 * k * k) +
                       2.0 / std::numbers::pi * k * std::sqrt(1.0 - k * k);
    slip_errors.push_back(run.summary.cycles[1].slip_amplitude / (0.5 * to_slide * rim) - 1.0);
    // At the cell farthest out: at most a cell from the rim, of which it jumps with the cells an edge happens to touch. There the
    // slip grows by about itself per radius.
    EXPECT_LT(std::abs(slip_errors.back()), 1.0 / cells);
    EXPECT_NEAR(turn.displacement, c.amplitude, 1e-12 * c.amplitude);
  }
  EXPECT_GT(test::Orders("Mindlin's loop, force", force_errors).overall, 1.0);
  EXPECT_GT(test::Orders("Mindlin's loop, energy per cycle", heat_errors).overall, 1.0);
  test::expect_close("elastic balls, 32 cells: slip amplitude at the rim, share of the exact one",
                     1.0 + slip_errors.back(), 1.0, 1.0 / 32.0,
                     "exact: Johnson (1985), Eq. 7.44; the centre of a cell at the rim");
  test::expect_close("elastic balls, 32 cells: force over friction times load, worst of two loops", force_errors.back(),
                     0.0, 0.5 * std::pow(32.0, -1.5), "exact: Mindlin (1949), Mindlin and Deresiewicz (1953)");
  test::expect_close("elastic balls, 32 cells: energy per cycle, share of the exact one", 1.0 + heat_errors.back(), 1.0,
                     0.5 * std::pow(32.0, -1.5), "exact: Mindlin and Deresiewicz (1953)");
  test::expect_close("elastic balls, 32 cells: stick radius at the turn, share of the exact one",
                     1.0 + stick_errors.back(), 1.0, 0.5 / (32.0 * std::sqrt(0.3)),
                     "exact: Mindlin (1949); half a cell of the radius");
}

TEST(Fretting, ElasticWorkIsHeatWhateverTheStep)
{
  // Both are exact for what the steps find: partial slip, and sliding with and without much sticking after a turn.
  for (const double share : {0.7, 1.5, 6.0})
    for (const int steps : {8, 16, 40})
    {
      FrettingCase c = elastic_balls(8.0);
      c.amplitude = share * sliding_displacement(c);
      c.steps_per_cycle = steps;
      const simulation::FrettingCycle loop = computed(c).summary.cycles[1];
      test::expect_close(
          fmt::format("elastic loop of {:g} sliding displacements, {} steps: work over heat", share, steps),
          loop.work / loop.dissipation_friction, 1.0, 1e-4, "exact: all of it; tolerance of the slip");
    }
}

/// Area of the second loop, whose points the history joins by straight segments [J].
double polygon(const FrettingRun& run)
{
  double area = 0.0;
  for (std::size_t i = 1; i < run.history.size(); ++i)
    if (const FrettingRecord& r = run.history[i], &before = run.history[i - 1]; r.cycle == 2)
      area += 0.5 * (r.force + before.force) * (r.displacement - before.displacement);
  return area;
}

TEST(Fretting, WorkIsTheAreaOfTheLoop)
{
  // Of force and displacement alone, without any slip: the polygon tends to the work at second order in the step.
  for (const double share : {0.7, 1.5})
  {
    std::vector<double> errors;
    for (const int steps : {16, 32, 64})
    {
      FrettingCase c = elastic_balls(8.0);
      c.amplitude = share * sliding_displacement(c);
      c.steps_per_cycle = steps;
      const FrettingRun run = computed(c);
      errors.push_back(polygon(run) / run.summary.cycles[1].work - 1.0);
    }
    const std::string name = fmt::format("elastic loop of {:g} sliding displacements: polygon over work", share);
    EXPECT_GT(test::Orders((name + ", steps doubled").c_str(), errors).overall, 1.5);
    test::expect_close(name + ", 64 steps", 1.0 + errors.back(), 1.0, 5e-3, "exact: the area; trapezoidal rule");
  }
}

TEST(Fretting, WorkOfGrossSlipIsThatOfMindlinAndDeresiewicz)
{
  FrettingCase c = elastic_balls(16.0);
  const double to_slide = sliding_displacement(c);
  c.amplitude = 3.0 * to_slide;
  const simulation::FrettingCycle loop = computed(c).summary.cycles[1];
  const double exact = 4.0 * c.friction.coefficient * c.press.value * (c.amplitude - 0.8 * to_slide);
  test::expect_close("elastic balls, 16 cells, amplitude of 3 sliding displacements: work, share of the exact one",
                     loop.work / exact, 1.0, 5e-3, "exact: Mindlin and Deresiewicz (1953); mesh");
}

TEST(Fretting, OfWavesInAPeriodIsTheDifferenceOfTwoIndentations)
{
  // Where shears displace as pressure does, nu = 0, the shear of any contact under P is that of a contact under P less that of one
  // under P - Q/f, in which nothing slips (Jaeger 1998; Ciavarella 1998): the displacement is f times the difference of the approaches, what
  // sticks is the contact of the smaller load.
  FrettingCase c;
  c.lower = c.upper = {simulation::Plane{}, {{200e9, 0.0}, {}}};
  c.domain.x = c.domain.y = {Boundary::periodic, 1e-3, 64};
  c.lower.texture = simulation::Sinusoid{.amplitude = 1e-6, .wavelength_x = 1e-3, .wavelength_y = 1e-3};
  c.press = load(120.0);
  c.friction.coefficient = 0.4;
  c.kind = FrettingCase::Kind::force;
  const double share = 0.5; // of friction times load
  c.amplitude = share * c.friction.coefficient * c.press.value;
  c.cycles = 1;
  c.steps_per_cycle = 16;
  const FrettingRun run = computed(c);
  const FrettingRecord& pressed = run.history[static_cast<std::size_t>(c.press_steps) - 1];
  const FrettingRecord& turn = run.history[static_cast<std::size_t>(c.press_steps) + 3];
  ASSERT_NEAR(turn.force, c.amplitude, 1e-9 * c.amplitude);
  ASSERT_GT(turn.contact_area, 0.3e-6); // of a period of 1e-6: the neighbours are felt

  simulation::IndentationCase smaller;
  static_cast<simulation::Numerics&>(smaller) = c;
  smaller.friction = {};
  smaller.lower = c.lower;
  smaller.upper = c.upper;
  smaller.sequence = {load((1.0 - share) * c.press.value)};
  const IndentationRun indentation = verification::computed(smaller);
  const simulation::IndentationRecord& at_smaller = indentation.history.back();
  // Both on the same cells: to the tolerance of the solver. A cell that is at its bound to rounding may count either way.
  EXPECT_NEAR(turn.displacement, c.friction.coefficient * (pressed.approach - at_smaller.approach),
              1e-6 * turn.displacement);
  EXPECT_NEAR(turn.stick_area, at_smaller.contact_area, 0.01 * at_smaller.contact_area);
  EXPECT_NEAR(run.summary.cycles[0].work / run.summary.cycles[0].dissipation_friction, 1.0, 0.1);
}

/// A ball on a flat that both yield when they are pressed: p0/k = 4 and some more under the shear.
FrettingCase yielding(double cells, bool are_alike)
{
  FrettingCase c;
  c.lower = {simulation::Plane{}, track_steel(20e9)};
  c.upper = {ball(10e-3), track_steel(20e9)};
  if (!are_alike)
  {
    c.upper.material.elastic.young_modulus *= 2.0;
    c.upper.material.hardening = constitutive::LinearHardening{2.2e9, 30e9};
  }
  c.press = ball_on_flat(track_steel(20e9), 4e9, 1e-3).drive;
  c.press_steps = 10;
  c.friction.coefficient = 0.3;
  c.resolution = cells;
  c.steps_per_cycle = 16;
  c.amplitude = 0.6 * simulation::plan(c).sliding_displacement;
  return c;
}

TEST(Fretting, EnergyClosesWithPlasticity)
{
  for (const bool are_alike : {true, false})
  {
    const FrettingRun run = computed(yielding(slow_build ? 5.0 : 16.0, are_alike));
    const std::string name = are_alike ? "equal bodies" : "unlike bodies";
    test::expect_close("error of the energy balance, fretting of " + name + ", friction 0.3, 16 cells",
                       run.summary.energy_balance_error, 0.0, 5e-3, "bound: mesh and steps");
    EXPECT_GT(run.summary.dissipation_lower, 0.0);
    EXPECT_GT(run.summary.dissipation_friction, 0.0);
    EXPECT_EQ(run.summary.split_increments, 0);
  }
}

TEST(Fretting, EnergyClosesInGrossSlip)
{
  // Each turn falls within few steps, as the bodies slide over most of a cycle.
  FrettingCase c = elastic_balls(16.0);
  c.press_steps = 10;
  c.cycles = 1;
  c.steps_per_cycle = 40;
  c.amplitude = 6.0 * sliding_displacement(c);
  test::expect_close("error of the energy balance, gross slip of elastic balls, 16 cells, 40 steps",
                     computed(c).summary.energy_balance_error, 0.0, 1e-3, "bound: the steps of pressing");
}

/// A hard ball on a flat whose shear strength much of the contact reaches.
FrettingCase at_shear_limit(double amplitude)
{
  FrettingCase c;
  const Elastic steel_like{210e9, 0.3};
  c.lower = {simulation::Plane{}, {steel_like, constitutive::LinearHardening{900e6, 2e9}}};
  c.upper = {ball(1e-3), {steel_like, {}}};
  c.press = load(20.0);
  c.friction.coefficient = 0.5;
  c.amplitude = amplitude;
  c.resolution = slow_build ? 4.0 : 8.0;
  return c;
}

TEST(Fretting, EnergyClosesAtTheShearLimit)
{
  FrettingCase c = at_shear_limit(3e-6);
  for (const int steps : {16, 40})
  {
    c.steps_per_cycle = steps;
    const FrettingRun run = computed(c);
    EXPECT_GT(run.summary.max_share_at_shear_limit, 0.5);
    test::expect_close(fmt::format("error of the energy balance, gross slip at the shear limit, {} steps", steps),
                       run.summary.energy_balance_error, 0.0, 5e-3, "bound: mesh and steps");
  }
}

TEST(Fretting, StepsConvergeToSecondOrderAtTheShearLimit)
{
  // The limit is the strength of the surface at the end of each step, so that it does not lag.
  std::vector<double> heat, plastic;
  for (const int steps : {8, 16, 32, 64})
  {
    FrettingCase c = at_shear_limit(0.8e-6);
    c.cycles = 1;
    c.steps_per_cycle = steps;
    const FrettingRun run = computed(c);
    EXPECT_GT(run.summary.max_share_at_shear_limit, 0.5);
    EXPECT_EQ(run.summary.split_increments, 0);
    heat.push_back(run.summary.cycles[0].dissipation_friction);
    plastic.push_back(run.summary.cycles[0].dissipation_plastic);
  }
  const auto differences = [](const std::vector<double>& of) {
    return std::vector<double>{of[0] - of[1], of[1] - of[2], of[2] - of[3]};
  };
  EXPECT_GT(test::Orders("fretting at the shear limit: heat, steps halved", differences(heat)).overall, 1.6);
  EXPECT_GT(test::Orders("fretting at the shear limit: plastic work, steps halved", differences(plastic)).overall, 1.6);
}

TEST(Fretting, StepsConverge)
{
  // Differences between steps and steps half as long. Cells at the rims stick, slip and part as a whole, so that the differences jump:
  // of first order. The work contains the heat.
  std::vector<double> heat, plastic, area;
  for (const int factor : {1, 2, 4, 8})
  {
    FrettingCase c = yielding(5.0, false);
    c.press_steps = 4 * factor;
    c.steps_per_cycle = 8 * factor;
    const simulation::FrettingCycle cycle = computed(c).summary.cycles[0];
    heat.push_back(cycle.dissipation_friction);
    plastic.push_back(cycle.dissipation_plastic);
    area.push_back(cycle.work);
  }
  const auto differences = [](const std::vector<double>& of)
  {
    std::vector<double> result;
    for (std::size_t i = 0; i + 1 < of.size(); ++i)
      result.push_back(of[i] / of[i + 1] - 1.0);
    return result;
  };
  EXPECT_GT(test::Orders("fretting with plasticity: heat, steps halved", differences(heat)).overall, 0.8);
  EXPECT_GT(test::Orders("fretting with plasticity: plastic work of the cycle", differences(plastic)).overall, 0.8);
  test::expect_close("fretting with plasticity, work of the cycle with 8 steps over that with 64", area[0] / area[3],
                     1.0, 0.02, "bound: as the heat");
  test::expect_close("fretting with plasticity, heat with 32 steps to the cycle over that with 64", heat[2] / heat[3],
                     1.0, 0.01, "bound: first order from 2 % with 8 steps, twice that for the jumps");
}

TEST(Fretting, HardeningBodiesShakeDown)
{
  // What yields hardens: each cycle of the same amplitude dissipates less in the bodies than the one before, and the heat of
  // friction tends to that of a steady loop.
  FrettingCase c = yielding(5.0, true);
  c.steps_per_cycle = 8;
  c.cycles = 4;
  const FrettingRun run = computed(c);
  const auto& cycles = run.summary.cycles;
  ASSERT_EQ(cycles.size(), 4U);
  for (std::size_t i = 1; i < cycles.size(); ++i)
    EXPECT_LT(cycles[i].dissipation_plastic, cycles[i - 1].dissipation_plastic);
  EXPECT_GT(cycles[0].dissipation_plastic, 0.0);
  test::expect_within("plastic work of the fourth cycle over that of the first",
                      cycles[3].dissipation_plastic / cycles[0].dissipation_plastic, 0.0, 0.2, "hardening: shakedown");
  test::expect_close("heat of friction of the fourth cycle over that of the third",
                     cycles[3].dissipation_friction / cycles[2].dissipation_friction, 1.0, 0.02, "steady loop");
}

} // namespace
} // namespace brinell::verification::fretting_test
