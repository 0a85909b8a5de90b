// SPDX-License-Identifier: BSD-3-Clause
#include "old_names.hpp"

#include "brinell/io/schema.hpp"

#include <algorithm>

namespace brinell::io
{

namespace
{

constexpr std::string_view each = "[]."; // behind the list of tables of whose entries one member is meant

bool is_of_list(const std::string& key, const std::string& list)
{
  return key.starts_with(list + "[") || key.starts_with(list + ".");
}

class Renaming
{
public:
  Renaming(const GivenByOldName& item, RawCase& raw_case, Problems& problems)
      : name_(*item.name), given_(item.given), raw_(raw_case), problems_(problems)
  {
    given_.old_name = name_.old_key;
  }

  void take()
  {
    const auto at = name_.key.find(each);
    if (at == name_.key.npos)
      take_value(std::string(name_.key));
    else
      take_list(std::string(name_.key.substr(0, at)), std::string(name_.key.substr(at + each.size())));
  }

private:
  /// Whether a value stands in the same layer: in the file beside the old name, or in the very same override.
  [[nodiscard]] bool is_beside(const Given& other) const
  {
    return given_.from_command_line ? other.place == given_.place : !other.from_command_line;
  }

  [[nodiscard]] bool clashes(std::string_view key, const Given& other)
  {
    if (!is_beside(other) || other.old_name == name_.old_key)
      return false;
    problems_.add(given_.place,
                  fmt::format("{} is an old name of {}, which is given, too; keep {}", name_.old_key, key, key));
    return true;
  }

  void take_value(const std::string& key)
  {
    if (const Given* other = raw_.find(key); other && clashes(key, *other))
      return;
    raw_.values.insert_or_assign(key, given_);
    raw_.by_old_name.insert_or_assign(std::string(name_.old_key), 1);
  }

  void take_list(const std::string& list, const std::string& member)
  {
    const auto* items = std::get_if<std::vector<Raw>>(&given_.raw.value);
    if (!items || items->empty())
    {
      problems_.add(given_.place,
                    fmt::format("{} = {} is {}; allowed: a list with an entry per table of {}", name_.old_key,
                                shown(given_.raw), items ? "empty" : type_name(given_.raw), list));
      return;
    }
    for (const auto& [key, other] : raw_.values)
      if (is_of_list(key, list) && other.old_name.empty() && clashes(list, other))
        return;
    // Of what an earlier layer gives, new names are replaced as a whole, old ones member by member, as they were.
    std::erase_if(raw_.values,
                  [&](const auto& item) {
                    return is_of_list(item.first, list) &&
                           (item.second.old_name.empty() || item.first.ends_with("]." + member));
                  });
    for (std::size_t i = 0; i < items->size(); ++i)
    {
      Given entry = given_;
      entry.raw = (*items)[i];
      raw_.values.insert_or_assign(fmt::format("{}[{}].{}", list, i, member), std::move(entry));
    }
    const auto count = static_cast<int>(items->size());
    raw_.by_old_name.insert_or_assign(std::string(name_.old_key), count);
    int& length = raw_.lists[list];
    length = count;
    for (const OldName& other : old_names()) // members of the same tables
      if (other.key.starts_with(list + "[") && raw_.by_old_name.contains(other.old_key))
        length = std::max(length, raw_.by_old_name.find(other.old_key)->second);
  }

  const OldName& name_;
  Given given_;
  RawCase& raw_;
  Problems& problems_;
};

} // namespace

void take_old_names(const std::vector<GivenByOldName>& given, RawCase& raw_case, Problems& problems)
{
  for (const GivenByOldName& item : given)
  {
    Renaming(item, raw_case, problems).take();
    raw_case.warnings.push_back(
        {"old_name", fmt::format("{} is now called {}: the old name is understood in this version still, not in the "
                                 "next one",
                                 item.name->old_key, new_name_text(*item.name))});
  }
}

void check_old_lists(const RawCase& raw_case, Problems& problems)
{
  for (const OldName& name : old_names())
  {
    const auto at = name.key.find(each);
    const auto used = raw_case.by_old_name.find(name.old_key);
    if (at == name.key.npos || used == raw_case.by_old_name.end())
      continue;
    const auto list = raw_case.lists.find(name.key.substr(0, at));
    const auto first =
        raw_case.values.find(fmt::format("{}[0].{}", name.key.substr(0, at), name.key.substr(at + each.size())));
    if (list != raw_case.lists.end() && first != raw_case.values.end() && first->second.old_name == name.old_key &&
        list->second != used->second)
      problems.add(first->second.place, fmt::format("{} has {} of {} entries: one for each table of {} is needed",
                                                    name.old_key, used->second, list->second, list->first));
  }
}

} // namespace brinell::io
