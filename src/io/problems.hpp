// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/error.hpp"

#include <algorithm>
#include <charconv>
#include <fmt/format.h>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace brinell::io
{

/// Collects what is wrong with a case, so that the user sees all of it at once.
class Problems
{
public:
  /// @param place  "file", "file:line" or "--set key=value"
  void add(std::string_view place, std::string_view what)
  {
    m_problems.push_back({line_number(place), fmt::format("{}: {}", place, what)});
  }

  [[nodiscard]] bool empty() const { return m_problems.empty(); }

  /// @throws InputError if there is any problem; in the order of the file
  void throw_if_any() const
  {
    if (m_problems.empty())
      return;
    auto sorted = m_problems;
    std::stable_sort(sorted.begin(), sorted.end(), [](const auto& a, const auto& b) { return a.line < b.line; });
    std::string text;
    for (const Problem& problem : sorted)
      text += (text.empty() ? "" : "\n") + problem.text;
    throw InputError(text);
  }

private:
  struct Problem
  {
    int line;
    std::string text;
  };

  /// What has no line comes last: missing tables and the command line.
  static int line_number(std::string_view place)
  {
    int line = std::numeric_limits<int>::max();
    const auto digits = place.substr(place.rfind(':') + 1);
    if (!place.starts_with("--set"))
      std::from_chars(digits.data(), digits.data() + digits.size(), line);
    return line;
  }

  std::vector<Problem> m_problems;
};

} // namespace brinell::io
