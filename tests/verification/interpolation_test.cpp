// SPDX-License-Identifier: BSD-3-Clause
#include "record.hpp"
#include "scenario_runs.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

/// Shifts that are no whole number of cells: the plastic strain stays where it is, on each body's own grid, and the
/// surfaces are interpolated between its columns. What does that cost?
namespace brinell::verification::interpolation_test
{
namespace
{

using simulation::RollingCase;
using simulation::TuggingCase;

/// Two elastic-plastic bodies, both solved, rolling with some sliding.
simulation::RollingSummary rolled(double cells, double slide_to_roll)
{
  RollingCase c = ball_on_flat(track_steel(10e9), 4e9, 0.8e-3);
  c.upper.material = c.lower.material;
  c.resolution = cells;
  c.slide_to_roll = slide_to_roll;
  c.solver.mirror = false;
  return computed(c).summary;
}

TEST(InterpolatedShift, StaysBelowTheErrorOfTheMesh)
{
  // A slide-to-roll ratio of one millionth changes nothing physically, but puts the columns of the two bodies beside each
  // other by a growing, tiny fraction: the interpolation is at work in every step, with an error of rounding only.
  const simulation::RollingSummary exact = rolled(3.0, 0.0);
  const simulation::RollingSummary beside = rolled(3.0, 1e-6);
  test::expect_close("rut, ratio of 1e-6 / ratio of 0", beside.passes[0].rut_depth / exact.passes[0].rut_depth, 1.0,
                     1e-4, "exact: continuity; tolerances");

  // Tugging with steps of 0.75 and of 0.8 cells. Half-cell multiples need no interpolation: 0.75 cells move the bodies against each
  // other by 1.5, so the columns lie half a cell beside each other at every other step, the worst place; 0.8 anywhere. Their
  // results must lie where steps of 0.5 and 1 put them (second order in the step), but for the error of interpolation.
  const auto peak = [](double cells, double shift)
  {
    TuggingCase t =
        equal_spheres(4.0, constitutive::Material{elastic, constitutive::LinearHardening{yield_stress, 10e9}});
    const double cell = simulation::plan(t).elastic_contact_radius / cells;
    t.spacing = {{cell, cell, 0.5 * cell}};
    t.solver.mirror = false;
    t.shift = shift * cell;
    return computed(t).summary;
  };
  std::vector<double> errors;
  const std::vector<double> meshes = slow_build ? std::vector{3.0} : std::vector{3.0, 6.0};
  for (const double cells : meshes)
  {
    const auto half = peak(cells, 0.5);
    const auto whole = peak(cells, 1.0);
    for (const double shift : {0.75, 0.8})
    {
      const auto between = peak(cells, shift);
      const auto expected = [&](double a, double b)
      { return a + (b - a) * (shift * shift - 0.25) / 0.75; }; // second order in the step
      const std::string label = ", shift of " + std::to_string(shift).substr(0, 4) + " cells, " +
                                std::to_string(std::lround(cells)) + " per radius";
      const double work = between.work / expected(half.work, whole.work) - 1.0;
      const double dent =
          between.max_residual_lower / expected(half.max_residual_lower, whole.max_residual_lower) - 1.0;
      // Steps fall on other places of the motion, so that peaks and ends differ in the second order of the mesh as well.
      const double allowed = 0.15 / (cells * cells);
      test::expect_close("net work" + label, work, 0.0, allowed,
                         "bound: sampling of the motion, second order in the mesh");
      test::expect_close("dent" + label, dent, 0.0, allowed, "bound: sampling of the motion, second order in the mesh");
      test::expect_close("energy balance" + label, between.energy_balance_error, whole.energy_balance_error,
                         2.0 * allowed, "exact: the pressure is carried back by the transpose");
    }
  }
}

} // namespace
} // namespace brinell::verification::interpolation_test
