// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/simulation/scenarios.hpp"

#include <memory>

namespace brinell::simulation
{

/// A run of a case that its owner steps: it keeps the bodies, the motion, the sums over the run, and can be stored and taken
/// up again between two steps. For the cases in `Scenarios`.
///
///     Run run(rolling_case);
///     while (!run.is_done())
///       use(run.step());
///     const RollingSummary summary = run.summary();
template <typename Case>
class Run
{
public:
  using Record = typename Case::Record;
  using Summary = typename Case::Summary;

  /// @param checkpoint  of the same case, from `checkpoint()`: the run goes on there.
  /// @throws InputError if the case cannot be computed or the checkpoint is of another case.
  explicit Run(Case scenario, Watch watch = {}, const Archive::Fields* checkpoint = nullptr);
  ~Run();
  Run(Run&&) noexcept;
  Run& operator=(Run&&) noexcept;

  [[nodiscard]] bool is_done() const;
  /// Solves the next step. Afterwards the run is where this step ended.
  /// @returns the row of the history, valid until the next step.
  /// @throws ConvergenceError, GridError, Interrupted: the run cannot go on then, nor be stored, and throws InputError.
  const Record& step();
  /// Of the whole run, an estimate.
  [[nodiscard]] int step_count() const;
  /// Fields after the last step.
  [[nodiscard]] Snapshot snapshot() const { return fields().whole(); }
  /// The same, computed when they are asked for. Not to be used after the next step, nor without this run.
  [[nodiscard]] StepFields fields() const;
  /// Everything that the rest of the run depends on.
  [[nodiscard]] Archive::Fields checkpoint();
  /// The same, shown to an archive, which may store it without a copy in memory.
  void checkpoint(Archive& archive);
  /// Of the steps so far.
  [[nodiscard]] Summary summary() const;
  /// The same without the fields within the bodies in its `final_state`.
  [[nodiscard]] Summary totals() const;

private:
  class State;
  std::unique_ptr<State> state_;
};

/// Takes all steps that are left, and tells the observer of each.
/// @throws InputError, ConvergenceError (all earlier steps have been reported to the observer).
template <typename Case>
void finish(Run<Case>& going, const Observer<typename Case::Record>& observer = {})
{
  while (!going.is_done())
  {
    const auto& record = going.step();
    if (observer.on_step)
      observer.on_step(record, going.step_count());
    if (observer.wants_snapshot && observer.on_snapshot && observer.wants_snapshot(record))
      observer.on_snapshot(record, going.fields());
    if (observer.wants_checkpoint && observer.on_checkpoint && observer.wants_checkpoint(record))
      observer.on_checkpoint(record, [&](Archive& archive) { going.checkpoint(archive); });
  }
}

/// Runs a case to its end, or goes on from a checkpoint of it, and tells the observer of every step.
/// @throws as `finish`
template <typename Case>
[[nodiscard]] typename Case::Summary run(const Case& scenario, const Observer<typename Case::Record>& observer = {},
                                         const Archive::Fields* checkpoint = nullptr)
{
  Run<Case> going(scenario, observer, checkpoint);
  finish(going, observer);
  return going.summary();
}

} // namespace brinell::simulation
