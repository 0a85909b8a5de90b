// SPDX-License-Identifier: BSD-3-Clause
#include "case_reader.hpp"

#include <fmt/ranges.h>

namespace brinell::io
{

std::string CaseReader::only_one_of(std::string_view group, std::string_view advice) const
{
  std::vector<std::string> all, given;
  for (const Entry& entry : case_schema())
    if (entry.one_of == group)
    {
      all.push_back(entry.key);
      if (has(entry.key))
        given.push_back(entry.key);
    }
  if (given.size() == 1)
    return given.front();
  if (given.empty())
    problems.add(place(all.front()), fmt::format("none of {} and {} is given; one is needed{}",
                                                 fmt::join(all.begin(), all.end() - 1, ", "), all.back(), advice));
  else
    add(given[1], "cannot stand together with {}; keep one of them", given.front());
  return {};
}

std::string CaseReader::place(const std::string& key) const
{
  const Given* given = raw.find(key);
  return given ? given->place : raw.place_for(key);
}

std::string CaseReader::cited(const std::string& key) const
{
  const Given* given = raw.find(key);
  const Value* value = values.find(key);
  return given ? fmt::format("{} = {}", key, shown(given->raw)) : (value ? key + " = " + toml_text(*value) : key);
}

} // namespace brinell::io
