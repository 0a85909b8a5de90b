// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/io/case_template.hpp"

#include "brinell/foundation/error.hpp"
#include "brinell/io/schema.hpp"
#include "io/files.hpp"
#include "template_sections.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <regex>
#include <sstream>

namespace brinell::io
{

namespace
{

constexpr std::size_t line_width = 118;

constexpr std::string_view head = R"(# A case for brinell, written by `brinell new {}`. It runs as it is.
#
#   brinell check FILE    what it comes to: grid, steps, memory, cost
#   brinell run FILE      compute it
#
# A number is SI; text carries its unit ("200 GPa"). Lines that begin with "# key =" show a default, or an example of
# what may stand there: remove the # to use them. `brinell schema` tells more of every key.

)";

/// Text in lines that begin with `first` and `indent`, which end with a blank.
std::string wrapped(const std::string& text, std::string_view first, std::string_view indent)
{
  std::string result, line(first);
  std::istringstream words(text);
  for (std::string word; words >> word;)
  {
    if (line.size() + 1 + word.size() > line_width)
    {
      result += line + '\n';
      line = indent;
    }
    line += (line.ends_with(' ') ? "" : " ") + word;
  }
  return result + line + '\n';
}

std::string_view last_part(std::string_view key)
{
  return key.substr(key.rfind('.') + 1); // npos + 1 = 0
}

std::string meaning(const Entry& entry)
{
  std::string text = entry.text;
  if (entry.type == Type::snapshots)
    text += fmt::format(" Allowed: {}.", allowed_values(entry));
  if (!entry.fallback && !entry.unset.empty() && entry.unset != entry.excludes)
    text += fmt::format(" Without it: {}.", entry.unset);
  if (!entry.excludes.empty())
    text += fmt::format(" Not together with {}.", last_part(entry.excludes));
  return text;
}

/// Of a key, or of a table on one line: that of its choice, or else those of all its keys.
std::string meaning(const std::string& key)
{
  if (const Entry* entry = find_entry(key))
    return meaning(*entry);
  std::string text;
  for (const Entry& entry : case_schema())
  {
    if (!entry.key.starts_with(key + "."))
      continue;
    if (entry.type == Type::choice)
      return meaning(entry);
    text += fmt::format("{}: {} ", last_part(entry.key), entry.text);
  }
  return text;
}

} // namespace

const std::vector<std::string>& scenario_names()
{
  return find_entry("scenario")->choices;
}

/// The text of the schema goes before the first line of each key, and behind the names of those that may be added. The keys of
/// the upper body are explained at the lower one.
std::string case_template(std::string_view scenario)
{
  static const std::regex section_line(R"(\[([a-z.]+)\])"), key_line(R"((?:# )?([a-z_]+) = .*)"),
      further_line(R"(#   ([a-z_]+)\b.*:)");
  const auto& names = scenario_names();
  if (std::find(names.begin(), names.end(), scenario) == names.end())
    throw InputError(fmt::format("unknown scenario {}; allowed: {}", scenario, fmt::join(names, ", ")));
  std::istringstream keys(keys_of_template(scenario));
  std::string text = fmt::format(head, scenario), table, name;
  std::smatch match;
  for (std::string line; std::getline(keys, line);)
  {
    if (std::regex_match(line, match, section_line))
    {
      table = match.str(1) + ".";
      name.clear();
    }
    else if (std::regex_match(line, match, key_line) && name != match.str(1) && !table.starts_with("upper"))
    {
      text += name.empty() ? "" : "\n"; // between the keys of a section
      name = match.str(1);
      text += wrapped(meaning(table + name), "# ", "# ");
    }
    else if (std::regex_match(line, match, further_line))
    {
      const std::string of_key = meaning(table + name + "." + match.str(1)), of_table = meaning(table + match.str(1));
      text += wrapped(line.substr(4) + " " + (of_key.empty() ? of_table : of_key), "#   ", "#     ");
      continue;
    }
    text += line + '\n';
  }
  return text;
}

void write_case_template(std::string_view scenario, const std::filesystem::path& file, bool replace)
{
  const std::string text = case_template(scenario);
  if (!replace && std::filesystem::exists(file))
    throw InputError(fmt::format("{}: exists already; --force replaces it", file.string()));
  replace_file(file, text);
}

} // namespace brinell::io
