// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/halfspace/heat_response.hpp"
#include "brinell/quality/quality.hpp"
#include "order.hpp"
#include "record.hpp"
#include "scenario_runs.hpp"
#include "taken_up.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

/// The heat of friction between bodies that slide: where it goes, and what it does to them.
namespace brinell::verification::heat_test
{
namespace
{

using simulation::RollingCase;
using simulation::RollingRecord;
using simulation::TuggingCase;
using simulation::TuggingRecord;

double first_law_error(const simulation::HeatedRecord& r)
{
  return (r.dissipation_friction - r.heat_lower - r.heat_upper) / r.dissipation_friction;
}

TEST(Heat, FrictionWorkIsHeatInBothBodies)
{
  for (const bool is_plastic : {false, true})
  {
    const TuggingRun run =
        computed(warm_spheres(is_plastic ? perfect_material() : elastic_material(), 4.0, 1.0, slow_build ? 4.0 : 8.0));
    const std::string name = is_plastic ? "plastic pass" : "elastic pass";
    // The one is summed over the cells of the contact, where the heat is; the other is the work of the shear as it is projected on
    // the motion.
    test::expect_close(name + ": (friction work - heat)/friction work", first_law_error(run.summary.last), 0.0, 1e-3,
                       "exact: all of it is heat");
    // Bodies that are alike and pass each other.
    const double heat = run.summary.last.heat_lower + run.summary.last.heat_upper;
    test::expect_close(name + ": share of the lower body", run.summary.last.heat_lower / heat, 0.5, 1e-5,
                       "exact: by symmetry; both surfaces are at one temperature to 1e-6 of the difference that the "
                       "shares make up for");
    // The trapezoidal rule of the work, and the stress of the flux that was expected in a step.
    test::expect_close(name + ": energy unaccounted for / work", run.summary.energy_balance_error, 0.0, 5e-3,
                       "exact: work, and work of expansion, is heat, plastic work and stored energy");
  }
}

TEST(Heat, CellsTakenAsTouchingAreTold)
{
  if (slow_build)
    GTEST_SKIP() << "needs the cells at which it happens";
  // In this pass one cell and its mirror image open by the heat that they get while they touch, and close without it.
  TuggingCase t = warm_spheres(perfect_material(), 4.0, 1.0, 8.0);
  const simulation::RunTotals held = computed(t).summary;
  EXPECT_GT(held.most_held_cells, 0);
  EXPECT_LT(held.most_held_cells, 10);
  EXPECT_LT(held.share_of_held_cells, 1e-3);
  // Where the shares of the heat are given, no cell has to know whether it touches.
  t.heat.partition = 0.5;
  const simulation::RunTotals given = computed(t).summary;
  EXPECT_EQ(given.most_held_cells, 0);
  EXPECT_EQ(given.share_of_held_cells, 0.0);
}

TEST(Heat, OneOfTwoMirroredBodiesIsSolved)
{
  TuggingCase t = warm_spheres(perfect_material(), 4.0, 1.0, 5.0);
  const TuggingRun one = computed(t);
  ASSERT_EQ(one.plan.twin, elastoplastic::Twin::mirror_image);
  t.solver.mirror = false;
  const TuggingRun both = computed(t);
  // To the tolerance of the yield condition, 1e-4.
  for (const auto member : {&TuggingRecord::F_X, &TuggingRecord::F_Z})
    EXPECT_LT(difference(one, member, both, member), 3e-4);
  EXPECT_LT(difference(one, &TuggingRecord::max_temperature_lower, both, &TuggingRecord::max_temperature_lower), 3e-4);
  EXPECT_LT(difference(one, &TuggingRecord::max_temperature_upper, both, &TuggingRecord::max_temperature_upper), 3e-4);
  EXPECT_LT(difference(one, &TuggingRecord::heat_upper, both, &TuggingRecord::heat_upper), 3e-4);
}

TEST(Heat, WithoutSpeedThereIsOnlyFriction)
{
  TuggingCase t = warm_spheres(perfect_material(), 4.0, 1e-9, 5.0);
  const TuggingRun slow = computed(t);
  for (simulation::ShapedBody* body : {&t.lower, &t.upper})
    body->material.thermal.reset();
  const TuggingRun cold = computed(t);
  const double force = std::max(std::abs(slow.summary.peak_F_X / cold.summary.peak_F_X - 1.0),
                                std::abs(slow.summary.peak_F_Z / cold.summary.peak_F_Z - 1.0));
  // The temperature goes with the speed: 1e-9 of some 100 K at 1 m/s. What is left is rounding that the iteration enlarges.
  test::expect_close("F_X and F_Z at 1e-9 m/s against friction alone", force, 0.0, 1e-6, "isothermal run");
  EXPECT_LT(difference(slow, &TuggingRecord::F_X, cold, &TuggingRecord::F_X), 1e-6);
}

TEST(Heat, ARunThatIsTakenUpGoesOnAsItWas)
{
  TuggingCase t = warm_spheres(perfect_material(), 4.0, 1.0, 4.0);
  t.solver.mirror = false;
  t.passes = 2;
  simulation::Run<TuggingCase> whole(t), first(t);
  int steps = 0;
  for (; !whole.is_done(); ++steps)
    static_cast<void>(whole.step());
  for (int step = 0; step < steps / 2 + 3; ++step)
    static_cast<void>(first.step());
  const Archive::Fields checkpoint = first.checkpoint();
  // After the way back the bodies are still warm: the second pass ends warmer than the first one.
  EXPECT_GT(expect_same_end(whole, t, checkpoint).heat_lower, 0.0);
}

/// Grids that are too small at first: the bodies' grow, those of the heat have room.
TEST(Heat, GridsThatGrowKeepTheHeat)
{
  TuggingCase t = warm_spheres(perfect_material(), 8.0, 1.0, 4.0);
  const TuggingRun ample = computed(t);
  t.extent = 0.62;
  const TuggingRun grown = computed(t);
  ASSERT_FALSE(grown.summary.grid_changes.empty());
  ASSERT_TRUE(ample.summary.grid_changes.empty());
  const auto at_peak = [](const TuggingRun& run) { return run.summary.peak_F_Z; };
  // To what lies beyond the smaller grids, and the tolerance of the yield condition.
  EXPECT_NEAR(at_peak(grown) / at_peak(ample), 1.0, 1e-3);
  EXPECT_NEAR((grown.summary.max_temperature[0] - 20.0) / (ample.summary.max_temperature[0] - 20.0), 1.0, 2e-3);
}

/// By thermal stress the outermost rows flow in a few cells, but nothing flows beyond: the results are those of larger grids.
TEST(Heat, AZoneThatEndsInTheOutermostRowsNeedsNoLargerGrids)
{
  if (slow_build)
    GTEST_SKIP() << "needs the paper's mesh: too slow in this build";
  TuggingCase t = paper_case(9.0);
  for (simulation::ShapedBody* body : {&t.lower, &t.upper})
    body->material.thermal = steel;
  t.friction.coefficient = 0.1;
  t.heat.of_plastic_work = 0.0;
  t.speed = 0.01;
  const TuggingRun planned = computed(t);
  t.extent = 1.2; // one more row on either side, more columns and layers
  const TuggingRun ample = computed(t);
  EXPECT_TRUE(planned.summary.grid_changes.empty());
  EXPECT_TRUE(ample.summary.grid_changes.empty());
  const simulation::BodySnapshot& body = planned.summary.final_state.lower;
  const SurfaceGrid& surface = body.grid.surface;
  double at_side = 0.0;
  for (int k = 0; k < body.grid.nz; ++k)
    for (int i = 0; i < surface.nx; ++i)
      at_side = std::max(at_side, body.equivalent_plastic_strain[body.grid.index(i, 0, k)]);
  EXPECT_GT(at_side, 0.005 * planned.summary.max_equivalent_plastic_strain);
  const auto expect_same = [](const char* what, double a, double b, double allowed)
  {
    test::expect_close(std::string("zone that ends in the outermost rows: ") + what + " over that on larger grids",
                       a / b, 1.0, allowed, "larger grids, in whose outermost rows nothing flows");
  };
  const simulation::TuggingSummary &a = planned.summary, &b = ample.summary;
  expect_same("peak F_X", a.peak_F_X, b.peak_F_X, 1e-5);
  expect_same("dissipation", a.dissipation_lower, b.dissipation_lower, 1e-4);
  expect_same("dent", a.max_residual_lower, b.max_residual_lower, 1e-4);
  expect_same("largest plastic strain", a.max_equivalent_plastic_strain, b.max_equivalent_plastic_strain, 5e-4);
  expect_same("largest temperature", a.max_temperature[0], b.max_temperature[0], 1e-4);
}

/// The heat stays on the grids that it began on: a run that is taken up makes these again.
TEST(Heat, ARunWhoseGridsGrewIsTakenUp)
{
  TuggingCase t = warm_spheres(perfect_material(), 8.0, 1.0, 4.0);
  t.extent = 0.62;
  simulation::Run<TuggingCase> whole(t);
  Archive::Fields checkpoint;
  while (!whole.is_done())
  {
    if (whole.summary().grid_changes.empty())
      checkpoint.clear();
    else if (checkpoint.empty())
      checkpoint = whole.checkpoint();
    static_cast<void>(whole.step());
  }
  ASSERT_FALSE(checkpoint.empty());
  t.extent = 0.7; // of grids that are made anew it may be another one
  expect_same_end(whole, t, checkpoint);
}

/// Largest temperature that a Hertzian flux of so much heat has made by the end of a way at constant speed.
double flash_temperature(double heat, double radius, double speed, double distance)
{
  constexpr int n = 97;
  const SurfaceGrid g{n, n, 3.0 * radius / n, 3.0 * radius / n};
  const double largest_flux = 1.5 * heat / (3.14159265358979323846 * radius * radius);
  std::vector<double> flux(g.size()), rise(g.size());
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i)
      flux[g.index(i, j)] =
          largest_flux * std::sqrt(std::max(0.0, 1.0 - std::pow(std::hypot(g.x(i), g.y(j)) / radius, 2)));
  const halfspace::HeatResponse response(g, steel, {distance / speed, speed});
  halfspace::HeatResponse::Scratch scratch = response.make_scratch();
  response.apply(flux, rise, scratch);
  return *std::max_element(rise.begin(), rise.end());
}

TEST(Heat, FlashTemperatureOfASlidingBall)
{
  for (const double peclet : {0.1, 1.0, 10.0})
  {
    const RollingCase c = sliding_ball(peclet, slow_build ? 5.0 : 10.0);
    const RollingRun run = computed(c);
    const auto last = std::max_element(run.history.begin(), run.history.end(),
                                       [](const RollingRecord& a, const RollingRecord& b) { return a.x < b.x; });
    const double modulus = contact_modulus(c.lower.material.elastic, c.upper.material.elastic);
    const double radius = std::cbrt(0.75 * c.drive.value * 10e-3 / modulus);
    const double exact = flash_temperature(0.1 * c.drive.value * *c.speed, radius, *c.speed, c.distance);
    // Cells of a tenth of the radius: flux and its response are uniform in each, and the first step has half of it.
    test::expect_close("rise / that of a Hertzian flux, Pe = " + std::to_string(peclet).substr(0, 4),
                       (last->max_temperature_lower - 20.0) / exact, 1.0, 1.5e-2,
                       "HeatResponse, which is verified against Jaeger's integrals");
    EXPECT_EQ(last->heat_upper, 0.0);
  }
}

/// Both bodies conduct; the lower one sees a flux that moves, the upper one a flux that stands.
double largest_rise(double peclet, std::optional<double> partition, double* share_of_upper = nullptr)
{
  RollingCase c = sliding_ball(peclet, 6.0);
  c.upper.material.thermal = steel;
  c.heat.partition = partition;
  const RollingRun run = computed(c);
  double rise = 0.0;
  for (const RollingRecord& r : run.history)
    rise = std::max(rise, std::max(r.max_temperature_lower, r.max_temperature_upper) - 20.0);
  const RollingRecord& last = run.summary.last;
  if (share_of_upper != nullptr)
    *share_of_upper = last.heat_upper / (last.heat_lower + last.heat_upper);
  return rise;
}

TEST(Heat, SharesLieBetweenTheLimitsOfBlok)
{
  // A slow contact heats both half spaces alike. A fast one leaves ever new cold places of the lower body, which takes most of
  // the heat; Blok's rule makes the largest temperatures of both bodies equal, 1/T = 1/T_lower + 1/T_upper of all heat in one of
  // them. It is a rule for largest temperatures, not for all of the contact: known to be good to some per cent.
  double share = 0.0;
  static_cast<void>(largest_rise(0.01, {}, &share));
  test::expect_close("share of the body that rests under its contact, Pe = 0.01", share, 0.5, 0.02, "exact: 1/2");
  double before = share;
  for (const double peclet : {1.0, 10.0})
  {
    const double rise = largest_rise(peclet, {}, &share);
    const double rule = 1.0 / (1.0 / largest_rise(peclet, 1.0) + 1.0 / largest_rise(peclet, 0.0));
    test::expect_close("rise / Blok's rule, Pe = " + std::to_string(peclet).substr(0, 4), rise / rule, 1.0, 0.06,
                       "Blok (1937)");
    EXPECT_LT(share, before);
    before = share;
  }
}

TEST(Heat, SurfacesThatTouchHaveOneTemperature)
{
  RollingCase c = sliding_ball(3.0, 6.0);
  c.upper.material.thermal = Thermal{20.0, 3200.0, 700.0, 3e-6};
  c.upper.material.temperature = 80.0;
  simulation::Run<RollingCase> run(c);
  for (int step = 0; step < c.load_steps + 10; ++step)
    static_cast<void>(run.step());
  const simulation::Snapshot s = run.snapshot();
  double largest = 0.0, difference = 0.0;
  for (std::size_t i = 0; i < s.pressure.size(); ++i)
    if (s.pressure[i] > 0.0)
    {
      largest = std::max(largest, s.temperature[0][i] - 20.0);
      difference = std::max(difference, std::abs(s.temperature[0][i] - s.temperature[1][i]));
    }
  EXPECT_GT(largest, 60.0);
  // To 1e-6 of the difference that would be there if all heat went into the upper body.
  EXPECT_LT(difference, 1e-5 * largest);
}

TEST(Heat, ConvergesWithTheStep)
{
  for (const double speed : {0.01, 1.0, 10.0})
  {
    std::vector<double> forces, temperatures;
    for (const double cells : {2.0, 1.0, 0.5})
    {
      TuggingCase t = warm_spheres(elastic_material(), 4.0, speed, 6.0);
      t.shift = cells * simulation::plan(t).contact.dx;
      const TuggingRun run = computed(t);
      forces.push_back(run.aligned().F_Z);
      double hottest = 0.0;
      for (const TuggingRecord& r : run.history)
        hottest = std::max(hottest, r.max_temperature_lower - 20.0);
      temperatures.push_back(hottest);
    }
    const std::string name = std::to_string(speed).substr(0, 4) + " m/s: ";
    // The flux of a step is the mean of its ends: second order; the contact grid moves by whole cells of the lower body, and on halves
    // of a cell the flux of a step is smeared over one.
    test::expect_close(name + "F_Z aligned, steps of one cell / of half", forces[1] / forces[2], 1.0, 2e-3,
                       "the same limit");
    test::expect_close(name + "largest rise, steps of one cell / of half", temperatures[1] / temperatures[2], 1.0, 2e-2,
                       "the same limit");
    EXPECT_LT(std::abs(forces[1] - forces[2]), 1.05 * std::abs(forces[0] - forces[2]));
  }
}

TEST(Heat, AWarmBulkSoftensByItsFactor)
{
  // So slow that nothing heats, and with a thermal expansion of zero: the bodies are those whose law of hardening is multiplied with
  // the factor at the temperature of the bulk.
  constexpr double temperature = 320.0, melting = 1520.0, reference = 20.0;
  const double factor = 1.0 - (temperature - reference) / (melting - reference);
  constitutive::Material soft = elastic_material();
  soft.hardening = constitutive::LinearHardening{1e9, 20e9};
  constitutive::Material weak = soft;
  weak.hardening = constitutive::LinearHardening{factor * 1e9, factor * 20e9};
  TuggingCase warm = warm_spheres(soft, 4.0, 1e-9, 4.0);
  for (simulation::ShapedBody* body : {&warm.lower, &warm.upper})
  {
    body->material.softening = constitutive::LinearSoftening{reference, melting};
    body->material.temperature = temperature;
    body->material.thermal->expansion = 0.0;
  }
  TuggingCase cold = warm;
  for (simulation::ShapedBody* body : {&cold.lower, &cold.upper})
  {
    body->material = weak;
    body->material.thermal.reset();
  }
  cold.speed.reset();
  const simulation::TuggingPlan same_cells = simulation::plan(warm);
  cold.spacing = warm.spacing = {same_cells.contact.dx, same_cells.contact.dy, same_cells.lower.dz};
  const TuggingRun of_warm = computed(warm), of_cold = computed(cold);
  EXPECT_GT(of_cold.summary.dissipation_lower, 0.0);
  // The plans do not know the softening: grids and tolerances differ.
  EXPECT_NEAR(of_warm.summary.dissipation_lower / of_cold.summary.dissipation_lower, 1.0, 1e-3);
  EXPECT_NEAR(of_warm.summary.max_residual_lower / of_cold.summary.max_residual_lower, 1.0, 1e-3);
}

TEST(Heat, HotterBodiesYieldMoreAndMeltingIsTold)
{
  // At 1 m/s both surfaces reach some 200 degC.
  std::vector<double> plastic;
  for (const double melting : {1520.0, 620.0, 120.0})
  {
    TuggingCase t = warm_spheres(perfect_material(), 4.0, 1.0, 4.0);
    for (simulation::ShapedBody* body : {&t.lower, &t.upper})
    {
      body->material.hardening = constitutive::LinearHardening{1e9, 20e9};
      body->material.softening = constitutive::JohnsonCookSoftening{20.0, melting, 1.0};
    }
    const TuggingRun run = computed(t);
    plastic.push_back(run.summary.dissipation_lower);
    const auto warnings = quality::judged(t, simulation::plan(t), run.summary).warnings;
    EXPECT_EQ(std::any_of(warnings.begin(), warnings.end(), [](const auto& w) { return w.key == "melting"; }),
              melting < 200.0);
  }
  EXPECT_GT(plastic[1], 1.05 * plastic[0]);
  EXPECT_GT(plastic[2], plastic[1]);
}

TEST(Heat, ARunThatIsToStopAtMeltingStopsBeforeThatStep)
{
  TuggingCase t = warm_spheres(perfect_material(), 4.0, 1.0, 4.0);
  t.upper.material.softening = constitutive::JohnsonCookSoftening{20.0, 120.0, 1.0};
  const TuggingRun whole = computed(t);
  const auto melts = [](const auto& record) { return record.max_temperature_upper >= 120.0; };
  const auto first = std::find_if(whole.history.begin(), whole.history.end(), melts);
  ASSERT_NE(first, whole.history.end());
  t.heat.at_melting = elastoplastic::AtMelting::stop;
  simulation::Run<TuggingCase> run(t);
  for (auto before = whole.history.begin(); before != first; ++before)
    EXPECT_EQ(run.step().F_X, before->F_X);
  try
  {
    run.step();
    FAIL() << "it should have stopped";
  }
  catch (const InputError& error)
  {
    const std::string text = error.what();
    EXPECT_NE(text.find("the upper surface reaches"), std::string::npos) << text;
    EXPECT_NE(text.find("melts at 120 degC"), std::string::npos) << text;
  }
}

} // namespace
} // namespace brinell::verification::heat_test
