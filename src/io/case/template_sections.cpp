// SPDX-License-Identifier: BSD-3-Clause
#include "template_sections.hpp"

#include <algorithm>
#include <regex>
#include <sstream>
#include <utility>

namespace brinell::io
{

const KeyLines* Section::find(std::string_view key) const
{
  const auto found = std::find_if(keys.begin(), keys.end(), [&](const KeyLines& k) { return k.key == key; });
  return found == keys.end() ? nullptr : &*found;
}

std::vector<Section> sections_of(std::string_view text)
{
  static const std::regex section_line(R"(\[([a-z.@]+)\].*)"), key_line(R"((?:# )?([a-z_]+) = .*)");
  std::istringstream stream{std::string(text)};
  std::vector<Section> sections(1);
  std::string ruler; // of the table that comes
  std::smatch match;
  for (std::string line; std::getline(stream, line);)
  {
    Section& section = sections.back();
    const bool goes_on = line.starts_with("#   ") || (line.starts_with("# ") && line.ends_with(':'));
    if (std::regex_match(line, match, section_line))
    {
      sections.push_back(
          {match.str(1), ruler.empty() ? Lines{line} : Lines{std::exchange(ruler, {}), "", line}, {}, {}});
    }
    else if (std::regex_match(line, match, key_line))
    {
      if (section.keys.empty() || section.keys.back().key != match.str(1))
        section.keys.push_back({match.str(1), {}});
      section.keys.back().lines.push_back(line);
    }
    else if (line.starts_with("# ---"))
      ruler = line;
    else if (goes_on && !section.table.empty())
      (section.keys.empty() ? section.added : section.keys.back().lines).push_back(line);
  }
  return sections;
}

const Section* find_section(const std::vector<Section>& sections, std::string_view table)
{
  const auto found = std::find_if(sections.begin(), sections.end(), [&](const Section& s) { return s.table == table; });
  return found == sections.end() ? nullptr : &*found;
}

std::string choice_of(const std::string& line)
{
  static const std::regex choice(R"(.*\{ (?:type|law) = "([a-z_]+)\".*)");
  std::smatch match;
  return std::regex_match(line, match, choice) ? match.str(1) : "";
}

} // namespace brinell::io
