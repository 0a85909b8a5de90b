// SPDX-License-Identifier: BSD-3-Clause
// Runs over inclusions: a ball that rolls over one, and what plans do with them.
#include "brinell/foundation/error.hpp"
#include "brinell/simulation/rolling.hpp"
#include "brinell/simulation/run.hpp"

#include <gtest/gtest.h>

#include <cmath>
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

TEST(InclusionRun, RefusesInclusionsBeneathTheGrid)
{
  RollingCase c = over({100e9, 0.3});
  std::get<InclusionShape>(c.lower.inclusions.front().region).centre[2] = 1e-3;
  EXPECT_THROW((void)run(c), InputError);
}

} // namespace
} // namespace brinell::simulation::inclusion_run_test
