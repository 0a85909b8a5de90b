// SPDX-License-Identifier: BSD-3-Clause
#include "order.hpp"
#include "record.hpp"
#include "scenario_runs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

/// The heat of plastic work.
namespace brinell::verification::plastic_heat_test
{
namespace
{

using simulation::TuggingCase;

/// Friction that is there, but heats nothing that counts.
TuggingCase hardly_rubbing(double speed)
{
  TuggingCase t = warm_spheres(perfect_material(), 4.0, speed, 5.0);
  t.friction.coefficient = 1e-13;
  return t;
}

double largest_rise(const std::vector<double>& temperature)
{
  return *std::max_element(temperature.begin(), temperature.end()) - 20.0;
}

TEST(PlasticHeat, StaysInTheCellsThatDoNotConduct)
{
  TuggingCase t = hardly_rubbing(1.0);
  for (simulation::ShapedBody* body : {&t.lower, &t.upper})
    body->material.thermal->conductivity = 1e-6;
  t.heat.displacement = t.heat.stress = false;
  t.solver.integration = constitutive::Integration::backward_euler; // of whose increments the work is just that
  const TuggingRun run = computed(t);
  const auto& body = run.summary.final_state.lower;
  const Thermal& thermal = *t.lower.material.thermal;
  // Of perfect plasticity the work in a cell is the yield stress times the equivalent plastic strain.
  const double unit = 0.9 * yield_stress / (thermal.density * thermal.specific_heat);
  double error = 0.0, largest = 0.0;
  for (std::size_t i = 0; i < body.equivalent_plastic_strain.size(); ++i)
  {
    largest = std::max(largest, unit * body.equivalent_plastic_strain[i]);
    error = std::max(error, std::abs(body.temperature[i] - 20.0 - unit * body.equivalent_plastic_strain[i]));
  }
  EXPECT_GT(largest, 1.0);
  test::expect_close("adiabatic rise of temperature by plastic work, largest error / largest rise", error / largest,
                     0.0, 1e-3, "exact: 0.9 W/(rho c) in each cell");
  const auto& last = run.summary.last;
  test::expect_close("heat of plastic work / 0.9 of the plastic work",
                     last.heat_of_plastic_work / (0.9 * (last.dissipation_lower + last.dissipation_upper)), 1.0, 1e-9,
                     "exact: first law");
}

TEST(PlasticHeat, SpreadsWhereTheBodiesConduct)
{
  std::vector<double> rises;
  for (const double speed : {1e-2, 1.0, 100.0})
    rises.push_back(largest_rise(computed(hardly_rubbing(speed)).summary.final_state.lower.temperature));
  EXPECT_LT(rises[0], 0.2 * rises[1]);
  EXPECT_LT(rises[1], rises[2]);
  TuggingCase off = hardly_rubbing(100.0);
  off.heat.of_plastic_work = 0.0;
  const TuggingRun cold = computed(off);
  EXPECT_LT(largest_rise(cold.summary.final_state.lower.temperature), 1e-3 * rises[2]);
  EXPECT_EQ(cold.summary.last.heat_of_plastic_work, 0.0);
}

TEST(PlasticHeat, TheEnergyOfAPassCloses)
{
  // At 10 m/s heat stays where it arises for the longest, and softens what goes on flowing.
  TuggingCase t = warm_spheres(perfect_material(), 4.0, 10.0, 5.0);
  for (simulation::ShapedBody* body : {&t.lower, &t.upper})
    body->material.softening = constitutive::LinearSoftening{20.0, 1500.0};
  const TuggingRun run = computed(t);
  test::expect_close("energy unaccounted for / work, softened by friction and plastic work",
                     run.summary.energy_balance_error, 0.0, 5e-3,
                     "exact: work, and work of expansion, is heat, plastic work and stored energy");
}

TEST(PlasticHeat, ConvergesWithTheStep)
{
  if (slow_build)
    GTEST_SKIP() << "needs short steps: too slow in this build";
  // What the heat of plastic work alone adds to the plastic work, by softening what goes on flowing. Cells stay, steps are halved: the
  // heat that is expected in a step is extrapolated, and what it is not is made up for in the next one.
  const auto added = [](double cells_per_step)
  {
    TuggingCase t = hardly_rubbing(10.0);
    t.resolution = 6.0;
    for (simulation::ShapedBody* body : {&t.lower, &t.upper})
      body->material.softening = constitutive::LinearSoftening{20.0, 120.0};
    t.shift = cells_per_step * simulation::plan(t).shift;
    const auto plastic_work = [](const TuggingCase& c)
    {
      const auto& last = computed(c).summary.last;
      return last.dissipation_lower + last.dissipation_upper;
    };
    TuggingCase cold = t;
    cold.heat.of_plastic_work = 0.0;
    return plastic_work(t) - plastic_work(cold);
  };
  std::vector<double> values, changes;
  for (const double cells : {2.0, 1.0, 0.5, 0.25})
    values.push_back(added(cells));
  for (std::size_t i = 1; i < values.size(); ++i)
    changes.push_back((values[i] - values[i - 1]) / values.back());
  EXPECT_GT(test::Orders("plastic work added by its own heat, halved steps", changes).overall, 1.0);
  test::expect_close("plastic work added by its own heat, steps of a quarter of a cell over a half, less 1",
                     changes.back(), 0.0, 0.015, "bound: second order of the expected heat, edges between cells");
}

} // namespace
} // namespace brinell::verification::plastic_heat_test
