// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/foundation/deviator.hpp"
#include "brinell/halfspace/half_space.hpp"
#include "brinell/simulation/forecast.hpp"
#include "random_field.hpp"
#include "ranks_as_threads.hpp"

#include <gtest/gtest.h>
#include <omp.h>

/// What is foretold of several ranks.
namespace brinell::simulation::ranks_plan_test
{
namespace
{

/// Numbers that half spaces count as they pass them.
TEST(RanksPlan, TrafficIsWhatIsCounted)
{
  const VolumeGrid grid{{.nx = 60, .ny = 32, .dx = 1e-6, .dy = 1e-6}, 8, 1e-6};
  const std::vector<double> strain = test::random_field(Deviator::size * grid.size() / 2, 1); // of a rank
  const std::vector<double> pressure = test::random_field(grid.surface.size(), 2);
  const long counted = test::RanksAsThreads::run(
      2,
      [&](const std::shared_ptr<const Communicator>& rank)
      {
        omp_set_num_threads(1);
        const halfspace::HalfSpace shared(grid, {210e9, 0.3}, rank);
        halfspace::HalfSpace::Work work = shared.make_work();
        std::vector<double> stress(strain.size());
        shared.load(strain, grid.nz, work).stress({.pressure = pressure, .shear_x = {}, .shear_y = {}}, stress);
      });
  Plan plan;
  plan.lower = plan.upper = grid;
  plan.twin = elastoplastic::Twin::alike; // one body is solved
  const double passed = sizeof(double) * static_cast<double>(counted);
  EXPECT_NEAR(2.0 * bytes_sent_by_rank(plan, 2), passed, 0.1 * passed);
  EXPECT_EQ(bytes_sent_by_rank(plan, 1), 0.0);
  plan.twin = elastoplastic::Twin::none;
  EXPECT_NEAR(bytes_sent_by_rank(plan, 2), passed, 0.1 * passed) << "two bodies";
}

} // namespace
} // namespace brinell::simulation::ranks_plan_test
