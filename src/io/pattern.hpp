// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace brinell::io
{

/// Regular expression (ECMAScript). <regex> stays in pattern.cpp: to compile its templates takes longer than what uses them.
class Pattern
{
public:
  explicit Pattern(const char* expression, bool ignores_case = false);
  ~Pattern();
  Pattern(const Pattern&) = delete;
  Pattern& operator=(const Pattern&) = delete;

  struct Match
  {
    std::size_t begin, end;                         ///< of the match within the text
    std::vector<std::optional<std::string>> groups; ///< of parentheses; those that took no part are empty
    [[nodiscard]] std::string group(std::size_t i) const { return groups[i].value_or(""); }
  };
  /// The whole text matched; no match otherwise.
  [[nodiscard]] std::optional<Match> match(std::string_view text) const;
  /// The first match within the text.
  [[nodiscard]] std::optional<Match> find(std::string_view text) const;
  /// A match that begins where the text begins.
  [[nodiscard]] std::optional<Match> match_begin(std::string_view text) const;
  /// The text with all matches replaced.
  [[nodiscard]] std::string replaced(const std::string& text, const std::string& by) const;

private:
  struct Compiled;
  std::unique_ptr<const Compiled> compiled_;
};

} // namespace brinell::io
