// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/simulation/scenarios.hpp"

#include <memory>

namespace brinell::simulation
{

/// A run of a case that is advanced step by step. It holds the bodies, the motion and the totals of the run, and can be stored in
/// a checkpoint and resumed between two steps. For the cases in `Scenarios`.
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

  /// @param checkpoint  of the same case, from `checkpoint()`: the run resumes there.
  /// @throws InputError if the case cannot be computed or the checkpoint is of another case.
  explicit Run(Case scenario, Watch watch = {}, const Archive::Fields* checkpoint = nullptr);
  /// @param plan  that of the case, which is made otherwise; with large textures that takes a while
  Run(Case scenario, Watch watch, const Archive::Fields* checkpoint, const typename Case::Plan& plan);
  ~Run();
  Run(Run&&) noexcept;
  Run& operator=(Run&&) noexcept;

  [[nodiscard]] bool is_done() const;
  /// Solves the next step.
  /// @returns the row of the history, valid until the next step.
  /// @throws ConvergenceError, GridError, Interrupted. After these the run can be neither continued nor stored; attempts throw
  /// InputError.
  const Record& step();
  /// Estimated number of steps of the whole run.
  [[nodiscard]] int step_count() const;
  /// Fields after the last step.
  [[nodiscard]] Snapshot snapshot() const { return fields().whole(); }
  /// Fields after the last step, computed on demand. They must not be used after the next step or after this run.
  [[nodiscard]] StepFields fields() const;
  /// Everything that the rest of the run depends on.
  [[nodiscard]] Archive::Fields checkpoint();
  /// Passes the checkpoint to an archive, which may store it without a copy in memory.
  void checkpoint(Archive& archive);
  /// Summary of the steps so far.
  [[nodiscard]] Summary summary() const;
  /// Summary of the steps so far, without the fields within the bodies in its `final_state`.
  [[nodiscard]] Summary totals() const;

private:
  class State;
  std::unique_ptr<State> state_;
};

/// Solves all remaining steps and reports each to the observer.
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

/// Runs a case to its end, from the start or from a checkpoint, and reports every step to the observer.
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
