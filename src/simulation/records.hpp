// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/simulation/scenario.hpp"

namespace brinell::simulation
{

/// Puts the state of the last step into a summary; what was worked but neither dissipated nor is stored is an error.
/// @param largest_work  reached in the run [J]
void take_totals(const StepRecord& last, double largest_work, RunTotals& totals);

/// Tells the observer of a finished step.
/// @param save  makes a checkpoint; @param snap makes a snapshot: both only if wanted
template <typename Record, typename Save, typename Snap>
void report(const Observer<Record>& observer, const Record& record, int step_count, const Snap& snap, const Save& save)
{
  if (observer.on_step)
    observer.on_step(record, step_count);
  if (observer.wants_snapshot && observer.on_snapshot && observer.wants_snapshot(record))
    observer.on_snapshot(record, snap());
  if (observer.wants_checkpoint && observer.on_checkpoint && observer.wants_checkpoint(record))
    observer.on_checkpoint(record, save());
}

} // namespace brinell::simulation
