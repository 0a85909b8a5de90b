// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/io/case_template.hpp"

#include "brinell/foundation/error.hpp"
#include "brinell/io/case_file.hpp"
#include "io/embedded.hpp"
#include "io/files.hpp"
#include "io/pattern.hpp"
#include "io/scenarios/scenario_io.hpp"
#include "suggestion.hpp"
#include "value_text.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <iterator>
#include <sstream>
#include <utility>

namespace brinell::io
{

namespace
{

constexpr std::size_t line_width = 118;

constexpr std::string_view head = R"(# A case for brinell, written by `brinell new {}`. It runs as it is.
#
#   brinell check FILE    show its grid, steps, memory and cost
#   brinell run FILE      compute it
#
# A number is in SI units; text carries its unit ("200 GPa"). Lines that begin with "# key =" show a default or an
# allowed value: remove the # to use them. `brinell schema` describes every key.

)";

/// Wraps a text. The first line begins with `first`, the others with `indent`; both end with a blank.
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
  return key.substr(key.rfind('.') + 1); // without a dot: npos + 1 = 0
}

std::string meaning(const Entry& entry)
{
  std::string text = entry.text;
  if (entry.of.type == Type::snapshots)
    text += fmt::format(" Allowed: {}.", allowed_values(entry));
  if (!entry.fallback && !entry.unset.empty() && entry.unset != entry.excludes)
    text += fmt::format(" Without it: {}.", entry.unset);
  if (!entry.excludes.empty())
    text += fmt::format(" Not together with {}.", last_part(entry.excludes));
  return text;
}

/// Meaning of a key, or of a table that is written on one line: the meaning of its choice or, without one, of all its keys
/// but those of tables within it.
std::string meaning(const std::string& key)
{
  if (const Entry* entry = find_entry(key))
    return meaning(*entry);
  std::string text;
  for (const Entry& entry : case_schema())
  {
    if (!entry.key.starts_with(key + ".") || entry.key.find('.', key.size() + 1) != entry.key.npos)
      continue;
    if (entry.of.type == Type::choice)
      return meaning(entry);
    text += fmt::format("{}: {} ", last_part(entry.key), entry.text);
  }
  return text;
}

/// Whether the bodies of the scenario may have any shape.
bool has_any_shape(std::string_view scenario)
{
  bool allows_any = false;
  for_each_scenario([&](const auto& io)
                    { allows_any |= io.name == scenario && io.against_shape(simulation::Plane()).empty(); });
  return allows_any;
}

using Lines = std::vector<std::string>;

/// Lines that set one key, in use or as a comment. With an empty key: the keys of the table without a line of their own, as
/// "#   key such as ...:".
struct KeyLines
{
  std::string key;
  Lines lines;
};

struct Section
{
  std::string table; ///< empty: the root
  std::string ruler; ///< the separating comment before the table's name, if there is one
  std::vector<KeyLines> keys{{}};

  [[nodiscard]] Lines lines_of(std::string_view key) const
  {
    const auto found = std::find_if(keys.begin(), keys.end(), [&](const KeyLines& k) { return k.key == key; });
    return found == keys.end() ? Lines{} : found->lines;
  }
};

/// Splits TOML into its tables.
/// @param text  each key is on one line; a line with "#   " belongs to the key before it. Other comments are dropped, because the
///              meaning of a key is taken from the schema
std::vector<Section> sections_of(std::string_view text)
{
  static const Pattern section_line(R"(\[([a-z.@]+)\].*)"), key_line(R"((?:# )?([a-z_]+) = .*)");
  std::istringstream stream{std::string(text)};
  std::vector<Section> sections(1);
  std::string ruler; // of the next table
  for (std::string line; std::getline(stream, line);)
  {
    std::vector<KeyLines>& keys = sections.back().keys;
    const bool belongs_to_key = line.starts_with("#   ") || (line.starts_with("# ") && line.ends_with(':'));
    if (const auto header = section_line.match(line))
      sections.push_back({header->group(0), std::exchange(ruler, {})});
    else if (const auto match = key_line.match(line))
    {
      if (keys.back().key != match->group(0))
        keys.push_back({match->group(0), {}});
      keys.back().lines.push_back(line);
    }
    else if (line.starts_with("# ---"))
      ruler = line;
    else if (belongs_to_key && !sections.back().table.empty())
      keys.back().lines.push_back(line);
  }
  return sections;
}

/// "cone" of `shape = { type = "cone", ... }`; empty if the line chooses nothing.
std::string choice_of(const std::string& line)
{
  static const Pattern choice(R"(.*\{ (?:type|law) = "([a-z_]+)\".*)");
  const auto match = choice.match(line);
  return match ? match->group(0) : "";
}

/// Writes the template of a scenario: the case of the folder cases/NAME, table by table. In each table the further allowed keys
/// follow as comments: "# key = example" (src/io/case/template.toml), "# key = default" (the schema), and last the keys that have
/// neither, as "#   key:". The meaning from the schema stands before the first line of a key, or after the name of a key without
/// a line. The keys of the upper body are explained at the lower body only.
class Writer
{
public:
  explicit Writer(std::string_view scenario)
      : scenario_(scenario), of_case_(sections_of(embedded_text(fmt::format("cases/{}/case.toml", scenario)))),
        shows_shapes_(has_any_shape(scenario) && section("grid").lines_of("size").empty()) // without a period
  {
  }

