// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/archive.hpp"
#include "brinell/io/schema.hpp"
#include "brinell/simulation/scenarios.hpp"

namespace brinell::io
{

/// The step nearest to the middle of each pass, known when it comes.
class NearestToMiddle
{
public:
  /// Asked once per step, in order.
  /// @param x  position, ascending in a pass, 0 in its middle
  [[nodiscard]] bool operator()(int pass, double x);
  void exchange(Archive& archive);

private:
  int pass_ = -1;          ///< of the step before
  double x_ = 0.0;         ///< and its position
  bool is_stored_ = false; ///< in this pass
};

/// Says after each step whether its fields are to be stored. Asked once per step, in order.
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
