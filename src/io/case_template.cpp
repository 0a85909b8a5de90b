// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/io/case_template.hpp"

#include "brinell/foundation/error.hpp"
#include "brinell/io/schema.hpp"
#include "replace_file.hpp"
#include "value_text.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <map>
#include <span>

namespace brinell::io
{

namespace
{

constexpr std::size_t line_width = 118;

/// What the case of a scenario says; all other keys are left at their defaults.
using Choices = std::map<std::string, std::string, std::less<>>;

Choices choices_of(std::string_view scenario)
{
  if (scenario == "tugging")
    return {{"title", R"("Two equal steel spheres tug past each other")"},
            {"lower.shape.type", "sphere"},
            {"lower.material.hardening.law", "perfect"},
            {"upper.shape.type", "sphere"},
            {"upper.material.hardening.law", "perfect"},
            {"tugging.interference", ""}};
  if (scenario == "indentation")
    return {{"title", R"("A steel ball is pressed into a softer steel")"},
            {"lower.shape.type", "flat"},
            {"lower.material.hardening.law", "linear"},
            {"upper.shape.type", "sphere"},
            {"indentation.load", ""}};
  return {{"title", R"("A ceramic ball rolls over a steel")"},
          {"lower.shape.type", "flat"},
          {"lower.material.hardening.law", "voce"},
          {"upper.shape.type", "sphere"},
          {"upper.material.young_modulus", R"("310 GPa")"},
          {"upper.material.poisson_ratio", "0.26"},
          {"rolling.load", ""}};
}

/// Constants of one law that would not suit another law with the same key.
const std::map<std::string, Choices, std::less<>>& examples_by_law()
{
  static const std::map<std::string, Choices, std::less<>> examples{
      {"swift_microstrain", {{"coefficient", R"("945 MPa")"}, {"offset", "20"}, {"exponent", "0.121"}}},
      {"ludwik", {{"exponent", "0.5"}}},
  };
  return examples;
}

std::string heading(std::string_view section)
{
  static const std::map<std::string, std::string, std::less<>> headings{
      {"lower", "The lower body"},
      {"upper", "The upper body, which is moved; it has all the keys of the lower one"},
      {"tugging", "The motion"},
      {"indentation", "Load and places"},
      {"rolling", "Load and track"},
      {"grid", "The cells"},
      {"solver", "The solver; there is seldom a reason to change it"},
      {"output", "The results"},
  };
  const auto found = headings.find(section);
  return found == headings.end() ? "" : found->second;
}

std::string_view parent(std::string_view key)
{
  const auto dot = key.rfind('.');
  return dot == key.npos ? "" : key.substr(0, dot);
}

std::string_view last_part(std::string_view key)
{
  return key.substr(key.rfind('.') + 1); // npos + 1 = 0
}

/// Comment lines with a hanging indent.
std::string comment(std::string_view text, std::string_view first = "# ", std::string_view rest = "# ")
{
  std::string result, line(first);
  bool line_has_word = false;
  for (std::size_t begin = 0; begin < text.size();)
  {
    const auto end = std::min(text.find(' ', begin), text.size());
    const auto word = text.substr(begin, end - begin);
    if (line_has_word && line.size() + 1 + word.size() > line_width)
    {
      result += line + '\n';
      line = rest;
      line_has_word = false;
    }
    line.append(line_has_word ? " " : "").append(word);
    line_has_word = true;
    begin = end + 1;
  }
  return result + line + '\n';
}

/// Whether a table stands on one line behind its key: one inside another, without tables of its own.
bool is_inline(std::string_view table)
{
  return !parent(table).empty() && std::none_of(case_schema().begin(), case_schema().end(),
                                                [&](const Entry& entry)
                                                {
                                                  const auto inner = parent(entry.key);
                                                  return inner.size() > table.size() && inner.starts_with(table) &&
                                                         inner[table.size()] == '.';
                                                });
}

bool is_in(const std::vector<std::string>& words, std::string_view word)
{
  return std::find(words.begin(), words.end(), word) != words.end();
}

class Writer
{
public:
  explicit Writer(std::string_view scenario) : scenario_(scenario), choices_(choices_of(scenario)) {}

