// SPDX-License-Identifier: BSD-3-Clause
#include "template_sections.hpp"

#include "brinell/io/case_file.hpp"
#include "io/embedded.hpp"
#include "io/scenarios/scenario_io.hpp"
#include "value_text.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <regex>
#include <sstream>
#include <utility>

namespace brinell::io
{

namespace
{

using Lines = std::vector<std::string>;

/// Lines that give one key, in use or as a comment.
struct KeyLines
{
  std::string key;
  Lines lines;
};

struct Section
{
  std::string table; ///< empty: the root
  Lines head;        ///< a ruler, and the line with its name
  Lines added;       ///< keys that have no line of their own: "#   key such as ...:"
  std::vector<KeyLines> keys;

  [[nodiscard]] const KeyLines* find(std::string_view key) const
  {
    const auto found = std::find_if(keys.begin(), keys.end(), [&](const KeyLines& k) { return k.key == key; });
    return found == keys.end() ? nullptr : &*found;
  }
};

/// @param text  TOML of which each key takes one line; "#   " goes on with the key before it. Other comments are left out: the
///              schema tells what a key means
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

/// "cone" of `shape = { type = "cone", ... }`; empty if the line chooses nothing.
std::string choice_of(const std::string& line)
{
  static const std::regex choice(R"(.*\{ (?:type|law) = "([a-z_]+)\".*)");
  std::smatch match;
  return std::regex_match(line, match, choice) ? match.str(1) : "";
}

/// Whether the bodies of the scenario may have any shape.
bool has_any_shape(std::string_view scenario)
{
  bool has = false;
  for_each_scenario([&](const auto& io)
                    { has |= io.name == scenario && io.against_shape(simulation::Plane()).empty(); });
  return has;
}

/// Writes the template of one scenario.
class Writer
{
public:
  explicit Writer(std::string_view scenario)
      : scenario_(scenario), text_of_case_(embedded_text(fmt::format("cases/{}/case.toml", scenario))),
        of_case_(sections_of(text_of_case_)),
        shows_shapes_(has_any_shape(scenario) && !(find("grid") && find("grid")->find("size"))) // without a period
  {
  }

  std::string text()
  {
    for (const KeyLines& key : of_case_.front().keys)
      put(key.lines);
    for (Section menu : sections_of(embedded_text("src/io/case/template.toml")))
      if (!menu.table.empty())
      {
        if (menu.table == "@")
        {
          menu.table = scenario_;
          menu.head.back() = fmt::format("[{}]", scenario_);
        }
        put(menu);
      }
    return text_;
  }

private:
  [[nodiscard]] const Section* find(std::string_view table) const { return find_section(of_case_, table); }

  void put(const Lines& lines)
  {
    for (const std::string& line : lines)
      text_ += line + '\n';
  }

  void put(const Section& menu)
  {
    const Section none, &own = find(menu.table) ? *find(menu.table) : none;
    const bool is_explained = menu.table.starts_with("upper"); // at the lower body
    const Lines names = is_explained ? Lines{} : keys_in(menu.table);
    if (own.keys.empty() && names.empty())
      return;
    text_ += '\n';
    put(menu.head);
    for (const KeyLines& key : own.keys)
    {
      put(key.lines);
      if (const KeyLines* examples = menu.find(key.key))
        put_examples(*examples, choice_of(key.lines.front()));
    }
    for (const KeyLines& key : menu.keys)
      if (!own.find(key.key) && std::find(names.begin(), names.end(), key.key) != names.end())
        put(key.lines);
    put_rest(menu, own, names);
  }

  /// Of a key in use, for which something else may be chosen.
  void put_examples(const KeyLines& examples, const std::string& chosen)
  {
    if (chosen.empty() || (examples.key == "shape" && !shows_shapes_))
      return;
    for (const std::string& line : examples.lines)
      if (choice_of(line) != chosen)
        text_ += line + '\n';
  }

  /// By the schema.
  void put_rest(const Section& menu, const Section& own, const Lines& names)
  {
    Lines added;
    for (const std::string& name : names)
    {
      const Entry* entry = find_entry(fmt::format("{}.{}", menu.table, name));
      if (own.find(name) || menu.find(name))
        continue;
      const auto fallback = entry ? fallback_of(*entry, scenario_) : std::nullopt;
      const auto example = std::find_if(menu.added.begin(), menu.added.end(),
                                        [&](const std::string& line) { return line.starts_with("#   " + name + " "); });
      const bool is_excluded = entry && own.find(entry->excludes.substr(entry->excludes.rfind('.') + 1));
      if (fallback && !is_excluded)
        text_ += fmt::format("# {} = {}\n", name, toml_text(*fallback));
      else
        added.push_back(example != menu.added.end() ? *example : fmt::format("#   {}:", name));
    }
    if (!added.empty())
      text_ += "\n# May be added:\n";
    put(added);
  }

  /// First parts of the keys in a table that the scenario knows, without those that are tables of the template.
  [[nodiscard]] Lines keys_in(const std::string& table) const
  {
    Lines names;
    for (const Entry& entry : case_schema())
    {
      const bool is_of_another =
          entry.when.key == "scenario" &&
          std::find(entry.when.values.begin(), entry.when.values.end(), scenario_) == entry.when.values.end();
      if (!entry.key.starts_with(table + ".") || is_of_another)
        continue;
      const std::string rest = entry.key.substr(table.size() + 1), name = rest.substr(0, rest.find('.'));
      if (!find(fmt::format("{}.{}", table, name)) && std::find(names.begin(), names.end(), name) == names.end())
        names.push_back(name);
    }
    return names;
  }

  std::string scenario_;
  std::string_view text_of_case_;
  std::vector<Section> of_case_;
  bool shows_shapes_;
  std::string text_;
};

} // namespace

std::string keys_of_template(std::string_view scenario)
{
  return Writer(scenario).text();
}

} // namespace brinell::io
