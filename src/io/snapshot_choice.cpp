// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/io/snapshot_choice.hpp"

#include <algorithm>
#include <cmath>

namespace brinell::io
{

bool SnapshotChoice::operator()(const simulation::StepRecord& record)
{
  using Kind = SnapshotRule::Kind;
  switch (m_rule.kind)
  {
  case Kind::none:
    return false;
  case Kind::all:
    return true;
  case Kind::every:
    return record.step % m_rule.every == 0;
  case Kind::listed:
    return std::binary_search(m_rule.steps.begin(), m_rule.steps.end(), record.step);
  case Kind::aligned:
    return nearest_to_alignment(record);
  }
  return false;
}

/// The next step is not known yet: it is taken to be as long as this one was.
bool SnapshotChoice::nearest_to_alignment(const simulation::StepRecord& record)
{
  const bool first = record.pass != m_pass;
  if (first)
    m_aligned_is_stored = false;
  const double next_X = record.X + (record.X - m_X);
  const bool nearest = record.X >= 0.0 || (!first && std::abs(record.X) <= std::abs(next_X));
  m_pass = record.pass;
  m_X = record.X;
  if (m_aligned_is_stored || !nearest)
    return false;
  m_aligned_is_stored = true;
  return true;
}

} // namespace brinell::io
