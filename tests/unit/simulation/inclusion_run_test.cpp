// SPDX-License-Identifier: BSD-3-Clause
// Runs over inclusions: a ball that rolls over one, and what plans do with them.
#include "brinell/foundation/error.hpp"
#include "brinell/simulation/forecast.hpp"
#include "brinell/simulation/rolling.hpp"
#include "brinell/simulation/run.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace brinell::simulation::inclusion_run_test
{
namespace
{

const constitutive::Material steel{{210e9, 0.3}, constitutive::LinearHardening{1e9, 10e9}};

/// A ball that rolls without friction over a flat of the same steel, which has an inclusion beneath the middle of the track.
RollingCase over(const Elastic& elastic)
{
  RollingCase c;
  c.lower = {Plane{}, steel};
  c.upper = {Paraboloid{1e-3, 1e-3}, steel};
  c.drive = {contact::Drive::Kind::load, 2.0};
  c.distance = 60e-6;
  c.load_steps = 2;
  c.resolution = 4.0;
  if (elastic.young_modulus != steel.elastic.young_modulus)
    c.lower.inclusions = {
        {elastic, InclusionShape{InclusionShape::Kind::ellipsoid, {0.0, 0.0, 10e-6}, {9e-6, 9e-6, 7e-6}}}};
  return c;
}

// Beneath the load the soft inclusion leaves more to the steel around it, which flows more, the stiff one bears more; the run comes to its end.
TEST(InclusionRun, ABallRollsOverASoftAndAStiffInclusion)
{
  const RollingSummary plain = run(over(steel.elastic)), soft = run(over({100e9, 0.3})),
                       stiff = run(over({390e9, 0.23}));
  const auto strain = [](const RollingSummary& s) { return s.passes.back().max_equivalent_plastic_strain; };
  EXPECT_GT(strain(plain), 0.0);
  EXPECT_GT(std::abs(strain(soft) / strain(plain) - 1.0), 0.01);
  EXPECT_GT(std::abs(strain(stiff) / strain(plain) - 1.0), 0.01);
}

TEST(InclusionRun, BodiesWithInclusionsAreSolvedWhole)
{
  EXPECT_NE(plan(over(steel.elastic)).twin, elastoplastic::Twin::none);
  EXPECT_TRUE(plan(over(steel.elastic)).contact.is_mirrored_y);
  EXPECT_EQ(plan(over({100e9, 0.3})).twin, elastoplastic::Twin::none);
  EXPECT_FALSE(plan(over({100e9, 0.3})).contact.is_mirrored_y);
}

InclusionShape& ball(RollingCase& c)
{
  return std::get<InclusionShape>(c.lower.inclusions.front().region);
}

void expect_refusal(const RollingCase& c, const std::string& part)
{
  try
  {
    (void)plan(c);
    ADD_FAILURE() << "no error with " << part;
  }
  catch (const PlanError& error)
  {
    EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
  }
}

// Cells of some third of an axis: the number errs by those at the surface of the ellipsoid.
TEST(InclusionRun, PlansCountTheCells)
{
  RollingCase c = over({390e9, 0.3});
  const RollingPlan plan = simulation::plan(c);
  const EmbeddedCells& found = plan.inclusions[0];
  EXPECT_NEAR(static_cast<double>(found.cells) * plan.lower.cell_volume(), ball(c).volume(), 0.25 * ball(c).volume());
  EXPECT_EQ(found.layers, static_cast<int>(std::ceil(17e-6 / plan.lower.dz - 0.5)));
  EXPECT_NEAR(found.least, cells_per_axis(ball(c), plan.lower), 1e-12);
  EXPECT_NEAR(found.stiffest, (210.0 - 390.0) / (210.0 + 390.0), 1e-12);
  EXPECT_EQ(found.softest, 0.0);
  EXPECT_EQ(plan.inclusions[1].cells, 0U);
}

TEST(InclusionRun, GridsReachDownToTheInclusions)
{
  RollingCase c = over({390e9, 0.3});
  const RollingPlan before = plan(c);
  const double depth = before.lower.nz * before.lower.dz;
  ball(c).centre[2] = 2.0 * depth;
  const RollingPlan deeper = plan(c);
  EXPECT_NEAR(deeper.lower.nz * deeper.lower.dz, 2.0 * depth + ball(c).semi_axes[2], 1.01 * deeper.lower.dz);
  EXPECT_GT(deeper.memory_bytes, before.memory_bytes);
  ball(c).centre[2] = 4.0 * depth;
  expect_refusal(c, "`lower.inclusion[0]` reaches down to");
}

TEST(InclusionRun, PlansRefuseWhatHasNoPlace)
{
  RollingCase c = over({390e9, 0.3});
  ball(c).centre[0] = 1e-3;
  expect_refusal(c, "lies beside the grid");
  c = over({390e9, 0.3});
  ball(c).semi_axes[1] = 1e-7;
  expect_refusal(c, "cells along its smallest size; allowed: at least 1");
  c = over({390e9, 0.3});
  c.lower.inclusions.push_back(c.lower.inclusions.front());
  expect_refusal(c, "`lower.inclusion[0]` and `lower.inclusion[1]` overlap");
  c = over({390e9, 0.3});
  c.lower.inclusions.push_back(
      {{0.0, 0.3}, InclusionCluster{{0.0, 0.0, 3e-4}, {1e-3, 1e-3, 1e-5}, 5e-6, 5e-6, 1, 0.0, 1}});
  expect_refusal(c, "`lower.inclusion[1]` reaches down");
}

TEST(InclusionRun, PlansRefuseWhatIsNotComputedTogether)
{
  RollingCase c = over({390e9, 0.3});
  c.lower.material.hardening.reset();
  expect_refusal(c, "a body with a hardening law");
  c = over({390e9, 0.3});
  c.lower.material.layers = {{5e-6, {400e9, 0.2}, {}}};
  expect_refusal(c, "`lower.inclusion` and `lower.material.layers`");
  c = over({390e9, 0.3});
  c.slide_to_roll = 0.1;
  c.friction.coefficient = 0.1;
  c.wear.lower = 1e-18;
  expect_refusal(c, "wear would bring inclusions nearer to the surface");
  c = over({390e9, 0.3});
  c.lower.material.thermal = c.upper.material.thermal = Thermal{50.0, 7850.0, 460.0, 1e-5};
  c.slide_to_roll = 0.1;
  c.friction.coefficient = 0.1;
  c.speed = 1.0;
  expect_refusal(c, "`lower.inclusion` in a body that is heated");
}

TEST(InclusionRun, PlansRefuseStressAndCurrentThatInclusionsWouldChange)
{
  RollingCase c = over({390e9, 0.3});
  c.lower.material.initial_stress = constitutive::DepthProfile({0.0, 1e-4}, {-3e8, 0.0});
  expect_refusal(c, "how inclusions change an initial stress is not computed");
  c = over({390e9, 0.3});
  c.lower.material.electrical = constitutive::Electrical{1e-7};
  c.upper.material.electrical = constitutive::Electrical{1e-7};
  c.current.current = {1.0};
  expect_refusal(c, "the current through inclusions is not computed");
  c = over({std::numeric_limits<double>::infinity(), 0.25});
  c.lower.fatigue = constitutive::Fatigue{};
  expect_refusal(c, "a rigid inclusion, whose cells have no accurate stress");
}

TEST(InclusionRun, InPlaneStrainInclusionsArePrismsAlongY)
{
  using Kind = InclusionShape::Kind;
  RollingCase c = over({390e9, 0.3});
  c.upper.shape = Roller{1e-3, std::numeric_limits<double>::infinity()};
  c.domain.y = {Boundary::periodic, 1.0, 1};
  c.drive.value = 5e4;
  c.lower.inclusions.clear();
  const double size = 4.0 * plan(c).lower.dz;
  c.lower.inclusions = {{{390e9, 0.3}, InclusionShape{Kind::ellipsoid, {0.0, 0.0, size}, {size, size, size}}}};
  expect_refusal(c, "`lower.inclusion[0]` ends along y");
  ball(c).kind = Kind::cylinder;
  expect_refusal(c, "`lower.inclusion[0]` ends along y"); // the axis is z
  ball(c).axis = 1;
  const std::size_t cells = plan(c).inclusions[0].cells;
  EXPECT_GT(cells, 0U);
  ball(c).kind = Kind::cuboid;
  EXPECT_GT(plan(c).inclusions[0].cells, cells);
  c.lower.inclusions.front().region = InclusionVoxels{{4, 1, 2}, {0.0, 0.0, 0.5 * size}, size, std::vector<char>(8, 1)};
  EXPECT_GT(plan(c).inclusions[0].cells, 0U);
  c.lower.inclusions.front().region = InclusionVoxels{{4, 2, 1}, {0.0, 0.0, 0.5 * size}, size, std::vector<char>(8, 1)};
  expect_refusal(c, "`lower.inclusion[0]` ends along y");
}

/// Under a load that causes a hundredth of the yield stress where the inclusion is, with a misfit.
RollingCase with_misfit(const Elastic& elastic, double misfit)
{
  RollingCase c = over(elastic);
  c.drive.value = 3e-3;
  c.lower.inclusions = {
      {elastic, InclusionShape{InclusionShape::Kind::ellipsoid, {0.0, 0.0, 20e-6}, {9e-6, 9e-6, 9e-6}}}};
  c.lower.inclusions.front().own.dilatation = misfit;
  c.spacing = {2.5e-6, 2.5e-6, 2e-6};
  c.distance = 6e-6;
  c.extent = 4.0;
  return c;
}

// Runs find the stress at rest on the whole grid, plans in a part of it. A tenth of the misfit on both sides: that part errs by little, and the stress is in
// proportion to the misfit.
TEST(InclusionRun, PlansForetellMisfitsThatYieldByThemselves)
{
  for (const Elastic& elastic : {steel.elastic, Elastic{600e9, 0.2}})
  {
    const double misfit = 1e-3, ratio = plan(with_misfit(elastic, misfit)).inclusions[0].at_rest;
    EXPECT_EQ(plan(with_misfit(elastic, misfit)).inclusions[0].cut, 0);
    EXPECT_GT(ratio, 0.0);
    EXPECT_NEAR(plan(with_misfit(elastic, 2.0 * misfit)).inclusions[0].at_rest, 2.0 * ratio, 1e-2 * ratio);
    const RollingSummary below = run(with_misfit(elastic, 0.9 * misfit / ratio)),
                         above = run(with_misfit(elastic, 1.1 * misfit / ratio));
    EXPECT_EQ(below.passes.back().max_equivalent_plastic_strain, 0.0);
    EXPECT_GT(above.passes.back().max_equivalent_plastic_strain, 0.0);
  }
  EXPECT_EQ(plan(over({390e9, 0.23})).inclusions[0].at_rest, 0.0);
}

// What a run tells of the equivalent strain: of few cells a matrix gives it without iterations, its residual is below the tolerance of 1e-6, and there are at
// least two evaluations a step.
TEST(InclusionRun, SummariesTellTheIterations)
{
  const RollingSummary plain = run(over(steel.elastic)), stiff = run(over({390e9, 0.23}));
  EXPECT_FALSE(plain.inclusions);
  ASSERT_TRUE(stiff.inclusions);
  EXPECT_GE(stiff.evaluations, 2L * stiff.steps);
  EXPECT_EQ(stiff.inclusions->iterations, 0);
  EXPECT_GT(stiff.inclusions->largest_residual, 0.0);
  EXPECT_LE(stiff.inclusions->largest_residual, 1e-6);
}

// Here a correction in each evaluation, and twice as many evaluations.
TEST(InclusionRun, ForecastsCountInclusions)
{
  const RollingCase with = over({390e9, 0.23}), without = over(steel.elastic);
  const auto seconds = [](const RollingCase& c)
  {
    const RollingPlan p = plan(c);
    Course course;
    course.kind = RunKind::rolling;
    course.loading = 2.0;
    course.moving = p.steps;
    return forecast(workload(c, p, p.half_width_x, course, {})).seconds;
  };
  EXPECT_GT(seconds(with), 2.0 * seconds(without));
}

} // namespace
} // namespace brinell::simulation::inclusion_run_test
