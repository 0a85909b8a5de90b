// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/io/member_keys.hpp"

#include "brinell/io/schema.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace brinell::io
{

namespace
{

using Names = std::pair<std::string_view, std::string_view>;

/// Tables whose keys are called like the members of a class. An entry whose key has another name than its member says so itself.
constexpr std::array tables{Names{"TuggingCase", "tugging"},
                            Names{"RollingCase", "rolling"},
                            Names{"SlidingCase", "sliding"},
                            Names{"FrettingCase", "fretting"},
                            Names{"IndentationCase", "indentation"},
                            Names{"Domain", "grid"},
                            Names{"Numerics", "grid"},
                            Names{"Settings", "solver"},
                            Names{"Friction", "interface"},
                            Names{"HeatSettings", "thermal"},
                            Names{"HeatSource", "thermal.source"}};

std::string_view second(const auto& list, std::string_view first)
{
  const auto found = std::find_if(list.begin(), list.end(), [&](const Names& names) { return names.first == first; });
  return found == list.end() ? std::string_view() : found->second;
}

} // namespace

std::string key_of_member(std::string_view member)
{
  for (const Entry& entry : case_schema())
    if (!entry.member.empty() && entry.member == member)
      return entry.key;
  const auto colons = member.find("::");
  const std::string_view table = second(tables, member.substr(0, colons));
  return table.empty() ? std::string(member) : std::string(table) + "." + std::string(member.substr(colons + 2));
}

std::string with_keys(std::string_view message)
{
  std::string text;
  for (;;)
  {
    const auto begin = message.find('`');
    const auto end = begin == message.npos ? begin : message.find('`', begin + 1);
    if (end == message.npos)
      return text + std::string(message);
    const std::string_view name = message.substr(begin + 1, end - begin - 1);
    const std::string key = key_of_member(name);
    text += message.substr(0, begin);
    if (find_entry(key) != nullptr || is_table(key))
    {
      text += key;
      message.remove_prefix(end + 1);
    }
    else // not a member: the second backtick may be the first of one
    {
      text += message.substr(begin, end - begin);
      message.remove_prefix(end);
    }
  }
}

} // namespace brinell::io
