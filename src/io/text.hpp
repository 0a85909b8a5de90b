// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <string>
#include <string_view>

namespace brinell::io
{

/// The text without the characters of `around` at either end.
[[nodiscard]] inline std::string_view trimmed(std::string_view text, std::string_view around = " \t")
{
  text.remove_prefix(std::min(text.find_first_not_of(around), text.size()));
  return text.substr(0, text.find_last_not_of(around) + 1); // npos + 1 = 0
}

[[nodiscard]] inline std::string replaced(std::string text, std::string_view from, std::string_view to)
{
  for (auto at = text.find(from); at != text.npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
  return text;
}

} // namespace brinell::io
