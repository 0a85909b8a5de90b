// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/io/schema.hpp"
#include "brinell/simulation/tugging.hpp"

#include <limits>

namespace brinell::io
{

/// Says after each step whether its fields are to be stored. Asked once per step, in order.
class SnapshotChoice
{
public:
  explicit SnapshotChoice(SnapshotRule rule) : m_rule(std::move(rule)) {}

  [[nodiscard]] bool operator()(const simulation::StepRecord& record);

private:
  [[nodiscard]] bool nearest_to_alignment(const simulation::StepRecord& record);

  SnapshotRule m_rule;
  int m_pass = -1;                  ///< pass of the step before
  double m_X = 0.0;                 ///< and its X
  bool m_aligned_is_stored = false; ///< in this pass
};

} // namespace brinell::io
