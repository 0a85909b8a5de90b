// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/simulation/columns.hpp"
#include "scenario_runs.hpp"

#include <gtest/gtest.h>

#include <type_traits>

namespace brinell::verification
{

/// That a run goes on from a checkpoint to the same end as the whole one, to the last digit.
/// @returns the last record
template <typename Case>
auto expect_same_end(const simulation::Run<Case>& whole, const Case& taken_up, const Archive::Fields& checkpoint)
{
  simulation::Run<Case> second(taken_up, {}, &checkpoint);
  while (!second.is_done())
    static_cast<void>(second.step());
  const auto a = whole.summary().last, b = second.summary().last;
  for (const auto& column : simulation::columns<std::remove_const_t<decltype(a)>>)
    EXPECT_EQ(column.value(a), column.value(b)) << column.name;
  EXPECT_EQ(whole.summary().max_temperature, second.summary().max_temperature);
  return b;
}

} // namespace brinell::verification
