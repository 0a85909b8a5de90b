// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/error.hpp"
#include "brinell/simulation/scenario.hpp"

#include <string>

namespace brinell::simulation
{

/// Puts the state of the last step into a summary; what was worked but neither dissipated nor is stored is an error.
/// @param largest_work  reached in the run [J]
void take_totals(const StepRecord& last, double largest_work, RunTotals& totals);

/// Takes up a run where a checkpoint of it was made, if there is one.
template <typename Run>
void resume(Run& run, const Archive::Fields* checkpoint)
{
  if (!checkpoint)
    return;
  Archive archive(*checkpoint);
  try
  {
    run.exchange(archive);
  }
  catch (const InputError& error)
  {
    throw InputError(std::string("checkpoint.h5: ") + error.what() + "; run without --resume");
  }
}

/// Tells the observer of a finished step.
/// @param snap  makes a snapshot, if it is wanted
template <typename Record, typename Run, typename Snap>
void report(const Observer<Record>& observer, const Record& record, int step_count, Run& run, const Snap& snap)
{
  if (observer.on_step)
    observer.on_step(record, step_count);
  if (observer.wants_snapshot && observer.on_snapshot && observer.wants_snapshot(record))
    observer.on_snapshot(record, snap());
  if (!observer.wants_checkpoint || !observer.on_checkpoint || !observer.wants_checkpoint(record))
    return;
  Archive archive;
  run.exchange(archive);
  observer.on_checkpoint(record, std::move(archive).fields());
}

} // namespace brinell::simulation
