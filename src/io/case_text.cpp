// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/io/case_file.hpp"
#include "value_text.hpp"

#include <fmt/format.h>

namespace brinell::io
{

namespace
{

/// Unit of a value, as a comment; none for what has no dimension.
std::string unit_comment(const CaseValues& values, const Entry& entry)
{
  if (entry.dimension == dimension::none)
    return "";
  if (!entry.pure_if.empty() && values.get<bool>(entry.pure_if))
    return entry.dimension == dimension::force ? " # P_c" : " # alpha_c";
  return fmt::format(" # {}", si_unit(entry.dimension));
}

} // namespace

std::string resolved_text(const CaseValues& values)
{
  std::string text;
  std::string table;
  for (const auto& [key, value] : values.all())
  {
    const auto dot = key.rfind('.');
    const std::string parent = dot == key.npos ? "" : key.substr(0, dot);
    if (parent != table)
      text += fmt::format("\n[{}]\n", parent);
    table = parent;
    text += fmt::format("{} = {}{}\n", dot == key.npos ? key : key.substr(dot + 1), toml_text(value),
                        unit_comment(values, *find_entry(key)));
  }
  return text;
}

} // namespace brinell::io
