// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/io/schema.hpp"

namespace brinell::io
{

/// Keys of one body, "lower" or "upper": shape, texture, material.
[[nodiscard]] std::vector<Entry> body_entries(const std::string& body);
/// Keys of the scenarios' own tables.
[[nodiscard]] std::vector<Entry> scenario_entries();

// Intervals of a number.
inline Range above(double min)
{
  return {.min = min, .min_allowed = false};
}
inline Range at_least(double min)
{
  return {.min = min};
}
inline Range between(double min, double max)
{
  return {.min = min, .max = max};
}
inline Range inside(double min, double max)
{
  return {.min = min, .max = max, .min_allowed = false, .max_allowed = false};
}

} // namespace brinell::io