  std::string text()
  {
    for (const KeyLines& key : of_case_.front().keys)
      put(key);
    std::vector<Section> menus = sections_of(embedded_text("src/io/case/template.toml"));
    for (Section& menu : menus)
    {
      menu.table = menu.table == "@" ? scenario_ : menu.table;
      if (!menu.table.empty())
        put(menu);
    }
    return text_;
  }

private:
  [[nodiscard]] Section section(std::string_view table) const
  {
    const auto found =
        std::find_if(of_case_.begin(), of_case_.end(), [&](const Section& s) { return s.table == table; });
    return found == of_case_.end() ? Section{} : *found;
  }

  /// Writes lines; in a line "#   key ...:", the meaning of the key is added.
  void put(const Lines& lines)
  {
    static const Pattern further_line(R"(#   ([a-z_]+)\b.*:)");
    for (const std::string& line : lines)
      if (const auto match = further_line.match(line))
      {
        const std::string of_key = meaning(fmt::format("{}{}.{}", table_, key_, match->group(0)));
        const std::string text = of_key.empty() ? meaning(table_ + match->group(0)) : of_key;
        text_ += wrapped(fmt::format("{} {}", line.substr(4), text), "#   ", "#     ");
      }
      else
        text_ += line + '\n';
  }

  void put(const KeyLines& key)
  {
    if (key.key.empty()) // written by put_rest
      return;
    if (!table_.starts_with("upper"))
    {
      text_ += key_.empty() ? "" : "\n"; // between the keys of a section
      text_ += wrapped(meaning(table_ + key.key), "# ", "# ");
      key_ = key.key;
    }
    put(key.lines);
  }

  void put(const Section& menu)
  {
    const Section own = section(menu.table);
    Lines names =
        menu.table.starts_with("upper") ? Lines{} : children(menu.table, scenario_); // explained at the lower body
    std::erase_if(names, [&](const std::string& name)
                  { return !section(fmt::format("{}.{}", menu.table, name)).table.empty(); });
    if (own.keys.size() == 1 && names.empty())
      return;
    text_ += fmt::format("\n{}{}[{}]\n", menu.ruler, menu.ruler.empty() ? "" : "\n\n", menu.table);
    table_ = menu.table + ".";
    key_.clear();
    for (const KeyLines& key : own.keys)
    {
      put(key);
      put_examples(key, menu.lines_of(key.key));
    }
    for (const KeyLines& key : menu.keys)
      if (own.lines_of(key.key).empty() && std::find(names.begin(), names.end(), key.key) != names.end())
        put(key);
    put_rest(menu, own, names);
  }

  /// Writes examples of the other choices of a key that is in use.
  void put_examples(const KeyLines& key, const Lines& examples)
  {
    const std::string chosen = key.lines.empty() ? "" : choice_of(key.lines.front());
    if (chosen.empty() || (key.key == "shape" && !shows_shapes_))
      return;
    Lines others;
    std::copy_if(examples.begin(), examples.end(), std::back_inserter(others),
                 [&](const std::string& line) { return choice_of(line) != chosen; });
    put(others);
  }

  /// Writes the keys that the schema allows and that have not been written yet.
  void put_rest(const Section& menu, const Section& own, const Lines& names)
  {
    Lines added;
    const Lines examples = menu.lines_of("");
    for (const std::string& name : names)
    {
      if (!own.lines_of(name).empty() || !menu.lines_of(name).empty())
        continue;
      const Entry* entry = find_entry(fmt::format("{}.{}", menu.table, name));
      const auto fallback = entry ? fallback_of(*entry, scenario_) : std::nullopt;
      const auto example = std::find_if(examples.begin(), examples.end(),
                                        [&](const std::string& line) { return line.starts_with("#   " + name + " "); });
      if (fallback && own.lines_of(last_part(entry->excludes)).empty())
        put(KeyLines{name, {fmt::format("# {} = {}", name, toml_text(*fallback))}});
      else
        added.push_back(example != examples.end() ? *example : fmt::format("#   {}:", name));
    }
    if (!added.empty())
      text_ += "\n# May be added:\n";
    put(added);
  }

  std::string scenario_;
  std::vector<Section> of_case_;
  bool shows_shapes_;
  std::string table_, key_; ///< current position: the table, with a dot at its end, and the last key in it
  std::string text_;
};

} // namespace

const std::vector<std::string>& scenario_names()
{
  return find_entry("scenario")->choices;
}

std::string case_template(std::string_view scenario)
{
  const auto& names = scenario_names();
  if (std::find(names.begin(), names.end(), scenario) == names.end())
    throw InputError(fmt::format("unknown scenario {}; allowed: {}", scenario, fmt::join(names, ", ")));
  return fmt::format(head, scenario) + Writer(scenario).text();
}

void write_case_template(std::string_view scenario, const std::filesystem::path& file, bool replace)
{
  const std::string text = case_template(scenario);
  if (!replace && std::filesystem::exists(file))
    throw InputError(fmt::format("{}: exists already; --force replaces it", file.string()));
  replace_file(file, text);
}

} // namespace brinell::io
