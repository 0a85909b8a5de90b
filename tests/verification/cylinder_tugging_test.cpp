// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/reference/elastic_tugging.hpp"
#include "brinell/reference/hertz.hpp"
#include "brinell/simulation/first_yield.hpp"
#include "record.hpp"
#include "scenario_runs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

/// Cylinders in plane strain, in units of their own first yield (Green 2005).
namespace brinell::verification::cylinder_tugging_test
{
namespace
{

using simulation::TuggingCase;
using simulation::TuggingRecord;

constexpr const char* too_slow = "needs fine cells: too slow in this build";
constexpr const char* green = "exact: first yield of a line contact (Green 2005)";

simulation::Domain plane_strain()
{
  simulation::Domain domain;
  domain.y = {Boundary::periodic, 1.0, 1};
  return domain;
}

simulation::Roller endless(double radius)
{
  return {radius, std::numeric_limits<double>::infinity()};
}

simulation::FirstYield critical_of(const TuggingCase& t)
{
  return simulation::nominal_first_yield(t.lower, t.upper, t.domain).value();
}

/// The paper's spheres as cylinders: R1 = R2 = 1 m, its steel.
TuggingCase equal_cylinders(double interference_ratio, double cells)
{
  TuggingCase t;
  t.lower = {endless(1.0), perfect_material()};
  t.upper = t.lower;
  t.domain = plane_strain();
  t.interference = interference_ratio * critical_of(t).critical.interference;
  t.resolution = cells;
  return t;
}

/// A cylinder of 10 mm that stays elastic, pressed on a flat of the same constants by the load at which the flat would yield.
struct AtFirstYield
{
  double stress = 0.0;   ///< largest von Mises stress over S_y
  double depth = 0.0;    ///< of it, over that of the closed form
  double approach = 0.0; ///< over alpha_c
  double energy = 0.0;   ///< over U_c
};

AtFirstYield pressed_to_first_yield(double poisson_ratio, double cells)
{
  const Elastic body{200e9, poisson_ratio};
  simulation::IndentationCase c;
  c.lower = {simulation::Plane{}, {body, constitutive::PerfectPlasticity{1e9}}};
  c.upper = {endless(10e-3), {body, {}}};
  c.domain = plane_strain();
  const auto critical = simulation::nominal_first_yield(c.lower, c.upper, c.domain)->critical;
  c.lower.material.hardening = {}; // what the stress would have been
  c.sequence = {load(critical.load)};
  c.resolution = cells;
  c.steps = 1;
  const auto run = computed(c);
  const simulation::BodySnapshot& s = run.summary.final_state.lower;
  AtFirstYield result;
  std::size_t deepest = 0;
  for (std::size_t n = 0; n < s.stress[0].size(); ++n)
  {
    SymTensor stress{};
    for (std::size_t i = 0; i < 6; ++i)
      stress[i] = s.stress[i][n];
    if (const double value = von_mises(stress) / 1e9; value > result.stress)
    {
      result.stress = value;
      deepest = n / s.grid.surface.size();
    }
  }
  const auto yield = reference::line_contact_first_yield(poisson_ratio);
  result.depth = (static_cast<double>(deepest) + 0.5) * s.grid.dz / (yield.depth_ratio * critical.contact_radius);
  result.approach = run.history.back().approach / critical.interference;
  result.energy = run.history.back().energy_elastic / critical.energy;
  return result;
}

TEST(CylinderTugging, FirstYieldIsWhereTheClosedFormHasIt)
{
  // Pressure and stress of the second order in the cells: 5e-5 at 32. The depth is known to half a layer, a 128th of the
  // half-width.
  const double cells = slow_build ? 16.0 : 32.0;
  const double second_order = std::pow(32.0 / cells, 2.0);
  for (const double nu : {0.25, 0.32, 0.45})
  {
    const AtFirstYield at = pressed_to_first_yield(nu, cells);
    const std::string name = "nu = " + std::to_string(nu).substr(0, 4) + ": ";
    test::expect_close(name + "largest von Mises stress / S_y at P_c", at.stress, 1.0, 3e-4 * second_order, green);
    test::expect_close(name + "its depth / that of the closed form", at.depth, 1.0, 0.25 / cells / 0.6, green);
    test::expect_close(name + "approach / alpha_c", at.approach, 1.0, 1e-4 * second_order, green);
    test::expect_close(name + "elastic energy / U_c", at.energy, 1.0, 1e-4 * second_order, green);
  }
}

TEST(CylinderTugging, YieldBeginsAtTheCriticalLoad)
{
  // 3 % of the load are 1.5 % of the pressure.
  if (slow_build)
    GTEST_SKIP() << too_slow;
  const auto strain = [](double load_ratio)
  {
    simulation::IndentationCase c;
    c.lower = {simulation::Plane{}, perfect_material()};
    c.upper = {endless(10e-3), elastic_material()};
    c.domain = plane_strain();
    c.sequence = {load(load_ratio * simulation::nominal_first_yield(c.lower, c.upper, c.domain)->critical.load)};
    c.resolution = 24.0;
    c.steps = 1;
    return computed(c).summary.max_equivalent_plastic_strain;
  };
  EXPECT_EQ(strain(0.97), 0.0);
  EXPECT_GT(strain(1.03), 0.0);
}

TEST(CylinderTugging, BelowFirstYieldIsTheElasticPassOfHertz)
{
  const TuggingCase t = equal_cylinders(0.97, slow_build ? 8.0 : 14.0);
  const auto run = computed(t);
  const simulation::FirstYield yield = critical_of(t);
  const reference::ElasticTugging exact{1.0, 1.0, contact_modulus(elastic, elastic), t.interference, yield.line};
  const reference::TuggingPeak peak = reference::elastic_tugging_peak(exact);
  EXPECT_EQ(run.summary.max_equivalent_plastic_strain, 0.0);
  double of_F_X = 0.0, of_F_Z = 0.0;
  for (const TuggingRecord& r : run.history)
  {
    const reference::TuggingForces f = reference::elastic_tugging_forces(exact, r.X);
    of_F_X = std::max(of_F_X, std::abs(r.F_X - f.F_X));
    of_F_Z = std::max(of_F_Z, std::abs(r.F_Z - f.F_Z));
  }
  // As far as the edge of contact is resolved: in the first and last steps by few cells.
  const double share = slow_build ? 3e-3 : 1e-3;
  const char* origin = "exact: Hertz, Johnson (1985), Eqs. 4.43-4.45";
  test::expect_close("alpha* = 0.97: largest error of F_X / its peak", of_F_X / peak.F_X, 0.0, share, origin);
  test::expect_close("alpha* = 0.97: largest error of F_Z / its peak",
                     of_F_Z / reference::elastic_tugging_forces(exact, 0.0).F_Z, 0.0, share, origin);
  test::expect_close("alpha* = 0.97: work to alignment / U(alpha)",
                     run.summary.work_to_alignment /
                         reference::elastic_tugging_work(exact, -reference::half_sliding_distance(exact), 0.0),
                     1.0, share, origin);
  // Nothing but the trapezoidal rule stands between the work and zero; by symmetry it has no error.
  test::expect_close("alpha* = 0.97: net work / U(alpha)", run.summary.last.work / run.summary.work_to_alignment, 0.0,
                     1e-4, "exact: elastic bodies give back all work");
}

/// What is told of an interference, in units of first yield.
struct Measured
{
  double F_X_peak, F_X_min, F_Z_peak, load_ratio, net, dent, balance;
};

Measured measured(double interference_ratio, double cells)
{
  const TuggingCase t = equal_cylinders(interference_ratio, cells);
  const auto critical = critical_of(t).critical;
  const simulation::TuggingSummary s = simulation::run(t);
  return {s.peak_F_X / critical.load, s.min_F_X / critical.load, s.peak_F_Z / critical.load,
          s.load_ratio_aligned,       s.work / critical.energy,  s.max_residual_lower / critical.interference,
          s.energy_balance_error};
}

TEST(CylinderTugging, TrendsOverTheInterference)
{
  // Ten cells per half-width: peaks of the forces to 1 %, energies to 3 % (docs/verification/simulation.md, cylinders).
  if (slow_build)
    GTEST_SKIP() << too_slow;
  constexpr double cells = 10.0;
  const char* closes = "energy: work = dissipated + stored";
  const Measured first = measured(1.0, cells), second = measured(2.0, cells), fourth = measured(4.0, cells);
  test::expect_close("alpha* = 1: peak F_Z / P_c", first.F_Z_peak, 1.0, 5e-4, green);
  test::expect_close("alpha* = 1: net work / U_c", first.net, 0.0, 1e-4, "exact: nothing has yielded");
  test::expect_close("alpha* = 2: energy balance error", second.balance, 0.0, 5e-3, closes);
  test::expect_close("alpha* = 4: energy balance error", fourth.balance, 0.0, 5e-3, closes);
  // Finite elements (Vijaywargiya & Green 2007): with plastic flow the ratio of the forces does not vanish at alignment.
  const char* trend = "literature: Vijaywargiya & Green (2007), trend";
  test::expect_within("alpha* = 2: F_X / F_Z at X = 0", second.load_ratio, 1e-3, 5e-3, trend);
  test::expect_within("alpha* = 4: the same, over that of alpha* = 2", fourth.load_ratio / second.load_ratio, 2.0, 8.0,
                      trend);
  // The contact carries less than the elastic one, and pushes less on the way out than it resists on the way in.
  const auto elastic_peak = [&](double ratio)
  {
    const TuggingCase t = equal_cylinders(ratio, cells);
    const auto yield = critical_of(t);
    const reference::ElasticTugging e{1.0, 1.0, contact_modulus(elastic, elastic), t.interference, yield.line};
    return reference::elastic_tugging_forces(e, 0.0).F_Z / yield.critical.load;
  };
  test::expect_within("alpha* = 2: peak F_Z / elastic", second.F_Z_peak / elastic_peak(2.0), 0.85, 1.0, "below Hertz");
  test::expect_within("alpha* = 4: peak F_Z / elastic", fourth.F_Z_peak / elastic_peak(4.0), 0.6,
                      second.F_Z_peak / elastic_peak(2.0), "below Hertz, and more so");
  test::expect_within("alpha* = 2: -min F_X / max F_X", -second.F_X_min / second.F_X_peak, 0.0, 0.95, trend);
  test::expect_within("alpha* = 4: -min F_X / max F_X", -fourth.F_X_min / fourth.F_X_peak, 0.0,
                      -second.F_X_min / second.F_X_peak, trend);
  test::expect_close("alpha* = 4: largest dent / alpha", fourth.dent / 4.0, 0.1623, 0.003, "recorded: 14 cells");
  test::expect_close("alpha* = 4: net work / U_c", fourth.net, 19.2, 0.6, "recorded: 14 cells");
}

TEST(CylinderTugging, SwappedBodiesMirrorThePassInUnitsOfTheWeakerOne)
{
  // The weaker body is the same whichever lies below; so are the units, and the pass is its own mirror image.
  if (slow_build)
    GTEST_SKIP() << too_slow;
  TuggingCase t = equal_cylinders(1.0, 8.0);
  t.lower.material = {{200e9, 0.3}, constitutive::PerfectPlasticity{0.8e9}};
  t.upper.material = {{120e9, 0.25}, constitutive::LinearHardening{0.7e9, 3e9}};
  t.upper.shape = endless(1.5);
  t.interference = 2.0 * critical_of(t).critical.interference;
  EXPECT_EQ(critical_of(t).body, simulation::YieldsFirst::upper);
  const auto run = computed(t);
  std::swap(t.lower, t.upper);
  EXPECT_EQ(critical_of(t).body, simulation::YieldsFirst::lower);
  EXPECT_NEAR(t.interference / critical_of(t).critical.interference, 2.0, 1e-12);
  const auto swapped = computed(t);
  // The same operations in the same order, but for sums over both bodies.
  test::expect_close("largest difference of F_X / its peak",
                     difference(run, &TuggingRecord::F_X, swapped, &TuggingRecord::F_X), 0.0, 1e-9,
                     "symmetry: which body is below does not matter");
  test::expect_close("energy balance error", run.summary.energy_balance_error, 0.0, 5e-3,
                     "energy: work = dissipated + stored");
}

} // namespace
} // namespace brinell::verification::cylinder_tugging_test
