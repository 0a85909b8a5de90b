// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/foundation/processor.hpp"
#include "program.hpp"

#include <algorithm>
#include <cstdlib>

namespace brinell::cli::errors_test
{

namespace
{

class Errors : public Program
{
protected:
  /// Expects exit code 2, nothing on stdout, every fragment on stderr.
  void expect_refused(const std::vector<std::string>& arguments, const std::vector<std::string>& fragments) const
  {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.exit_code, 2) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    for (const auto& fragment : fragments)
      EXPECT_NE(outcome.err.find(fragment), std::string::npos) << "no \"" << fragment << "\" in:\n" << outcome.err;
  }
};

TEST_F(Errors, CommandLine)
{
  expect_refused({"run"}, {"brinell: error: case is required; brinell run --help"});
  expect_refused({"walk", "case.toml"}, {"unknown command walk", "run, check, "});
  write("case.toml", quick_case);
  expect_refused({"run", "case.toml", "--treads", "3"}, {"--treads"});
  expect_refused({"run", "case.toml", "--threads", "0"}, {"--threads"});
  expect_refused({"run", "case.toml", "--set"}, {"--set"});
}

TEST_F(Errors, KindOfProcessorThatWasNotCompiled)
{
  ASSERT_EQ(setenv("BRINELL_PROCESSOR", "z80", 1), 0);
  expect_refused({"schema"}, {"BRINELL_PROCESSOR = \"z80\"", chosen_processor()});
  ASSERT_EQ(setenv("BRINELL_PROCESSOR", chosen_processor().c_str(), 1), 0);
  EXPECT_EQ(run({"schema"}).exit_code, 0);
  ASSERT_EQ(unsetenv("BRINELL_PROCESSOR"), 0);
}

TEST_F(Errors, TheNameAloneShowsHowToBegin)
{
  expect_refused({}, {"brinell computes the elastic-plastic contact", "  brinell new ", "  brinell check ",
                      "  brinell run ", "  brinell plot ", "  brinell schema ", "brinell --help"});
}

// Half a tougher steel's yield stress in MPa makes the contact, and so the track, enormous.
TEST_F(Errors, AForgottenUnitComesBeforeWhatFollowsFromIt)
{
  ASSERT_EQ(run({"new", "tugging", "-o", "case.toml"}).exit_code, 0);
  const Outcome outcome = run({"check", "case.toml", "--set", "grid.spacing=[1e-8, 1e-8, 1e-8]", "--set",
                               "lower.material.hardening.yield_stress=900"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(
      outcome.err.rfind(
          "brinell: error: case.toml: the reason may be: lower.material.hardening: the yield stress is 900 Pa", 0),
      0u)
      << outcome.err;
  EXPECT_NE(outcome.err.find("\nbrinell: error: --set grid.spacing"), std::string::npos) << outcome.err;
}

TEST_F(Errors, AQuoteThatIsMissing)
{
  write("case.toml", "title = \"a \\\" b\"\nscenario = \"indentation\n[lower]\n");
  expect_refused({"check", "case.toml"}, {"case.toml:2:", "; is a quote missing at the end of the line?\n"});
  write("case.toml", "scenario = \"indentation\"\n[lower\n");
  EXPECT_EQ(run({"check", "case.toml"}).err.find("quote"), std::string::npos);
}

TEST_F(Errors, AnUnknownScenarioIsTheOnlyProblem)
{
  write("case.toml", "scenario = \"slide\"\n");
  const Outcome outcome = run({"check", "case.toml"});
  EXPECT_EQ(outcome.err.rfind("brinell: error: case.toml:1: scenario = \"slide\" is not known; allowed: ", 0), 0u);
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
}

TEST_F(Errors, APercentageWithoutItsSignIsAsked)
{
  write("case.toml", quick_case);
  expect_refused(
      {"run", "case.toml", "--accuracy", "3"},
      {"solver.accuracy = 3 is out of range; allowed: number in (0, 0.5], or as in \"1 %\"; did you mean \"3 %\"?"});
  EXPECT_EQ(run({"run", "case.toml", "--accuracy", "300"}).err.find("did you mean"), std::string::npos);
  const std::string no_guess = run({"run", "case.toml", "--accuracy", "200%"}).err;
  EXPECT_NE(no_guess.find("--accuracy 200%: "), std::string::npos) << no_guess;
  EXPECT_EQ(no_guess.find("did you mean"), std::string::npos) << no_guess;
}

TEST_F(Errors, AListForOneValueIsToldWhatToDo)
{
  write("case.toml", quick_case);
  expect_refused({"check", "case.toml", "--set", "grid.resolution=[4, 8]"},
                 {"is a list", "this key takes one value; brinell sweep runs the case for several values"});
}

TEST_F(Errors, AKeyWithoutItsTableIsFound)
{
  write("case.toml", quick_case);
  expect_refused({"check", "case.toml", "--set", "friction=0.2"}, {"did you mean interface.friction?"});
}

TEST_F(Errors, AWordInThePlaceOfATableNamesItsKey)
{
  write("case.toml", quick_case);
  expect_refused({"check", "case.toml", "--set", "lower.material.hardening=none"},
                 {"did you mean lower.material.hardening.law = \"none\"?"});
  expect_refused({"check", "case.toml", "--set", "upper.shape=cylinder"},
                 {"did you mean upper.shape.type = \"cylinder\"?"});
}

TEST_F(Errors, SchemaNamesTheKeysWithAWord)
{
  expect_refused(
      {"schema", "hardening"},
      {"there is no key hardening; with that word: lower.material.hardening, lower.material.layers.hardening\n"});
  expect_refused({"schema", "yield"}, {"lower.material.hardening.yield_stress, lower.material.hardening.yield_from, "
                                       "lower.material.hardening.yield_offset, "
                                       "lower.material.layers.hardening.yield_stress, lower.material.yield_profile, "
                                       "lower.inclusion.yield_factor, solver."});
}

TEST_F(Errors, MissingFile)
{
  expect_refused({"run", "nowhere.toml"}, {"brinell: error: nowhere.toml: cannot be opened"});
  expect_refused({"check", "."}, {"is a folder", "case.toml"});
}

TEST_F(Errors, CaseIsCheckedBeforeAnythingIsWritten)
{
  write("case.toml", std::string(quick_case) + "colour = 3\n");
  expect_refused({"run", "case.toml", "-o", "out"},
                 {"brinell: error: case.toml:13: unknown key grid.colour = 3; allowed in grid: boundary, size, cells, "
                  "layer, reference, spacing, resolution, extent"});
  EXPECT_FALSE(fs::exists(folder() / "out"));
}

TEST_F(Errors, EveryProblemHasItsLine)
{
  std::string text = quick_case;
  text.replace(text.find("0.3"), 3, "0.5");
  text.replace(text.find("resolution = 4"), 14, "resolution = \"many\"");
  write("case.toml", text);
  expect_refused({"check", "case.toml"}, {"brinell: error: case.toml:4: lower.material.poisson_ratio = 0.5 ",
                                          "brinell: error: case.toml:12: grid.resolution = \"many\" is a string"});
}

TEST_F(Errors, OverridesNameThemselves)
{
  write("case.toml", quick_case);
  expect_refused({"check", "case.toml", "--set", "tugging.interference=-1"},
                 {"--set tugging.interference=-1: ", "> 0"});
}

TEST_F(Errors, GridThatDoesNotFit)
{
  write("case.toml", quick_case);
  expect_refused({"check", "case.toml", "--set", "grid.spacing=[1e-4, 1e-4, 2e-5]", "--set", "output.fields=all"},
                 {"grid.spacing = [0.0001, 0.0001, 2e-05]", "memory"});
  expect_refused({"check", "case.toml", "--set", "grid.spacing=[1e-5, 1e-5, 1e-5]", "--set", "output.fields=all"},
                 {"grid.spacing = [1e-05, 1e-05, 1e-05]", "allowed: fewer than 2e+09, so larger cells"});
  expect_refused({"check", "case.toml", "--set", "grid.spacing=[1e-9, 1e-9, 1e-9]"}, {"are too small for a contact"});
}

TEST_F(Errors, FolderThatCannotBeMade)
{
  write("case.toml", quick_case);
  write("file", "");
  const Outcome outcome = run({"run", "case.toml", "-o", "file"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_NE(outcome.err.find("brinell: error: file: the folder for the results cannot be made"), std::string::npos)
      << outcome.err;
}

} // namespace

} // namespace brinell::cli::errors_test
