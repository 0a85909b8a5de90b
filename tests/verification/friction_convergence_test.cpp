// SPDX-License-Identifier: BSD-3-Clause
#include "order.hpp"
#include "record.hpp"
#include "scenario_runs.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

/// Bodies that slide with friction: what cells and steps change.
namespace brinell::verification::friction_convergence_test
{
namespace
{

using simulation::RollingCase;
using simulation::RollingRecord;

TEST(Friction, PlasticShareOfTheBalanceConverges)
{
  // Beside the heat the plastic work is small. What is unaccounted for must be small beside that, too, and fall with the cells and
  // the step, that is one cell: second order in the step, as the path integration, first order of the edge of the contact.
  std::vector<double> errors;
  for (const double cells : {4.0, 8.0})
  {
    const simulation::TuggingSummary s = computed(rubbing(4.0, 0.2, cells)).summary;
    errors.push_back(std::abs(s.energy_balance_error) * s.work /
                     (s.dissipation_lower + s.dissipation_upper + s.energy_residual));
  }
  test::expect_within("unaccounted / plastic energy, 4 cells per contact radius", errors[0], 0.0, 0.08,
                      "bound: mesh and steps");
  test::expect_within("the same with 8 cells, over that with 4", errors[1] / errors[0], 0.0, 0.6,
                      "at least first order");
}

/// A cylinder that does not turn slides over a steel flat in plane strain, and yields itself nothing.
/// @param step  in cells
RollingCase slid_track(double cells, double step, double p0_over_k = 4.5, double friction = 0.25)
{
  RollingCase c;
  c.domain.y = {Boundary::periodic, 1.0, 1};
  c.lower = {simulation::Plane{}, track_steel(20e9)};
  c.upper = {simulation::Roller{0.01, std::numeric_limits<double>::infinity()}, elastic_material()};
  const double E = contact_modulus(c.lower.material.elastic, c.upper.material.elastic);
  const double p0 = p0_over_k * 1e9, a = 2.0 * 0.01 * p0 / E;
  c.drive = load(0.5 * std::numbers::pi * p0 * a);
  c.friction.coefficient = friction;
  c.slide_to_roll = 2.0;
  c.distance = 6.0 * a;
  c.spacing = {{a / cells, 1.0, 0.5 * a / cells}};
  c.shift = step * a / cells;
  return c;
}

TEST(Friction, SlidTrackConvergesWithCellsAndStep)
{
  if (slow_build)
    GTEST_SKIP() << "needs fine cells: too slow in this build";
  // The energy that a length of track takes up. With the step of one cell both errors fall together, at nearly second order;
  // that of the step alone is larger, since the path of the strain bends where the contact's edge passes.
  const auto resistance = [](double cells, double step)
  { return computed(slid_track(cells, step)).summary.passes.front().resistance; };
  const auto differences = [](const std::vector<double>& values) {
    return std::vector{(values[1] - values[0]) / values[2], (values[2] - values[1]) / values[2]};
  };
  const std::vector<double> by_cells = differences({resistance(4, 1), resistance(8, 1), resistance(16, 1)});
  EXPECT_GT(test::Orders("resistance, slid track: 4, 8, 16 cells", by_cells).last, 1.6);
  test::expect_close("resistance, slid track, 16 cells over 8, less 1", by_cells[1], 0.0, 0.04,
                     "bound: mesh and steps");
  const std::vector<double> by_steps = differences({resistance(8, 4), resistance(8, 2), resistance(8, 1)});
  EXPECT_GT(test::Orders("the same, 8 cells: steps of 4, 2, 1 cells", by_steps).last, 1.3);
}

/// Means over runs whose contact ends at other places between the cells: an order read from single runs is an accident of that.
/// @param run  of so many cells per half-width, @returns numbers
template <typename Run>
std::vector<double> over_edges(double cells, const Run& run)
{
  constexpr int edges = 4;
  std::vector<double> mean;
  for (int k = 0; k < edges; ++k)
  {
    const std::vector<double> numbers = run(cells + static_cast<double>(k) / edges);
    mean.resize(numbers.size(), 0.0);
    for (std::size_t i = 0; i < numbers.size(); ++i)
      mean[i] += numbers[i] / edges;
  }
  return mean;
}

/// What number i of runs changes by from each to the next, over the last one.
std::vector<double> changes(const std::vector<std::vector<double>>& runs, std::size_t i)
{
  std::vector<double> result;
  for (std::size_t run = 1; run < runs.size(); ++run)
    result.push_back((runs[run][i] - runs[run - 1][i]) / runs.back()[i]);
  return result;
}

/// What is expected of a number when cells go from 4 to 8 to 16: the least order, and the most that the last change may be.
struct Expected
{
  const char* what;
  double order, change;
};

void expect_convergence(const std::string& name, const std::vector<std::vector<double>>& runs,
                        const std::vector<Expected>& expected)
{
  for (std::size_t i = 0; i < expected.size(); ++i)
  {
    const std::vector<double> by_cells = changes(runs, i);
    EXPECT_GT(test::Orders((name + expected[i].what).c_str(), by_cells).last, expected[i].order);
    test::expect_close(name + expected[i].what + ", 16 cells over 8, less 1", by_cells.back(), 0.0, expected[i].change,
                       "bound: mesh and steps");
  }
}

TEST(Friction, SlidTracksConvergeWithLoadAndFriction)
{
  if (slow_build)
    GTEST_SKIP() << "needs fine cells: too slow in this build";
  for (const double p0_over_k : {3.5, 4.5})
    for (const double friction : {0.1, 0.25})
    {
      const auto numbers = [&](double cells)
      {
        const RollingRun run = computed(slid_track(cells, 1, p0_over_k, friction));
        const RollingRecord& last = run.history.back();
        // Of a track whose length is rounded to steps: work over heat, which is as long.
        return std::vector{run.summary.passes.front().resistance, last.dissipation_lower / last.dissipation_friction,
                           last.max_residual_lower, run.summary.passes.front().rut_depth};
      };
      std::vector<std::vector<double>> runs;
      for (const double cells : {4.0, 8.0, 16.0})
        runs.push_back(over_edges(cells, numbers));
      const std::string name = fmt::format("slid track, p0/k = {:g}, friction {:g}, ", p0_over_k, friction);
      expect_convergence(name, runs,
                         {{"resistance", 1.4, 0.03}, {"plastic work over heat", 1.3, 0.03}, {"dent", 1.2, 0.04}});
      // The rut is what is left of strain that is mostly shear: an eighth to a third of the dent at the ends of the track.
      test::expect_close(name + "rut, 16 cells over 8, less 1", changes(runs, 3).back(), 0.0, 0.12,
                         "bound: columns and steps at the trailing edge");
    }
}

TEST(Friction, RutErrsByColumnsAndStepsRatherThanByLayers)
{
  if (slow_build)
    GTEST_SKIP() << "needs fine cells: too slow in this build";
  const auto rut = [](double column, double layer)
  {
    const auto number = [&](double cells)
    {
      RollingCase c = slid_track(cells, column, 3.5, 0.25); // the step is a column
      (*c.spacing)[0] *= column;
      (*c.spacing)[2] *= layer;
      return std::vector{computed(c).summary.passes.front().rut_depth};
    };
    return over_edges(8.0, number).front();
  };
  // Beneath the trailing edge the stress changes within a length as short as its depth, which thinner layers do not resolve.
  const double here = rut(1.0, 1.0);
  test::expect_within("rut, slid track: change by halved layers over that by halved columns and steps",
                      (rut(1.0, 0.5) - here) / (rut(0.5, 1.0) - here), -0.3, 0.3, "bound: a third");
}

TEST(Friction, RubbingConvergesWithTheCells)
{
  if (slow_build)
    GTEST_SKIP() << "needs fine cells: too slow in this build";
  const auto numbers = [](double cells)
  {
    const simulation::TuggingSummary s = computed(rubbing(4.0, 0.2, cells)).summary;
    return std::vector{s.energy_residual, s.max_residual_lower, s.dissipation_lower + s.dissipation_upper, s.peak_F_Z,
                       s.peak_F_X};
  };
  std::vector<std::vector<double>> runs;
  for (const double cells : {4.0, 8.0, 16.0})
    runs.push_back(over_edges(cells, numbers));
  const std::string name = "tugging, friction 0.2: ";
  expect_convergence(
      name, runs,
      {{"locked-in energy", 1.5, 0.04}, {"dent", 1.4, 0.02}, {"plastic work", 1.3, 0.05}, {"largest F_Z", 1.4, 0.006}});
  // Friction falls and ploughing grows: what is left of both has no order on these cells.
  test::expect_close(name + "largest F_X, 16 cells over 8, less 1", changes(runs, 4).back(), 0.0, 0.006,
                     "bound: mesh and steps");
}

} // namespace
} // namespace brinell::verification::friction_convergence_test