  std::string text() &&
  {
    begin();
    const auto& schema = case_schema();
    for (auto entry = schema.begin(); entry != schema.end();)
    {
      const auto table = parent(entry->key);
      const auto end =
          std::find_if(entry, schema.end(), [&](const Entry& other) { return parent(other.key) != table; });
      if (is_inline(table))
        inline_table(std::string(table), {entry, end});
      else
        std::for_each(entry, end, [&](const Entry& one) { key(one); });
      entry = end;
    }
    return std::move(text_);
  }

private:
  void begin()
  {
    text_ += comment(fmt::format("A case for brinell, written by `brinell new {}`. It runs as it is.", scenario_));
    text_ += "#\n#   brinell check FILE    what it comes to: grid, steps, memory, cost\n"
             "#   brinell run FILE      compute it\n#\n";
    text_ += comment("A number is SI; text carries its unit (\"200 GPa\"). Lines that begin with \"# key =\" show a "
                     "default, or an example of what may stand there: remove the # to use them. `brinell schema` "
                     "tells more of every key.");
  }

  void open_section(std::string_view section)
  {
    if (section == section_)
      return;
    section_ = section;
    const std::string text = heading(section);
    if (!text.empty())
      text_ += fmt::format("\n# --- {} {}\n", text, std::string(line_width - 7 - text.size(), '-'));
    text_ += fmt::format("\n[{}]\n", section);
    section_start_ = text_.size();
  }

  /// Between the keys of a section.
  [[nodiscard]] const char* blank_line() const { return text_.size() == section_start_ ? "" : "\n"; }

  /// The upper body's keys are explained at the lower one's.
  [[nodiscard]] bool is_explained(const Entry& entry) const { return !entry.key.starts_with("upper."); }

  void key(const Entry& entry)
  {
    if (entry.when.key == "scenario" && !is_in(entry.when.values, scenario_))
      return;
    const auto choice = choices_.find(entry.key);
    const bool is_used = entry.required || choice != choices_.end();
    if (!is_used && !is_explained(entry))
      return;
    if (!parent(entry.key).empty())
      open_section(parent(entry.key));
    if (is_explained(entry))
      text_.append(blank_line()).append(comment(meaning(entry)));
    text_ += fmt::format("{}{} = {}\n", is_used ? "" : "# ", last_part(entry.key), value(entry));
  }

  [[nodiscard]] std::string value(const Entry& entry) const
  {
    if (entry.key == "scenario")
      return toml_string(scenario_);
    const auto choice = choices_.find(entry.key);
    if (choice != choices_.end() && !choice->second.empty())
      return choice->second;
    const std::optional<Value> fallback = fallback_of(entry, scenario_);
    return fallback ? toml_text(*fallback) : entry.example;
  }

  [[nodiscard]] static std::string meaning(const Entry& entry)
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

  /// The template of tugging counts the interference in units of first yield, which only round bodies have.
  [[nodiscard]] bool is_offered(std::string_view table, std::string_view choice) const
  {
    return scenario_ != "tugging" || !table.ends_with(".shape") || choice == "sphere";
  }

  void inline_table(const std::string& table, std::span<const Entry> entries)
  {
    const Entry& first = entries.front();
    const auto chosen = choices_.find(first.key);
    if (first.type != Type::choice)
    {
      if (is_explained(first))
        optional_table(table, entries);
      return;
    }
    if (!std::any_of(first.choices.begin(), first.choices.end(),
                     [&](const std::string& choice) { return is_offered(table, choice); }))
      return;
    const std::string used = chosen != choices_.end() ? chosen->second : "";
    if (!is_explained(first) && used.empty())
      return;
    open_section(parent(table));
    if (is_explained(first))
      text_.append(blank_line()).append(comment(meaning(first)));
    if (!used.empty())
      text_ += fmt::format("{} = {}\n", last_part(table), choice_table(entries, used));
    if (!is_explained(first))
      return;
    const std::string fallback = first.fallback ? std::get<std::string>(*first.fallback) : "";
    for (const std::string& choice : first.choices)
      if (choice != used && choice != fallback && is_offered(table, choice))
        text_ += fmt::format("# {} = {}\n", last_part(table), choice_table(entries, choice));
    further_keys(table, entries);
  }

