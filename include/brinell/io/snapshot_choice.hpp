// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/archive.hpp"
#include "brinell/io/schema.hpp"
#include "brinell/quality/quality.hpp"
#include "brinell/simulation/scenarios.hpp"

#include <optional>

namespace brinell::io
{

/// Finds the step nearest to the middle of each pass, while the steps come in.
class NearestToMiddle
{
public:
  /// To be called once per step, in order.
  /// @param x  position, ascending in a pass, 0 in its middle
  [[nodiscard]] bool operator()(int pass, double x);
  void exchange(Archive& archive);

private:
  int pass_ = -1;          ///< pass of the previous step
  double x_ = 0.0;         ///< position of the previous step
  bool is_stored_ = false; ///< whether a step of this pass is stored already
};

/// Warning about steps of `output.snapshots` that a finished run does not have.
[[nodiscard]] std::optional<quality::Warning> missing_steps(const SnapshotRule& rule, int last_step);

/// Decides after each step whether its fields are to be stored. To be called once per step, in order.
class SnapshotChoice
{
public:
  explicit SnapshotChoice(SnapshotRule rule) : rule_(std::move(rule)) {}

  /// @param record  of that scenario
  [[nodiscard]] bool operator()(const simulation::AnyCase& scenario, const simulation::AnyRecord& record);

  void exchange(Archive& archive) { middle_.exchange(archive); }

private:
  SnapshotRule rule_;
  NearestToMiddle middle_;
};

} // namespace brinell::io
