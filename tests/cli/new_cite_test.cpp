// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/io/case_template.hpp"
#include "program.hpp"

#include <algorithm>

/// `brinell new`, `brinell cite`, and what the program says of commands that it does not have.
namespace brinell::cli::new_cite_test
{

namespace
{

class New : public Program, public testing::WithParamInterface<std::string>
{
};

TEST_P(New, CaseIsAcceptedAndRuns)
{
  const Outcome written = run({"new", GetParam(), "-o", "first.toml"});
  ASSERT_EQ(written.exit_code, 0) << written.err;
  EXPECT_EQ(written.out, "first.toml is written; `brinell check first.toml` shows its grid, memory and time\n");
  const Outcome check = run({"check", "first.toml"});
  EXPECT_EQ(check.exit_code, 0);
  EXPECT_EQ(check.err, "");
  std::vector<std::string> coarse{"run", "first.toml", "-q", "-o", "out", "--set"};
  coarse.emplace_back(GetParam() == "sliding" ? "grid.spacing=[\"10 um\", \"10 um\", \"5 um\"]" : "grid.resolution=3");
  if (GetParam() == "rolling")
    coarse.insert(coarse.end(), {"--set", "rolling.distance=0.2 mm"});
  const Outcome outcome = run(coarse);
  EXPECT_EQ(outcome.exit_code, 0);
  for (std::size_t line = 0; line < outcome.err.size(); line = outcome.err.find('\n', line) + 1) // of the few cells
    EXPECT_EQ(outcome.err.compare(line, 18, "brinell: warning: "), 0) << outcome.err;
  EXPECT_TRUE(fs::exists(folder() / "out" / "summary.json"));
}

TEST_P(New, TheFirstRunHasNoWarnings)
{
  ASSERT_EQ(run({"new", GetParam(), "-o", "first.toml"}).exit_code, 0);
  const Outcome outcome = run({"run", "first.toml", "-q", "-o", "out"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.err, "");
}

TEST_P(New, PrintsWhatItWouldWrite)
{
  ASSERT_EQ(run({"new", GetParam(), "-o", "first.toml"}).exit_code, 0);
  EXPECT_EQ(run({"new", GetParam()}).out, file_text(folder() / "first.toml"));
}

INSTANTIATE_TEST_SUITE_P(Scenarios, New, testing::ValuesIn(io::scenario_names()),
                         [](const auto& parameter) { return parameter.param; });

class Cite : public Program
{
};

TEST_F(Cite, ListsPapersAndTheirUse)
{
  write("case.toml", quick_case);
  const Outcome cite = run({"cite", "case.toml"});
  EXPECT_EQ(cite.exit_code, 0) << cite.err;
  EXPECT_NE(cite.out.find("The brinell authors (2026). brinell: "), std::string::npos);
  EXPECT_NE(cite.out.find("https://doi.org/10.1098/rsta.1929.0009\n    for: surface displacement"), std::string::npos)
      << cite.out;
  EXPECT_EQ(cite.out.find("Chaboche"), std::string::npos);
  const std::string harder = R"(lower.material.hardening={law = "perfect", yield_stress = "1 GPa", )"
                             R"(back_stresses = [{modulus = "1 GPa", recall = 10}, {modulus = "2 GPa", recall = 20}]})";
  EXPECT_NE(run({"cite", "case.toml", "--set", harder}).out.find("Chaboche, J. L. (1986)"), std::string::npos);
}

TEST_F(Cite, BibtexHasAnEntryPerPaper)
{
  write("case.toml", quick_case);
  const Outcome cite = run({"cite", "--bibtex", "case.toml"});
  EXPECT_EQ(cite.exit_code, 0) << cite.err;
  EXPECT_EQ(cite.out.rfind("@misc{brinell,\n", 0), 0u) << cite.out;
  EXPECT_NE(cite.out.find("  year = {2026},\n"), std::string::npos);
  EXPECT_NE(cite.out.find("\n@inproceedings{boucly2006,\n"), std::string::npos);
  EXPECT_EQ(std::count(cite.out.begin(), cite.out.end(), '{'), std::count(cite.out.begin(), cite.out.end(), '}'));
}

class Refusals : public Program
{
protected:
  void expect_refused(const std::vector<std::string>& arguments, const std::string& message) const
  {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(outcome.err, message);
  }
};

TEST_F(Refusals, NewNeverOverwrites)
{
  write("case.toml", "mine");
  expect_refused({"new", "tugging", "-o", "case.toml"},
                 "brinell: error: case.toml: exists already; --force replaces it\n");
  EXPECT_EQ(file_text(folder() / "case.toml"), "mine");
  EXPECT_EQ(run({"new", "tugging", "-o", "case.toml", "--force"}).exit_code, 0);
  EXPECT_NE(file_text(folder() / "case.toml"), "mine");
}

TEST_F(Refusals, UnknownScenarioAndCommand)
{
  std::string names;
  for (const std::string& name : io::scenario_names())
    names += (names.empty() ? "" : ", ") + name;
  expect_refused({"new", "walking"}, "brinell: error: unknown scenario walking; allowed: " + names + "\n");
  expect_refused({"walk", "case.toml"}, "brinell: error: unknown command walk; allowed: run, check, schema, new, cite, "
                                        "plot, report, sweep, fit, app, surface, material, export, completion\n");
}

TEST_F(Refusals, CommandsOfThePythonPackage)
{
  for (const char* command : {"plot", "report", "sweep", "fit", "app", "surface", "export", "completion"})
    expect_refused({command, "--help", "x", "--out=y"},
                   "brinell: error: " + std::string(command) +
                       " is a command of brinell's Python package, which is not this program; `pip install .` in "
                       "brinell's source folder installs a brinell that has it\n");
}

} // namespace

} // namespace brinell::cli::new_cite_test
