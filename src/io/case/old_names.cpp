// SPDX-License-Identifier: BSD-3-Clause
#include "old_names.hpp"

#include "brinell/io/schema.hpp"

namespace brinell::io
{

namespace
{

/// Splits a new name "a.b[].c" into the list of tables a.b and the member c; of other names, the second part is empty.
std::pair<std::string, std::string> list_and_member(const OldName& name)
{
  constexpr std::string_view each = "[].";
  const auto at = name.key.find(each);
  return {std::string(name.key.substr(0, at)),
          at == name.key.npos ? "" : std::string(name.key.substr(at + each.size()))};
}

std::string key_of(const std::string& list, std::size_t i, const std::string& member)
{
  return fmt::format("{}[{}].{}", list, i, member);
}

/// Distributes a list given by an old name to a member of the tables of a list. If an earlier layer gave the list by its new
/// name, it is replaced as a whole; if it gave other members by old names, they are kept.
void distribute_list(const OldName& name, const Given& given, RawCase& raw_case)
{
  const auto parts = list_and_member(name);
  const std::string &list = parts.first,
                    &member = parts.second; // clang 14 does not capture structured bindings in a lambda
  std::erase_if(raw_case.values,
                [&](const auto& item)
                {
                  const auto& [key, other] = item;
                  return (key.starts_with(list + "[") || key.starts_with(list + ".")) &&
                         (other.old_name.empty() || other.old_name == name.old_key);
                });
  std::size_t count = 0;
  for (const Raw& item : std::get<std::vector<Raw>>(given.raw.value))
    raw_case.values.insert_or_assign(key_of(list, count++, member),
                                     Given{item, given.place, given.from_command_line, name.old_key});
  const auto has_table = [&](std::size_t i) // given by another member
  {
    const auto next = raw_case.values.lower_bound(key_of(list, i, ""));
    return next != raw_case.values.end() && next->first.starts_with(key_of(list, i, ""));
  };
  while (has_table(count))
    ++count;
  raw_case.lists[list] = static_cast<int>(count);
}

} // namespace

void take_old_name(const OldName& name, Given given, RawCase& raw_case, Problems& problems)
{
  given.old_name = name.old_key;
  raw_case.warnings.push_back(
      {"old_name", fmt::format("{} is now called {}: the old name is understood in this version still, not in the "
                               "next one",
                               name.old_key, new_name_text(name))});
  const auto [key, member] = list_and_member(name);
  const auto* items = std::get_if<std::vector<Raw>>(&given.raw.value);
  if (!member.empty() && (!items || items->empty()))
    return problems.add(given.place,
                        fmt::format("{} = {} is {}; allowed: a list with an entry per table of {}", name.old_key,
                                    shown(given.raw), items ? "empty" : type_name(given.raw), key));
  for (const auto& [other_key, other] : raw_case.values)
  {
    const bool is_in_same_layer = given.from_command_line ? other.place == given.place : !other.from_command_line;
    const bool is_same =
        member.empty() ? other_key == key : other_key.starts_with(key + "[") || other_key.starts_with(key + ".");
    if (is_same && is_in_same_layer && other.old_name.empty())
      return problems.add(given.place,
                          fmt::format("{} is an old name of {}, which is given, too; keep {}", name.old_key, key, key));
  }
  if (member.empty())
    raw_case.values.insert_or_assign(key, std::move(given));
  else
    distribute_list(name, given, raw_case);
}

void check_old_lists(const RawCase& raw_case, Problems& problems)
{
  for (const OldName& name : old_names())
  {
    const auto [list, member] = list_and_member(name);
    const Given* by_old_name = nullptr;
    int count = 0;
    for (; const Given* given = raw_case.find(key_of(list, static_cast<std::size_t>(count), member)); ++count)
      if (given->old_name == name.old_key)
        by_old_name = given;
    if (by_old_name && raw_case.lists.find(list)->second != count)
      problems.add(by_old_name->place, fmt::format("{} has {} of {} entries: one for each table of {} is needed",
                                                   name.old_key, count, raw_case.lists.find(list)->second, list));
  }
}

} // namespace brinell::io
