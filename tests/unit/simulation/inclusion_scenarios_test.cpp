// SPDX-License-Identifier: BSD-3-Clause
// Inclusions in rolling, indentation, sliding and tugging: energy, checkpoints, short cuts.
#include "brinell/simulation/indentation.hpp"
#include "brinell/simulation/rolling.hpp"
#include "brinell/simulation/run.hpp"
#include "brinell/simulation/sliding.hpp"
#include "brinell/simulation/tugging.hpp"
#include "sphere_pairs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace brinell::simulation::inclusion_scenarios_test
{
namespace
{

const constitutive::Material steel{{210e9, 0.3}, constitutive::LinearHardening{1e9, 10e9}};

/// A stiff inclusion that stays elastic and a soft, weak one that is off the track.
std::vector<BodyInclusion> inclusions(double unit)
{
  using Kind = InclusionShape::Kind;
  BodyInclusion stiff{{390e9, 0.25}, InclusionShape{Kind::ellipsoid, {-10.0 * unit, 0.0, 10.0 * unit}, {}}};
  std::get<InclusionShape>(stiff.region).semi_axes.fill(8.0 * unit);
  stiff.yield_factor = 10.0;
  BodyInclusion soft{
      {120e9, 0.24},
      InclusionShape{Kind::ellipsoid, {10.0 * unit, 2.0 * unit, 10.0 * unit}, {10.0 * unit, 8.0 * unit, 8.0 * unit}}};
  soft.yield_factor = 0.5;
  return {stiff, soft};
}

template <typename Case>
Case pair()
{
  Case c;
  c.lower = {Plane{}, steel};
  c.upper = {Paraboloid{1e-3, 1e-3}, {{210e9, 0.3}, {}}};
  c.lower.inclusions = inclusions(1e-6);
  c.resolution = 5.0;
  return c;
}

RollingCase rolling()
{
  RollingCase c = pair<RollingCase>();
  c.drive = {contact::Drive::Kind::load, 2.0};
  c.distance = 60e-6;
  c.load_steps = 2;
  return c;
}

// The checkpoint has the equivalent strain, its displacement and the strength of the cells.
TEST(InclusionScenarios, ARunGoesOnFromACheckpointWithTheSameNumbers)
{
  const RollingCase c = rolling();
  const RollingSummary whole = run(c);
  simulation::Run<RollingCase> begun(c);
  for (int step = 0; 2 * step < whole.steps; ++step)
    static_cast<void>(begun.step());
  EXPECT_GT(begun.summary().max_equivalent_plastic_strain, 0.0);
  const Archive::Fields stored = begun.checkpoint();
  const RollingSummary resumed = run(c, {}, &stored);
  EXPECT_EQ(resumed.evaluations, whole.evaluations);
  ASSERT_TRUE(resumed.inclusions);
  EXPECT_EQ(resumed.inclusions->iterations, whole.inclusions->iterations);
  EXPECT_NEAR(resumed.work, whole.work, 1e-10 * whole.work);
  EXPECT_NEAR(resumed.dissipation_lower, whole.dissipation_lower, 1e-10 * whole.dissipation_lower);
  const std::vector<double>&a = resumed.final_state.lower.equivalent_plastic_strain,
        &b = whole.final_state.lower.equivalent_plastic_strain;
  ASSERT_EQ(a.size(), b.size());
  double difference = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
    difference = std::max(difference, std::abs(a[i] - b[i]));
  EXPECT_LE(difference, 1e-10 * whole.max_equivalent_plastic_strain);
  EXPECT_EQ(*std::ranges::max_element(resumed.final_state.lower.inclusion), 2.0);
}

// Both satisfy the same equations to the tolerance of the yield condition, 1e-4.
TEST(InclusionScenarios, FewCellsGiveTheResultsOfAllCells)
{
  RollingCase c = rolling();
  const RollingSummary few = run(c);
  c.solver.shortcuts = c.solver.windows = false;
  const RollingSummary all = run(c);
  EXPECT_NEAR(few.dissipation_lower, all.dissipation_lower, 1e-3 * all.dissipation_lower);
  EXPECT_NEAR(few.max_equivalent_plastic_strain, all.max_equivalent_plastic_strain,
              1e-3 * all.max_equivalent_plastic_strain);
  EXPECT_NEAR(few.max_residual_lower, all.max_residual_lower, 1e-3 * all.max_residual_lower);
}

// The work is dissipated or stored, but for the steps.
TEST(InclusionScenarios, EnergyClosesUnderABallThatIsPressedAndLifted)
{
  IndentationCase c = pair<IndentationCase>();
  c.sequence = {{contact::Drive::Kind::load, 2.0}, {contact::Drive::Kind::load, 0.0}};
  c.steps = 12;
  const IndentationSummary s = run(c);
  EXPECT_GT(s.dissipation_lower, 0.0);
  EXPECT_LT(std::abs(s.energy_balance_error), 5e-3);
  EXPECT_TRUE(s.inclusions);
}

TEST(InclusionScenarios, EnergyClosesUnderABallThatSlides)
{
  SlidingCase c = pair<SlidingCase>();
  c.press = {contact::Drive::Kind::load, 1.5};
  c.friction.coefficient = 0.2;
  c.distance = 40e-6;
  const SlidingSummary s = run(c);
  EXPECT_GT(s.dissipation_lower, 0.0);
  EXPECT_LT(std::abs(s.energy_balance_error), 5e-3);
  EXPECT_TRUE(s.inclusions);
}

TEST(InclusionScenarios, EnergyClosesWhereAsperitiesPassEachOther)
{
  TuggingCase c = spheres(6.0);
  c.resolution = 6.0;
  c.lower.inclusions = inclusions(2e-3);
  const TuggingSummary s = run(c);
  EXPECT_GT(s.dissipation_lower, 0.0);
  EXPECT_LT(std::abs(s.energy_balance_error), 5e-3);
  EXPECT_TRUE(s.inclusions);
}

} // namespace
} // namespace brinell::simulation::inclusion_scenarios_test
