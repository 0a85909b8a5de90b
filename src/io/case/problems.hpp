// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/error.hpp"
#include "brinell/io/member_keys.hpp"

#include <algorithm>
#include <charconv>
#include <fmt/format.h>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace brinell::io
{

/// A message with its place before it, if it has one.
inline std::string at_place(std::string_view place, std::string_view text)
{
  return place.empty() ? std::string(text) : fmt::format("{}: {}", place, text);
}

/// Collects the problems of a case, so that the user sees all of them at once.
class Problems
{
public:
  /// @param place  "file", "file:line" or "--set key=value"; empty for a case that a program has made
  /// @param text   may name members of the case (`with_keys`)
  void add(std::string_view place, std::string_view text)
  {
    problems_.push_back({line_number(place), at_place(place, with_keys(text))});
  }

  /// Adds a problem that may be the cause of all others, and is listed first.
  void add_cause(std::string_view place, std::string_view text) { problems_.push_back({0, at_place(place, text)}); }

  [[nodiscard]] bool empty() const { return problems_.empty(); }

  /// @throws InputError if there is any problem, with the problems in the order of the file
  void throw_if_any() const
  {
    if (problems_.empty())
      return;
    auto sorted = problems_;
    std::stable_sort(sorted.begin(), sorted.end(), [](const auto& a, const auto& b) { return a.line < b.line; });
    constexpr std::size_t most_shown = 20; // more problems probably have a common cause
    std::string text;
    for (std::size_t i = 0; i < std::min(most_shown, sorted.size()); ++i)
      text += (i == 0 ? "" : "\n") + sorted[i].text;
    if (sorted.size() > most_shown)
      text += fmt::format("\nand {} more", sorted.size() - most_shown);
    throw InputError(text);
  }

private:
  struct Problem
  {
    int line;
    std::string text;
  };

  /// Order of the messages: problems without a line (missing tables, command line) come last.
  static int line_number(std::string_view place)
  {
    int line = std::numeric_limits<int>::max();
    const auto digits = place.substr(place.rfind(':') + 1);
    if (!place.starts_with("--set"))
      std::from_chars(digits.data(), digits.data() + digits.size(), line);
    return line;
  }

  std::vector<Problem> problems_;
};

} // namespace brinell::io
