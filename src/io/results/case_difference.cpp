// SPDX-License-Identifier: BSD-3-Clause
#include "case_difference.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <map>
#include <sstream>
#include <utility>
#include <vector>

namespace brinell::io
{

namespace
{

using Keys = std::vector<std::pair<std::string, std::string>>;

/// Prefix of the keys of a table: "grid." for "[grid]", and "lower.texture[1]." for the second "[[lower.texture]]".
std::string prefix_of(const std::string& heading, std::map<std::string, int>& lists)
{
  if (!heading.starts_with("[["))
    return heading.substr(1, heading.find(']') - 1) + ".";
  const std::string list = heading.substr(2, heading.find(']') - 2);
  return fmt::format("{}[{}].", list, lists[list]++);
}

/// All keys of a resolved case with their values as written. In a resolved case each key is on a line of its own.
Keys keys_of(std::string_view text)
{
  Keys keys;
  std::string prefix;
  std::map<std::string, int> lists;
  std::istringstream lines{std::string(text)};
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with('['))
      prefix = prefix_of(line, lists);
    else if (const auto equals = line.find(" = "); equals != line.npos)
    {
      const std::string key = prefix + line.substr(0, equals);
      if (key != "grid.extent" && key != "output.checkpoint_interval" &&
          key != "solver.symmetry") // these keys do not change results
        keys.emplace_back(key, line.substr(equals + 3));
    }
  return keys;
}

const std::string* value_in(const Keys& keys, const std::string& key)
{
  const auto found = std::find_if(keys.begin(), keys.end(), [&](const auto& item) { return item.first == key; });
  return found == keys.end() ? nullptr : &found->second;
}

/// The value without the comment with its unit, shortened if it is long, such as a height map.
std::string shown(const std::string* value)
{
  constexpr std::size_t longest = 60;
  if (!value)
    return "not set";
  const auto unit = value->rfind(" # ");
  const std::string text = value->ends_with('"') ? *value : value->substr(0, unit);
  return text.size() <= longest ? text : text.substr(0, longest - 3) + "...";
}

} // namespace

std::string case_difference(std::string_view there, std::string_view here)
{
  constexpr std::size_t most_named = 4;
  const Keys before = keys_of(there), now = keys_of(here);
  std::vector<std::string> differences;
  const auto compare = [&](const std::string& key)
  {
    const std::string *old = value_in(before, key), *given = value_in(now, key);
    if (!old || !given || *old != *given)
      differences.push_back(fmt::format("{} = {} there, {} here", key, shown(old), shown(given)));
  };
  for (const auto& [key, value] : now)
    compare(key);
  for (const auto& [key, value] : before)
    if (!value_in(now, key))
      compare(key);
  std::string text;
  for (std::size_t i = 0; i < std::min(most_named, differences.size()); ++i)
    text += (i == 0 ? "" : "; ") + differences[i];
  if (differences.size() > most_named)
    text += fmt::format("; and {} more", differences.size() - most_named);
  return text;
}

} // namespace brinell::io