  /// { type = "sphere", radius = "1 mm" }: what the choice requires, and what has no meaning without it.
  [[nodiscard]] static std::string choice_table(std::span<const Entry> entries, const std::string& choice)
  {
    const Entry& first = entries.front();
    std::string text = fmt::format("{{ {} = {}", last_part(first.key), toml_string(choice));
    for (const Entry& entry : entries.subspan(1))
      if (is_in(entry.when.values, choice) && entry.when.key == first.key && !is_further(entry))
        text += fmt::format(", {} = {}", last_part(entry.key), example(entry, choice));
    return text + " }";
  }

  [[nodiscard]] static std::string example(const Entry& entry, const std::string& choice)
  {
    if (const auto law = examples_by_law().find(choice); law != examples_by_law().end())
      if (const auto found = law->second.find(last_part(entry.key)); found != law->second.end())
        return found->second;
    return entry.example;
  }

  /// A key that may be added, whatever the choice.
  [[nodiscard]] static bool is_further(const Entry& entry)
  {
    return !entry.required && (entry.when.values.size() > 1 || entry.example.empty());
  }

  void further_keys(std::string_view table, std::span<const Entry> entries)
  {
    std::string text;
    for (const Entry& entry : entries.subspan(1))
      if (is_further(entry) && std::any_of(entry.when.values.begin(), entry.when.values.end(),
                                           [&](const std::string& choice) { return is_offered(table, choice); }))
      {
        const std::string shown = entry.example.empty() ? "" : fmt::format(" such as {}", entry.example);
        const std::string with = entry.when.values.size() < entries.front().choices.size() - 1
                                     ? fmt::format(" ({})", fmt::join(entry.when.values, ", "))
                                     : "";
        text += comment(fmt::format("{}{}{}: {}", last_part(entry.key), shown, with, meaning(entry)), "#   ", "#     ");
      }
    if (!text.empty())
      text_.append("# May be added:\n").append(text);
  }

  /// A table that is needed seldom, as a comment.
  void optional_table(const std::string& table, std::span<const Entry> entries)
  {
    open_section(parent(table));
    std::string text, values;
    for (const Entry& entry : entries)
    {
      text += fmt::format("{}{}: {}", text.empty() ? "" : " ", last_part(entry.key), entry.text);
      values += fmt::format("{}{} = {}", values.empty() ? "" : ", ", last_part(entry.key), entry.example);
    }
    text_ += fmt::format("\n{}# {} = {{ {} }}\n", comment(text), last_part(table), values);
  }

  std::string scenario_;
  Choices choices_;
  std::string section_, text_;
  std::size_t section_start_ = 0; ///< behind its name
};

} // namespace

const std::vector<std::string>& scenario_names()
{
  return find_entry("scenario")->choices;
}

std::string case_template(std::string_view scenario)
{
  if (!is_in(scenario_names(), scenario))
    throw InputError(fmt::format("unknown scenario {}; allowed: {}", scenario, fmt::join(scenario_names(), ", ")));
  return Writer(scenario).text();
}

void write_case_template(std::string_view scenario, const std::filesystem::path& file, bool replace)
{
  const std::string text = case_template(scenario);
  if (!replace && std::filesystem::exists(file))
    throw InputError(fmt::format("{}: exists already; --force replaces it", file.string()));
  replace_file(file, text);
}

} // namespace brinell::io
