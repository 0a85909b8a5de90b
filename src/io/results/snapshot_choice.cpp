// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/io/snapshot_choice.hpp"

#include "io/scenarios/scenario_io.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace brinell::io
{

bool SnapshotRule::stores(int step, bool is_key_step) const
{
  switch (kind)
  {
  case Kind::none:
    return false;
  case Kind::all:
    return true;
  case Kind::every:
    return step % every == 0;
  case Kind::listed:
    return std::binary_search(steps.begin(), steps.end(), step);
  case Kind::aligned:
    return is_key_step;
  }
  return false;
}

/// The next position is not known yet, so the next step is assumed to be as long as this one.
bool NearestToMiddle::operator()(int pass, double x)
{
  const bool first = pass != pass_;
  if (first)
    is_stored_ = false;
  const double next = x + (x - x_);
  const bool nearest = x >= 0.0 || (!first && x > x_ && std::abs(x) <= std::abs(next));
  pass_ = pass;
  x_ = x;
  if (is_stored_ || !nearest)
    return false;
  is_stored_ = true;
  return true;
}

void NearestToMiddle::exchange(Archive& archive)
{
  archive("pass", pass_);
  archive("x", x_);
  archive("is_stored", is_stored_);
}

std::optional<quality::Warning> missing_steps(const SnapshotRule& rule, int last_step)
{
  if (rule.kind != SnapshotRule::Kind::listed)
    return std::nullopt;
  const std::vector<int> missing(std::upper_bound(rule.steps.begin(), rule.steps.end(), last_step), rule.steps.end());
  if (missing.empty())
    return std::nullopt;
  return quality::Warning{"missing_snapshot",
                          fmt::format("output.snapshots asks for the fields of {} {}, but the last step is {}",
                                      missing.size() == 1 ? "step" : "steps", fmt::join(missing, ", "), last_step)};
}

bool SnapshotChoice::operator()(const simulation::AnyCase& scenario, const simulation::AnyRecord& record)
{
  return std::visit(
      [&]<typename ScenarioCase>(const ScenarioCase& c)
      {
        const auto& row = record_of<ScenarioCase>(record);
        return rule_.stores(row.step, io_of(c).is_key_step(c, row, middle_));
      },
      scenario);
}

} // namespace brinell::io
