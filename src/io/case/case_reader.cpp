// SPDX-License-Identifier: BSD-3-Clause
#include "case_reader.hpp"

#include <algorithm>
#include <iterator>

namespace brinell::io
{

std::string CaseReader::only_one_of(std::string_view group, std::string_view advice) const
{
  const std::vector<std::string> all = keys_of_group(group);
  std::vector<std::string> given;
  std::copy_if(all.begin(), all.end(), std::back_inserter(given), [this](const std::string& key) { return has(key); });
  if (given.size() == 1)
    return given.front();
  if (given.empty())
    problems.add(place(all.front()), fmt::format("none of {} is given; one is needed{}", in_words(all), advice));
  else
    add(given[1], "cannot stand together with {}; keep one of them", given.front());
  return {};
}

std::string CaseReader::place(const std::string& key) const
{
  const Given* given = raw.find(key);
  return given ? given->place : raw.place_for(is_table(key) ? key + "." : key);
}

std::string CaseReader::cited(const std::string& key) const
{
  const Given* given = raw.find(key);
  const Value* value = values.find(key);
  return given ? fmt::format("{} = {}", key, shown(given->raw)) : (value ? key + " = " + toml_text(*value) : key);
}

} // namespace brinell::io
