// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/quality/quality.hpp"
#include "brinell/reference/hertz.hpp"
#include "record.hpp"
#include "scenario_runs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

/// The upper sphere rides over the lower one under a constant normal force instead of at a constant height.
namespace brinell::verification::loaded_tugging_test
{
namespace
{

simulation::TuggingCase under_load(const constitutive::Material& material, double load_ratio, double cells)
{
  simulation::TuggingCase t = equal_spheres(1.0, material);
  t.load = load_ratio * critical().load;
  t.interference = reference::point_contact_at_load(0.5, contact_modulus(elastic, elastic), *t.load).approach;
  t.resolution = cells;
  return t;
}

TEST(LoadedTugging, ElasticSpheresGiveEverythingBack)
{
  const TuggingRun run = computed(under_load(elastic_material(), 10.0, 6.0));
  double approach_error = 0.0;
  double force_error = 0.0;
  std::size_t full = 0;
  for (const simulation::TuggingRecord& r : run.history)
    if (r.F_n > 0.999 * 10.0 * critical().load)
    {
      ++full;
      const double hertz = reference::point_contact_at_load(0.5, contact_modulus(elastic, elastic), r.F_n).approach;
      approach_error = std::max(approach_error, std::abs(r.interference / hertz - 1.0));
      force_error = std::max(force_error, std::abs(r.F_X + r.F_n * std::sin(r.theta)) / r.F_n);
    }
  EXPECT_GE(full, run.history.size() * 3 / 4 - 2) << "the load comes up and goes down in an eighth of the pass each";
  test::expect_close("approach / Hertz' - 1 while the load is full", approach_error, 0.0, 0.25 * std::pow(6.0, -1.5),
                     "analytic: Hertz (1882); edge error of the mesh");
  test::expect_close("F_X + F_n sin(theta), over F_n", force_error, 0.0, 1e-12, "exact: no residual surface");
  const double largest = std::max_element(run.history.begin(), run.history.end(),
                                          [](const auto& a, const auto& b) { return a.work < b.work; })
                             ->work;
  test::expect_close("net work over the largest", run.summary.work / largest, 0.0, 1e-6,
                     "exact: elastic, and the same steps up and down");
}

// The load is P but for the first and the last eighth of the angle 2 t of a pass, so that friction takes f P (R1 + R2 - a) (2 t - t/4),
// wherever the steps begin. The bodies are incompressible: others shrink along the contact under the pressure, by 0.2 % in steel, and
// slip by as much less.
TEST(LoadedTugging, FrictionTakesTheSameOnEveryMesh)
{
  for (const double cells : {5.0, 6.0, 7.0, 8.0})
  {
    simulation::TuggingCase t = under_load({{200e9, 0.5}, {}}, 10.0, cells);
    t.interference =
        reference::point_contact_at_load(0.5, contact_modulus({200e9, 0.5}, {200e9, 0.5}), *t.load).approach;
    t.friction.coefficient = 0.1;
    const double distance = 2.0 - t.interference, touch = std::acos(distance / 2.0);
    const double exact = 0.1 * *t.load * distance * 1.75 * touch;
    const TuggingRun run = computed(t);
    const double step = (run.history[1].theta - run.history[0].theta) / touch;
    // Four kinks of slope 4/t, of which a trapezoidal rule misses up to a twelfth of the square of the step.
    const double kinks = 4.0 * 4.0 * step * step / 12.0 / 1.75;
    test::expect_close(
        "heat of friction of a pass under a load, " + std::to_string(std::lround(cells)) + " cells per radius",
        run.summary.dissipation_friction / exact, 1.0, kinks, "exact: friction times load times way; trapezoidal rule");
  }
}

// Without friction the net energy is a small difference of what the load does on its way down and up.
TEST(LoadedTugging, NetEnergyIsWithinItsExpectedError)
{
  const auto run = [](double cells) { return computed(under_load(perfect_material(), 10.0, cells)).summary.work; };
  const double fine = run(slow_build ? 8.0 : 14.0);
  for (const double cells : {4.0, 6.0, 8.0})
  {
    const simulation::TuggingCase t = under_load(perfect_material(), 10.0, cells);
    const auto errors = quality::expected(t, simulation::plan(t)).resolution.expected_errors;
    const auto stated =
        std::find_if(errors.begin(), errors.end(), [](const auto& e) { return e.quantity == "net energy"; });
    ASSERT_NE(stated, errors.end());
    test::expect_close("net energy of a pass under a load, " + std::to_string(std::lround(cells)) + " cells per radius",
                       run(cells) / fine, 1.0, 1.5 * stated->relative,
                       "14 cells; the expected error is an estimate to half of itself");
  }
}

TEST(LoadedTugging, EnergyBalances)
{
  // Work of F_X along X and of F_Z along the height that the upper body rises and sinks. Plastic strain ends up in both.
  std::vector<double> errors;
  const std::vector<double> meshes = slow_build ? std::vector{3.0} : std::vector{3.0, 6.0};
  for (const double cells : meshes)
  {
    const TuggingRun run = computed(under_load(perfect_material(), 10.0, cells));
    errors.push_back(run.summary.energy_balance_error);
    test::expect_close("energy balance, " + std::to_string(std::lround(cells)) + " cells per radius", errors.back(),
                       0.0, 0.5 / (cells * cells), "exact: conservation of energy");
  }
  if (errors.size() == 2)
    test::expect_within("energy balance, 3 cells / 6 cells", errors[0] / errors[1], 2.0, 8.0,
                        "theory: second order in the mesh and the shift, at least first");
}

} // namespace
} // namespace brinell::verification::loaded_tugging_test
