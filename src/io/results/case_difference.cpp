// SPDX-License-Identifier: BSD-3-Clause
#include "case_difference.hpp"

#include "io/case/toml_text.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <map>
#include <vector>

namespace brinell::io
{

namespace
{

using Keys = std::map<std::string, Raw>;

/// Adds the keys of a table that can change results. @param prefix  empty, or ends with a dot
void add_keys(const toml::table& table, const std::string& prefix, Keys& keys)
{
  for (const auto& [name, node] : table)
  {
    const std::string key = prefix + std::string(name.str());
    if (node.is_table())
      add_keys(*node.as_table(), key + ".", keys);
    else if (node.is_array_of_tables())
      for (std::size_t i = 0; i < node.as_array()->size(); ++i)
        add_keys(*node.as_array()->get_as<toml::table>(i), fmt::format("{}[{}].", key, i), keys);
    else if (key != "grid.extent" && key != "output.checkpoint_interval" && key != "solver.symmetry" &&
             key != "solver.device")
      keys.emplace(key, raw_value(node));
  }
}

Keys keys_of(std::string_view text)
{
  Keys keys;
  add_keys(parse_toml(text, "resolved.toml"), "", keys);
  return keys;
}

std::string value_in(const Keys& keys, const std::string& key)
{
  const auto found = keys.find(key);
  return found == keys.end() ? "not set" : shown(found->second);
}

} // namespace

std::string case_difference(std::string_view there, std::string_view here)
{
  constexpr std::size_t most_named = 4;
  const Keys before = keys_of(there), now = keys_of(here);
  Keys all = before;
  all.insert(now.begin(), now.end());
  std::vector<std::string> differences;
  for (const auto& [key, value] : all)
    if (!before.contains(key) || !now.contains(key) || before.at(key) != now.at(key))
      differences.push_back(fmt::format("{} = {} there, {} here", key, value_in(before, key), value_in(now, key)));
  std::string text;
  for (std::size_t i = 0; i < std::min(most_named, differences.size()); ++i)
    text += (i == 0 ? "" : "; ") + differences[i];
  if (differences.size() > most_named)
    text += fmt::format("; and {} more", differences.size() - most_named);
  return text;
}

} // namespace brinell::io
