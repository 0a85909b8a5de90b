// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/reference/hertz.hpp"
#include "brinell/reference/spherical_indentation.hpp"
#include "record.hpp"
#include "scenario_runs.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>
#include <string>
#include <vector>

namespace brinell::verification::indentation_test
{
namespace
{

using simulation::IndentationCase;
using simulation::IndentationRecord;

constexpr double pi = std::numbers::pi;

constexpr const char* too_slow = "needs eight cells per radius: too slow in this build";

/// Pressed to 25 times the interference of first yield and lifted off again, computed once.
const IndentationRun& deep_run()
{
  static const IndentationRun run = []
  {
    IndentationCase c = pressed_spheres(perfect_material(), {approach(25.0 * critical().interference), approach(0.0)});
    c.steps = 25;
    c.resolution = 8.0;
    return computed(c);
  }();
  return run;
}

TEST(Indentation, LoadingTo25AgreesWithFiniteElements)
{
  if (slow_build)
    GTEST_SKIP() << too_slow;
  // The two fits are up to 3 % apart; a small-strain half space is neither of their meshes (shared band of 5 %).
  const reference::IndentedSphere sphere{elastic, yield_stress};
  for (const IndentationRecord& r : deep_run().history)
  {
    const double ratio = r.approach / critical().interference;
    const bool loading = r.step < static_cast<int>(deep_run().history.size()) / 2;
    if (!loading || std::abs(std::remainder(ratio, 5.0)) > 1e-6 || ratio < 5.0)
      continue;
    const std::string label = "alpha* = " + std::to_string(std::lround(ratio)) + ": P / P_c against ";
    const double jackson_green = reference::jackson_green_load(ratio, sphere);
    const double kogut_etsion = reference::kogut_etsion_load(ratio);
    test::expect_close(label + "Jackson & Green", r.F_n / critical().load, jackson_green, 0.05 * jackson_green,
                       "literature: finite elements, Jackson & Green (2005)");
    test::expect_close(label + "Kogut & Etsion", r.F_n / critical().load, kogut_etsion, 0.05 * kogut_etsion,
                       "literature: finite elements, Kogut & Etsion (2002)");
  }
}

TEST(Indentation, UnloadingAgreesWithFiniteElements)
{
  if (slow_build)
    GTEST_SKIP() << too_slow;
  // Residual interference over the largest one: two fits, 7 % apart; ours is to lie between them, with a margin of the
  // mesh (2 % at eight cells to the radius).
  constexpr double w = 25.0;
  const double etsion = (1.0 - 1.0 / std::pow(w, 0.28)) * (1.0 - 1.0 / std::pow(w, 0.69));
  const double jackson = 1.02 * (1.0 - std::pow((w + 5.9) / 6.9, -0.54));
  const simulation::Indent& indent = deep_run().summary.indents.front();
  const double residual = indent.final_approach / indent.max_approach;
  test::expect_within("residual over largest interference at alpha* = 25", residual, 0.98 * etsion, 1.02 * jackson,
                      "literature: Etsion, Kligerman & Kadin (2005), 0.530; Jackson, Chusoipin & Green (2005), 0.566");
  // Shape of the unloading curve, P / P_max = ((alpha - alpha_res) / (alpha_max - alpha_res))^n.
  const double exponent = 1.5 * std::pow(w, -0.0331);
  for (const IndentationRecord& r : deep_run().history)
  {
    const double share = (r.approach - indent.final_approach) / (indent.max_approach - indent.final_approach);
    if (r.step < static_cast<int>(deep_run().history.size()) / 2 || share < 0.2)
      continue;
    // Measured from our own residual interference; the fit itself is good to some percent of the largest load.
    test::expect_close("unloading: P / P_max at " + std::to_string(std::lround(100.0 * share)) + " % of the way",
                       r.F_n / indent.max_load, std::pow(share, exponent), 0.03,
                       "literature: finite elements, Etsion, Kligerman & Kadin (2005)");
  }
}

TEST(Indentation, ConvergesWithTheMesh)
{
  std::vector<double> loads;
  std::vector<double> residuals;
  const std::vector<double> cells = slow_build ? std::vector{3.0, 4.0} : std::vector{5.0, 7.0, 10.0};
  for (const double resolution : cells)
  {
    IndentationCase c = pressed_spheres(perfect_material(), {approach(25.0 * critical().interference), approach(0.0)});
    c.resolution = resolution;
    c.steps = 16;
    const IndentationRun run = computed(c);
    loads.push_back(run.summary.indents[0].max_load);
    residuals.push_back(run.summary.indents[0].final_approach);
  }
  for (std::size_t i = 0; i + 1 < cells.size(); ++i)
  {
    // The edge's error, (dx/a)^1.5 times a factor below one, as for elastic spheres.
    const double allowed = 0.25 * std::pow(cells[i], -1.5);
    const std::string label = ", " + std::to_string(std::lround(cells[i])) + " cells per radius";
    test::expect_close("load at alpha* = 25" + label, loads[i] / loads.back(), 1.0, allowed, "finest of this series");
    test::expect_close("residual interference" + label, residuals[i] / residuals.back(), 1.0, allowed,
                       "finest of this series");
  }
}

TEST(Indentation, LoadAndApproachReachTheSameState)
{
  // The same way, once by its loads, once by the approaches that these gave: the states agree to the tolerances.
  IndentationCase by_load = pressed_spheres(perfect_material(), {load(10.0 * critical().load), load(0.0)});
  by_load.resolution = 4.0;
  by_load.steps = 8;
  const IndentationRun a = computed(by_load);
  IndentationCase by_approach = by_load;
  by_approach.sequence.clear();
  by_approach.steps = 1;
  for (const IndentationRecord& r : a.history)
    by_approach.sequence.push_back(approach(r.approach));
  by_approach.spacing = {
      {simulation::plan(by_load).contact.dx, simulation::plan(by_load).contact.dy, simulation::plan(by_load).lower.dz}};
  const IndentationRun b = computed(by_approach);
  double load_error = 0.0;
  double depth_error = 0.0;
  for (std::size_t i = 0; i + 1 < a.history.size(); ++i)
  {
    load_error = std::max(load_error, std::abs(a.history[i].F_n - b.history[i].F_n) / (10.0 * critical().load));
    depth_error = std::max(depth_error, std::abs(a.history[i].max_residual_lower - b.history[i].max_residual_lower) /
                                            a.summary.max_residual_lower);
  }
  test::expect_close("load, imposed or found", load_error, 0.0, 2e-4, "exact: tolerance of the yield condition, twice");
  test::expect_close("residual displacement", depth_error, 0.0, 5e-4, "exact: tolerances, over two dozen steps");
}

TEST(Indentation, ElasticContactHasNoHistory)
{
  // Every way to a load gives Hertz' approach.
  const double P = 3.0 * critical().load;
  IndentationCase direct = pressed_spheres(elastic_material(), {load(P)});
  direct.steps = 1;
  IndentationCase detour = pressed_spheres(elastic_material(), {load(0.3 * P), load(0.1 * P), load(1.5 * P), load(P)});
  detour.spacing = {
      {simulation::plan(direct).contact.dx, simulation::plan(direct).contact.dy, simulation::plan(direct).lower.dz}};
  detour.steps = 7;
  detour.extent = 1.3;
  const IndentationRun a = computed(direct);
  const IndentationRun b = computed(detour);
  test::expect_close("approach at the end of a detour", b.history.back().approach / a.history.back().approach, 1.0,
                     1e-6, "exact: tolerance of the contact");
  const auto hertz = reference::point_contact_at_load(0.5, contact_modulus(elastic, elastic), P);
  test::expect_close("approach over Hertz'", a.history.back().approach / hertz.approach, 1.0,
                     0.25 * std::pow(direct.resolution, -1.5), "analytic: Hertz (1882); edge error of the mesh");
  const IndentationRun c = computed(pressed_spheres(elastic_material(), {load(P), load(0.0)}));
  const double slope = 1.5 * P / hertz.approach;
  test::expect_close("loading stiffness over Hertz'", c.summary.indents[0].loading_stiffness / slope, 1.0, 0.015,
                     "analytic: Hertz (1882); stated error of 8 cells");
  test::expect_close("unloading stiffness over Hertz'", c.summary.indents[0].unloading_stiffness / slope, 1.0, 0.015,
                     "analytic: Hertz (1882); stated error of 8 cells");
}

TEST(Indentation, EnergyBalances)
{
  std::vector<double> errors;
  for (const int steps : {8, 16, 32})
  {
    IndentationCase c = pressed_spheres(perfect_material(), {load(10.0 * critical().load), load(0.0)});
    c.upper.shape = simulation::Plane{};
    c.upper.material.elastic = {std::numeric_limits<double>::infinity(), 0.0};
    c.upper.material.hardening.reset();
    c.resolution = 4.0;
    c.steps = steps;
    errors.push_back(computed(c).summary.energy_balance_error);
    // Trapezoidal rule in the work: near the first touch and the last one the curve is a power of 1.5.
    test::expect_close("energy balance over the largest work, " + std::to_string(steps) + " steps", errors.back(), 0.0,
                       1.0 / std::pow(steps, 1.5), "exact: conservation of energy");
  }
  test::expect_close("energy balance, 32 steps / 8 steps", std::abs(errors.back() / errors.front()), 0.0, 0.25,
                     "theory: order 1 in the step at least");
}

TEST(Indentation, BodiesThatAreAlikeAreTwins)
{
  IndentationCase c = pressed_spheres(perfect_material(), {load(10.0 * critical().load), load(0.0)});
  c.resolution = 4.0;
  c.steps = 6;
  ASSERT_EQ(simulation::plan(c).twin, elastoplastic::Twin::alike);
  const IndentationRun one = computed(c);
  c.solver.mirror = false;
  const IndentationRun both = computed(c);
  test::expect_close("largest approach, one solved or both", one.summary.indents[0].max_approach,
                     both.summary.indents[0].max_approach, 1e-4 * both.summary.indents[0].max_approach,
                     "exact: symmetry; tolerances");
  test::expect_close("dissipation, one solved or both", one.summary.dissipation_upper / both.summary.dissipation_upper,
                     1.0, 1e-3, "exact: symmetry; tolerances");
}

TEST(Indentation, SwappedBodiesSwapTheirStrain)
{
  IndentationCase c = pressed_spheres(perfect_material(), {load(8.0 * critical().load), load(0.0)});
  c.upper.material.hardening = constitutive::LinearHardening{1.2 * yield_stress, 10e9};
  c.resolution = 4.0;
  c.steps = 6;
  const IndentationRun a = computed(c);
  std::swap(c.lower, c.upper);
  const IndentationRun b = computed(c);
  test::expect_close("dissipation of the softer body", a.summary.dissipation_lower / b.summary.dissipation_upper, 1.0,
                     1e-3, "exact: symmetry; tolerances");
  test::expect_close("dissipation of the harder body", a.summary.dissipation_upper / b.summary.dissipation_lower, 1.0,
                     1e-2, "exact: symmetry; tolerances relative to a smaller amount");
}

TEST(Indentation, ElasticConeIsSneddons)
{
  // P = 2/pi E' tan(half angle) depth^2 and a = 2/pi depth tan(half angle) (Sneddon 1965); the edge's error once more,
  // and the singular pressure at the tip, spread over a cell: dx/a squared.
  IndentationCase c;
  const double half_angle = 70.3 * pi / 180.0;
  c.lower = {simulation::Plane{}, elastic_material()};
  c.upper = {simulation::Cone{half_angle, 0.0}, {{std::numeric_limits<double>::infinity(), 0.0}, {}}};
  c.sequence = {approach(1e-6)};
  c.steps = 1;
  c.resolution = 24.0;
  const IndentationRecord r = computed(c).history.back();
  const double modulus = 1.0 / elastic.contact_compliance();
  const double exact = 2.0 / pi * modulus * std::tan(half_angle) * 1e-12;
  const double cells = 2.0 / pi * 1e-6 * std::tan(half_angle) / simulation::plan(c).contact.dx;
  test::expect_close("load of an elastic cone", r.F_n / exact, 1.0, 0.5 * std::pow(cells, -1.5),
                     "analytic: Sneddon (1965)");
}

TEST(Indentation, UnloadingStiffnessIsThatOfTheContactArea)
{
  if (slow_build)
    GTEST_SKIP() << too_slow;
  // dP/dh = 2 E' sqrt(A/pi) for an axisymmetric contact whose unloading is elastic (Pharr, Oliver & Brotzen 1992), the cone
  // included. The area of a plastic contact is known to 2 %, its root to 1 %, and the slope of the power law to 1 %.
  IndentationCase c;
  constitutive::Material steel{{200e9, 0.3}, constitutive::LinearHardening{1e9, 5e9}};
  c.lower = {simulation::Plane{}, steel};
  c.upper = {simulation::Cone{70.3 * pi / 180.0, 2e-6}, {{std::numeric_limits<double>::infinity(), 0.0}, {}}};
  c.sequence = {load(0.5), load(0.0)};
  c.steps = 24;
  c.resolution = 8.0;
  const IndentationRun run = computed(c);
  const simulation::Indent& indent = run.summary.indents[0];
  const double modulus = 1.0 / steel.elastic.contact_compliance();
  const double expected = 2.0 * modulus * std::sqrt(indent.contact_area / pi);
  test::expect_close("unloading stiffness / (2 E' sqrt(A / pi)), cone", indent.unloading_stiffness / expected, 1.0,
                     0.02, "analytic: Pharr, Oliver & Brotzen (1992)");
  // A cone presses every size alike: mean pressure does not depend on load once the tip's ball is left behind. The contact
  // radius is known to a quarter of a cell.
  const IndentationRecord& half = run.history[11];
  const double cells = c.resolution * std::sqrt(half.F_n / indent.max_load);
  test::expect_close("hardness at a third of the load / at the full load", half.mean_pressure / indent.hardness, 1.0,
                     0.5 / cells, "theory: similarity; area counted in cells");
}

TEST(Indentation, HardnessOfAConeDoesNotSawWithItsCells)
{
  if (slow_build)
    GTEST_SKIP() << too_slow;
  // A sharp cone presses every size alike: its hardness is one number. Counted in cells it scatters by 2 % from 5 to 8 cells per
  // radius, as a whole ring of cells comes into contact at once.
  IndentationCase c;
  constitutive::Material steel{{200e9, 0.3}, constitutive::LinearHardening{1e9, 5e9}};
  c.lower = {simulation::Plane{}, steel};
  c.upper = {simulation::Cone{70.3 * pi / 180.0, 0.0}, {{std::numeric_limits<double>::infinity(), 0.0}, {}}};
  c.sequence = {load(2.0)};
  c.steps = 30;
  const double cell = simulation::plan(c).contact.dx;
  std::vector<double> hardness;
  for (const IndentationRecord& r : computed(c).history)
    if (r.contact_radius > 5.0 * cell)
      hardness.push_back(r.mean_pressure);
  ASSERT_GT(hardness.size(), 8U);
  const double count = static_cast<double>(hardness.size());
  const double mean = std::accumulate(hardness.begin(), hardness.end(), 0.0) / count;
  double squares = 0.0;
  for (const double h : hardness)
    squares += (h - mean) * (h - mean) / count;
  test::expect_close("scatter of the hardness of a cone, from 5 to 8 cells per radius", std::sqrt(squares) / mean, 0.0,
                     0.01,
                     "theory: similarity; a tenth of a cell of the radius' five at most, averaged along the edge");
}

TEST(Indentation, OneLargeStepConverges)
{
  // From nothing to 25 times first yield in one increment, and back in one.
  IndentationCase c = pressed_spheres(perfect_material(), {approach(25.0 * critical().interference), approach(0.0)});
  c.steps = 1;
  c.resolution = 4.0;
  const IndentationRun large = computed(c);
  c.steps = 4;
  const IndentationRun medium = computed(c);
  c.steps = 16;
  const IndentationRun small = computed(c);
  test::expect_close("load after one step / after sixteen",
                     large.summary.indents[0].max_load / small.summary.indents[0].max_load, 1.0, 0.08,
                     "recorded: 4 % between them");
  const auto error = [&](const IndentationRun& run)
  { return std::abs(run.summary.indents[0].max_load / small.summary.indents[0].max_load - 1.0); };
  test::expect_within("error of the load, four steps / one step", error(medium) / error(large), 0.0, 0.25,
                      "theory: order 2 in the step, 1/16; at least 1");
  test::expect_within("evaluations of the two steps", static_cast<double>(large.summary.evaluations), 2.0, 120.0,
                      "bound: one attempt each at most");
  EXPECT_EQ(large.summary.split_increments, 0);
}

TEST(Indentation, UnitsDoNotMatter)
{
  // In micrometres instead of metres: every length 1e6 times as large, stress in N/um^2. What follows is the same number.
  const auto scaled = [](double u)
  {
    IndentationCase c =
        pressed_spheres({{200e9 / (u * u), 0.32}, constitutive::LinearHardening{0.9e9 / (u * u), 9e9 / (u * u)}},
                        {load(10.0 * critical().load), load(0.0)});
    c.lower.shape = ball(u);
    c.upper.shape = ball(u);
    c.resolution = 4.0;
    c.steps = 5;
    // The number of iterations must not hang on rounding: far below what is compared.
    c.solver.yield_tolerance = 1e-12;
    c.solver.displacement_tolerance = 1e-12;
    c.solver.contact_tolerance = 1e-14;
    c.solver.max_evaluations = 300;
    return computed(c).summary;
  };
  const simulation::IndentationSummary metre = scaled(1.0);
  const simulation::IndentationSummary micrometre = scaled(1e6);
  for (const auto& [name, a, b] :
       {std::tuple{"approach", metre.indents[0].max_approach, micrometre.indents[0].max_approach * 1e-6},
        {"residual depth", metre.indents[0].residual_depth, micrometre.indents[0].residual_depth * 1e-6},
        {"dissipation", metre.dissipation_lower, micrometre.dissipation_lower * 1e-6}})
    test::expect_close(std::string(name) + ", m / um", a / b, 1.0, 1e-10, "exact: dimension; rounding");
}

} // namespace
} // namespace brinell::verification::indentation_test
