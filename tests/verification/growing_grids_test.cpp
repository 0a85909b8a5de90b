// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/foundation/error.hpp"
#include "record.hpp"
#include "scenario_runs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

/// Grids that begin too small grow, and the run ends with what it gives on grids that were large enough from the start: what
/// differs is what the truncated strain at the edges (1 % of the largest at most) and the image correction do, whose fit is
/// good to some 1e-4 of the largest stress.
namespace brinell::verification::growing_grids_test
{
namespace
{

using simulation::GridChange;

constexpr double tolerance = 1e-3;
/// Where flow is nearly free a stress of 1e-4 S_y more makes a plastic strain of 1e-4 S_y / H more: some 0.5 % here.
constexpr double strain_tolerance = 5e-3;

template <typename ScenarioCase>
auto with_extent(ScenarioCase c, double extent)
{
  c.extent = extent;
  return computed(c);
}

bool grew(const simulation::RunTotals& totals, GridChange::Extent extent)
{
  return std::any_of(totals.grid_changes.begin(), totals.grid_changes.end(),
                     [&](const GridChange& change) { return change.extent == extent; });
}

void expect_equal_totals(const std::string& name, const simulation::RunTotals& small,
                         const simulation::RunTotals& large)
{
  EXPECT_FALSE(small.grid_changes.empty()) << name;
  EXPECT_LT(small.grid_changes.size(), 40U) << name;
  const auto close = [&](const char* what, double a, double b, double allowed = tolerance)
  {
    test::expect_close(name + ", " + what + ", begun small over begun large", a / b, 1.0, allowed,
                       "grids large from the start");
  };
  close("dissipation", small.dissipation_lower + small.dissipation_upper,
        large.dissipation_lower + large.dissipation_upper);
  close("residual depth", small.max_residual_lower, large.max_residual_lower);
  close("plastic strain", small.max_equivalent_plastic_strain, large.max_equivalent_plastic_strain, strain_tolerance);
  close("work", small.work, large.work);
}

constitutive::Material strong()
{
  return {elastic, constitutive::LinearHardening{1.3 * yield_stress, 5e9}};
}

TEST(GrowingGrids, Indentation)
{
  simulation::IndentationCase c =
      pressed_spheres(perfect_material(), {approach(20.0 * critical().interference), approach(0.0)});
  c.upper.material = strong();
  c.steps = 8;
  c.resolution = slow_build ? 4.0 : 5.0; // with 3 cells the largest plastic strain differs by 0.6 %
  const auto small = with_extent(c, 0.5);
  expect_equal_totals("indentation", small.summary, with_extent(c, 2.0).summary);
  EXPECT_TRUE(grew(small.summary, GridChange::Extent::lower_layers));
  EXPECT_TRUE(grew(small.summary, GridChange::Extent::rows));
}

TEST(GrowingGrids, TwinsGrowTogether)
{
  simulation::TuggingCase t = small_case(9.0);
  const auto small = with_extent(t, 0.5);
  expect_equal_totals("tugging of twins", small.summary, with_extent(t, 1.5).summary);
  EXPECT_EQ(small.summary.final_state.lower.grid, small.summary.final_state.upper.grid);
}

TEST(GrowingGrids, TuggingOfDissimilarBodies)
{
  simulation::TuggingCase t = small_case(9.0);
  t.upper = {ball(0.7), strong()};
  expect_equal_totals("tugging of dissimilar bodies", with_extent(t, 0.5).summary, with_extent(t, 1.5).summary);
}

TEST(GrowingGrids, TuggingOverABump)
{
  simulation::TuggingCase t = small_case(6.0);
  const double a = simulation::plan(t).elastic_contact_radius;
  t.lower.texture = simulation::Dent{.x = 0.5 * a, .depth = -0.3 * t.interference, .edge_radius = 0.5 * a};
  expect_equal_totals("tugging over a bump", with_extent(t, 0.5).summary, with_extent(t, 1.5).summary);
}

TEST(GrowingGrids, RollingWithSlidingOverADent)
{
  simulation::RollingCase c = ball_on_flat(track_steel(2e9), 5.2e9, 0.6e-3);
  c.upper.material = track_steel(10e9);
  c.lower.texture = simulation::Dent{.x = 0.05e-3, .depth = 1e-6, .edge_radius = 0.1e-3};
  c.slide_to_roll = 0.25;
  c.resolution = 3.0;
  c.load_steps = 4;
  const auto small = with_extent(c, 0.55);
  expect_equal_totals("rolling over a dent", small.summary, with_extent(c, 1.6).summary);
}

TEST(GrowingGrids, OnlyMemoryStopsThem)
{
  simulation::TuggingCase t = small_case(9.0);
  t.extent = 0.5;
  simulation::Observer<simulation::TuggingRecord> observer;
  int steps = 0;
  observer.on_step = [&](const simulation::TuggingRecord&, int) { ++steps; };
  observer.available_memory = 1.05 * simulation::plan(t).memory_bytes;
  try
  {
    static_cast<void>(simulation::run(t, observer));
    FAIL() << "the grids did not grow";
  }
  catch (const GridError& error)
  {
    EXPECT_NE(std::string(error.what()).find("available are"), std::string::npos) << error.what();
    EXPECT_GT(steps, 0);
  }
}

/// Beneath the first grid lies a core so soft that it is the only place to yield: the grid grows down to it.
TEST(GrowingGrids, DownToASoftCore)
{
  simulation::IndentationCase c = pressed_spheres(perfect_material(), {approach(0.9 * critical().interference)});
  const double a = std::sqrt(0.5 * 0.9 * critical().interference);
  for (simulation::ShapedBody* body : {&c.lower, &c.upper})
    body->material.yield_factor = constitutive::DepthProfile({0.0, 3.2 * a, 3.6 * a}, {1.0, 1.0, 0.05});
  c.steps = 4;
  c.resolution = 4.0;
  const auto run = with_extent(c, 0.6);
  EXPECT_TRUE(grew(run.summary, GridChange::Extent::lower_layers));
  EXPECT_GT(run.summary.max_equivalent_plastic_strain, 1e-5);
  expect_equal_totals("soft core", run.summary, with_extent(c, 2.0).summary);
}

} // namespace
} // namespace brinell::verification::growing_grids_test
