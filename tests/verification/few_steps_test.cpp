// SPDX-License-Identifier: BSD-3-Clause
// Errors of few steps, against the expected errors that such a run states: docs/verification/accuracy.md (few steps).
#include "brinell/quality/quality.hpp"
#include "record.hpp"
#include "scenario_runs.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace brinell::verification::few_steps_test
{
namespace
{

/// Of a run, of the named quantity; NaN if none is stated.
template <typename Case>
double stated_error(const Case& c, const typename Case::Summary& summary, const std::string& quantity)
{
  for (const quality::ExpectedError& e : quality::judged(c, simulation::plan(c), summary).resolution.expected_errors)
    if (e.quantity == quantity)
      return e.relative;
  return std::nan("");
}

/// The error of few steps must not exceed 1.5 times the stated error, to which the cells contribute as well; nor must the latter be
/// so large that it says nothing.
void expect_stated(const std::string& name, double value, double of_fine_steps, double stated)
{
  const double found = std::abs(value / of_fine_steps - 1.0);
  EXPECT_LT(stated, 0.5) << name;
  test::expect_within(name + ": error of the steps, over the stated error", found / stated, 0.05, 1.5,
                      "much shorter steps on the same cells");
}

TEST(FewSteps, OfAnIndentationAreToldOfItsDent)
{
  if (slow_build)
    GTEST_SKIP() << "too expensive in this build";
  simulation::IndentationCase c;
  c.lower = {simulation::Plane{}, track_steel(5e9)};
  c.upper = {ball(10e-3), {track_steel().elastic, {}}};
  c.sequence = {load(2000.0), load(0.0)};
  c.resolution = 8.0;
  c.steps = 8;
  const simulation::Indent fine = simulation::run(c).indents.at(0);
  c.steps = 1;
  const simulation::IndentationSummary s = simulation::run(c);
  expect_stated("one step: residual depth", s.indents.at(0).residual_depth, fine.residual_depth,
                stated_error(c, s, "residual depth"));
  expect_stated("one step: pile-up", s.indents.at(0).pile_up, fine.pile_up, stated_error(c, s, "pile-up"));
}

TEST(FewSteps, OfALongShiftAreToldOfRolling)
{
  if (slow_build)
    GTEST_SKIP() << "too expensive in this build";
  simulation::RollingCase c = ball_on_flat(track_steel(5e9), 5e9, 1.0);
  const simulation::RollingPlan p = simulation::plan(c);
  c.spacing = {p.contact.dx, p.contact.dy, p.lower.dz};
  c.distance = 24.0 * p.contact.dx;
  for (const double cells : {2.0, 4.0})
  {
    c.shift = 0.25 * cells * p.contact.dx;
    const simulation::RollingPass fine = simulation::run(c).passes.at(0);
    c.shift = cells * p.contact.dx;
    const simulation::RollingSummary s = simulation::run(c);
    const std::string name = "shift of " + std::to_string(static_cast<int>(cells)) + " cells: ";
    expect_stated(name + "dissipation", s.passes.at(0).dissipation, fine.dissipation,
                  stated_error(c, s, "dissipation"));
    expect_stated(name + "resistance", s.passes.at(0).resistance, fine.resistance, stated_error(c, s, "resistance"));
    expect_stated(name + "rut", s.passes.at(0).rut_depth, fine.rut_depth, stated_error(c, s, "rut"));
    expect_stated(name + "shoulder", s.passes.at(0).shoulder_height, fine.shoulder_height,
                  stated_error(c, s, "shoulder"));
    expect_stated(name + "strain under the track", s.passes.at(0).track_plastic_strain, fine.track_plastic_strain,
                  stated_error(c, s, "strain under the track"));
  }
}

TEST(FewSteps, OfALongShiftAreToldOfTugging)
{
  if (slow_build)
    GTEST_SKIP() << "too expensive in this build";
  simulation::TuggingCase t = equal_spheres(9.0, perfect_material());
  t.spacing = {3.85e-3, 7.7e-3, 3.85e-3};
  t.shift = 3.85e-3;
  const simulation::TuggingSummary fine = simulation::run(t);
  t.shift = 4.0 * 3.85e-3;
  const simulation::TuggingSummary s = simulation::run(t);
  expect_stated("shift of half a radius: net energy", s.work, fine.work, stated_error(t, s, "net energy"));
  expect_stated("shift of half a radius: F_X at alignment", s.F_X_aligned, fine.F_X_aligned,
                stated_error(t, s, "F_X at alignment"));
  expect_stated("shift of half a radius: dent", s.max_residual_lower, fine.max_residual_lower,
                stated_error(t, s, "dents"));
  expect_stated("shift of half a radius: plastic work", s.dissipation_lower, fine.dissipation_lower,
                stated_error(t, s, "plastic work"));
  expect_stated("shift of half a radius: largest strain", s.max_equivalent_plastic_strain,
                fine.max_equivalent_plastic_strain, stated_error(t, s, "largest plastic strain"));
}

} // namespace
} // namespace brinell::verification::few_steps_test
