// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/simulation/run.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <numeric>
#include <vector>

/// Runs of surfaces that wear.
namespace brinell::simulation
{

template <typename Case>
struct WornRun
{
  std::vector<typename Case::Record> history;
  typename Case::Summary summary;
};

template <typename Case>
WornRun<Case> worn(const Case& c)
{
  WornRun<Case> result;
  simulation::Run run(c);
  while (!run.is_done())
    result.history.push_back(run.step());
  result.summary = run.summary();
  return result;
}

/// Volume of the worn depth [m^3].
inline double worn_volume(const BodySnapshot& body)
{
  return std::accumulate(body.effect("worn_depth").begin(), body.effect("worn_depth").end(), 0.0) *
         body.grid.surface.cell_area();
}

/// Checks that a run that goes on from a checkpoint wears the same to the last digit.
template <typename Case>
void expect_taken_up(const Case& c)
{
  simulation::Run<Case> whole(c);
  std::vector<Archive::Fields> checkpoints;
  while (!whole.is_done())
  {
    whole.step();
    checkpoints.push_back(whole.checkpoint());
  }
  const Snapshot expected = whole.snapshot();
  for (const std::size_t at : {std::size_t{0}, checkpoints.size() / 3, checkpoints.size() / 2})
  {
    simulation::Run<Case> later(c, {}, &checkpoints[at]);
    while (!later.is_done())
      later.step();
    EXPECT_EQ(later.snapshot().lower.effect("worn_depth"), expected.lower.effect("worn_depth")) << at;
    EXPECT_EQ(later.snapshot().upper.effect("worn_depth"), expected.upper.effect("worn_depth")) << at;
    EXPECT_EQ(later.summary().worn_volume_upper, whole.summary().worn_volume_upper) << at;
    EXPECT_EQ(later.summary().work_of_wear, whole.summary().work_of_wear) << at;
    EXPECT_EQ(later.summary().max_wear_step, whole.summary().max_wear_step) << at;
  }
}

} // namespace brinell::simulation
