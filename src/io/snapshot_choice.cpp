// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/io/snapshot_choice.hpp"

#include <algorithm>
#include <cmath>

namespace brinell::io
{

/// The next step is not known yet: it is taken to be as long as this one was.
bool NearestToMiddle::operator()(int pass, double x)
{
  const bool first = pass != m_pass;
  if (first)
    m_is_stored = false;
  const double next = x + (x - m_x);
  const bool nearest = x >= 0.0 || (!first && x > m_x && std::abs(x) <= std::abs(next));
  m_pass = pass;
  m_x = x;
  if (m_is_stored || !nearest)
    return false;
  m_is_stored = true;
  return true;
}

void NearestToMiddle::exchange(Archive& archive)
{
  archive("pass", m_pass);
  archive("x", m_x);
  archive("is_stored", m_is_stored);
}

bool SnapshotChoice::operator()(const simulation::TuggingCase&, const simulation::TuggingRecord& record)
{
  return chosen(record.step, m_middle(record.pass, record.X));
}

bool SnapshotChoice::operator()(const simulation::IndentationCase& c, const simulation::IndentationRecord& record)
{
  return chosen(record.step, (record.step + 1) % c.steps == 0);
}

bool SnapshotChoice::operator()(const simulation::RollingCase&, const simulation::RollingRecord& record)
{
  return chosen(record.step, m_middle(record.pass, record.x));
}

bool SnapshotChoice::chosen(int step, bool is_key_step) const
{
  using Kind = SnapshotRule::Kind;
  switch (m_rule.kind)
  {
  case Kind::none:
    return false;
  case Kind::all:
    return true;
  case Kind::every:
    return step % m_rule.every == 0;
  case Kind::listed:
    return std::binary_search(m_rule.steps.begin(), m_rule.steps.end(), step);
  case Kind::aligned:
    return is_key_step;
  }
  return false;
}

} // namespace brinell::io
