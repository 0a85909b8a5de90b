// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/io/case_template.hpp"

#include "brinell/foundation/error.hpp"
#include "brinell/io/feasibility.hpp"
#include "brinell/io/schema.hpp"
#include "io/case/value_text.hpp"
#include "sample.hpp"

#include <map>
#include <regex>
#include <sstream>

namespace brinell::io::case_template_test
{

namespace
{

/// A line of a template that gives a key, in use or behind a #.
struct KeyLine
{
  std::size_t index;
  std::string section, key;
  bool in_use;

  [[nodiscard]] std::string full_key() const { return section.empty() ? key : section + "." + key; }
};

std::vector<std::string> lines_of(const std::string& text)
{
  std::istringstream stream(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);)
    lines.push_back(line);
  return lines;
}

std::vector<KeyLine> key_lines(const std::vector<std::string>& lines)
{
  static const std::regex section_line(R"(\[([a-z.]+)\])"), key_line("(# )?([a-z_]+) = .*");
  std::vector<KeyLine> result;
  std::string section;
  std::smatch match;
  for (std::size_t i = 0; i < lines.size(); ++i)
    if (std::regex_match(lines[i], match, section_line))
      section = match[1];
    else if (std::regex_match(lines[i], match, key_line))
      result.push_back({i, section, match[2], !match[1].matched});
  return result;
}

/// The template with one commented line in use instead of what it would clash with.
std::string with_line(std::vector<std::string> lines, const std::vector<KeyLine>& keys, const KeyLine& used)
{
  const Entry* entry = find_entry(used.full_key());
  for (const KeyLine& other : keys)
  {
    const bool drives = (used.section == "rolling" && other.key == "load" &&
                         (used.key == "hertz_pressure" || used.key == "approach")) ||
                        (used.section == "sliding" && other.key == "pressure" &&
                         (used.key == "load" || used.key == "mean_gap")); // one of them
    if (other.in_use && other.section == used.section &&
        (other.key == used.key || drives || (entry && entry->excludes == other.full_key())))
      lines[other.index] = "#";
  }
  lines[used.index].erase(0, 2);
  std::string text;
  for (const std::string& line : lines)
    text += line + "\n";
  return text;
}

class CaseTemplate : public testing::TestWithParam<std::string>
{
};

TEST_P(CaseTemplate, IsACaseWithoutWarningsThatCanBePlanned)
{
  const Case c = parse_case(case_template(GetParam()), "case.toml");
  EXPECT_EQ(c.values.get<std::string>("scenario"), GetParam());
  EXPECT_FALSE(c.title.empty());
  EXPECT_TRUE(c.warnings.empty()) << c.warnings.front().text;
  EXPECT_GT(std::visit([](const auto& plan) { return plan.steps; }, plan_case(c)), 5);
}

TEST_P(CaseTemplate, FitsAScreen)
{
  for (const std::string& line : lines_of(case_template(GetParam())))
    EXPECT_LE(line.size(), 120u) << line;
}

// Every default and every example may be taken as it stands.
TEST_P(CaseTemplate, EachCommentedKeyWorks)
{
  const sample::TemporaryFolder folder;
  std::ofstream(folder.path() / "heights.txt") << "0 1e-7 0\n0 2e-7 0\n";
  const auto lines = lines_of(case_template(GetParam()));
  const auto keys = key_lines(lines);
  // Where the template has friction, thermal constants of the lower body need those of the upper one, and a pace.
  const std::vector<std::string> with_heat{
      "fretting.frequency=10", "upper.material.thermal={conductivity=50,density=7850,specific_heat=460,expansion=0}"};
  // An inclusion of some micrometres is beneath smaller contacts, and smaller than a cell of larger ones.
  const std::map<std::string, std::vector<std::string>> fitting{
      {"tugging", {"lower.inclusion.depth=0.3 um", "lower.inclusion.size=0.3 um"}},
      {"indentation", {"lower.inclusion.depth=100 um", "lower.inclusion.size=100 um"}}};
  int tried = 0;
  for (const KeyLine& key : keys)
    if (!key.in_use)
    {
      ++tried;
      const bool heats = GetParam() == "fretting" && key.key == "thermal";
      std::vector<std::string> further = heats ? with_heat : std::vector<std::string>{};
      if (key.key == "inclusion" && fitting.contains(GetParam()))
        further = fitting.at(GetParam());
      EXPECT_NO_THROW(static_cast<void>(parse_case(with_line(lines, keys, key), folder.path() / "case.toml", further)))
          << lines[key.index];
    }
  EXPECT_GT(tried, 20);
}

TEST_P(CaseTemplate, KnowsEveryKeyOfTheScenario)
{
  const std::string text = case_template(GetParam());
  for (const Entry& entry : case_schema())
  {
    const bool is_not_for_spheres = GetParam() == "tugging" && entry.key.find(".shape.") != entry.key.npos &&
                                    !entry.key.ends_with("type") && !entry.key.ends_with(".shape.radius");
    if (!belongs_to(entry, GetParam()) || is_not_for_spheres || entry.key.starts_with("upper."))
      continue;
    const std::string key = entry.key.substr(entry.key.rfind('.') + 1);
    EXPECT_TRUE(std::regex_search(text, std::regex("(\\b" + key + " = |#   " + key + "\\b)"))) << entry.key;
  }
}

TEST_P(CaseTemplate, ShowsEveryChoiceAndTheDefaultsOfTheSchema)
{
  const std::string text = case_template(GetParam());
  const auto lines = lines_of(text);
  for (const KeyLine& key : key_lines(lines))
    if (const Entry* entry = find_entry(key.full_key()); entry && !key.in_use)
      if (const auto preset = fallback_of(*entry, GetParam()))
      {
        EXPECT_EQ(lines[key.index], "# " + key.key + " = " + toml_text(*preset));
      }
  for (const char* table : {"shape.type", "texture.type", "material.hardening.law"})
    for (const std::string& choice : find_entry(std::string("lower.") + table)->choices)
    {
      const bool is_not_for_tugging =
          GetParam() == "tugging" && table == std::string("shape.type") && choice != "sphere";
      const bool is_default = choice == "smooth" || choice == "none";
      EXPECT_TRUE(is_default || is_not_for_tugging || text.find(" = \"" + choice + "\"") != text.npos) << choice;
    }
}

INSTANTIATE_TEST_SUITE_P(Scenarios, CaseTemplate, testing::ValuesIn(scenario_names()));

TEST(CaseTemplateFile, UnknownScenarioNamesThoseThatAre)
{
  try
  {
    static_cast<void>(case_template("walking"));
    FAIL();
  }
  catch (const InputError& error)
  {
    for (const std::string& name : scenario_names())
      EXPECT_NE(std::string(error.what()).find(name), std::string::npos) << name;
    EXPECT_TRUE(std::string(error.what()).starts_with("unknown scenario walking; allowed: tugging, ")) << error.what();
  }
}

TEST(CaseTemplateFile, IsReplacedOnlyIfAsked)
{
  const sample::TemporaryFolder folder;
  const auto file = folder.path() / "case.toml";
  write_case_template("rolling", file, false);
  EXPECT_EQ(sample::file_text(file), case_template("rolling"));
  EXPECT_THROW(write_case_template("tugging", file, false), InputError);
  EXPECT_EQ(sample::file_text(file), case_template("rolling"));
  write_case_template("tugging", file, true);
  EXPECT_EQ(sample::file_text(file), case_template("tugging"));
  EXPECT_THROW(write_case_template("tugging", folder.path() / "nowhere" / "case.toml", false), IoError);
}

} // namespace

} // namespace brinell::io::case_template_test
