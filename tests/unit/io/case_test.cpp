// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/foundation/error.hpp"
#include "brinell/io/case_file.hpp"
#include "brinell/io/case_template.hpp"
#include "sample.hpp"

#include <gtest/gtest.h>

namespace brinell::io::case_test
{

namespace
{

using sample::parsed;

TEST(Case, IsTypedAndInSi)
{
  const Case c = parsed();
  const auto& t = sample::tugging(c);
  EXPECT_EQ(c.title, "sample");
  EXPECT_EQ(c.name, "sample");
  EXPECT_EQ(simulation::passing_radius(t.lower.shape), 1.0);
  EXPECT_EQ(t.upper.shape, simulation::Shape(simulation::Paraboloid{2.0, 2.0}));
  EXPECT_EQ(t.lower.material.elastic, (Elastic{200e9, 0.32}));
  EXPECT_EQ(std::get<constitutive::PerfectPlasticity>(t.lower.material.hardening.value()).yield_stress, 0.9115e9);
  EXPECT_FALSE(t.upper.material.is_plastic());
  EXPECT_EQ(t.spacing.value(), (std::array{0.00385, 0.0077, 0.001925}));
}

TEST(Case, FillsInTheDefaultsOfTheEngine)
{
  const Case c = parsed();
  const simulation::TuggingCase defaults;
  EXPECT_EQ(sample::tugging(c).passes, defaults.passes);
  EXPECT_EQ(sample::tugging(c).kinematics, defaults.kinematics);
  EXPECT_EQ(sample::tugging(c).solver.max_evaluations, defaults.solver.max_evaluations);
  EXPECT_EQ(sample::tugging(c).solver.yield_tolerance, defaults.solver.yield_tolerance);
  EXPECT_EQ(sample::tugging(c).solver.integration, defaults.solver.integration);
  EXPECT_FALSE(sample::tugging(c).shift.has_value());
  EXPECT_EQ(c.snapshots.kind, SnapshotRule::Kind::aligned);
}

// alpha_c = (pi C S_y / (2 E'))^2 R, Eq. 24 of the paper.
TEST(Case, NormalisedInterferenceIsInCriticalOnes)
{
  const Case c = parsed({"upper.shape.radius=1"});
  EXPECT_NEAR(c.first_yield.value().critical.interference, 2.214290e-4, 5e-10);
  EXPECT_EQ(sample::tugging(c).interference, 9.0 * c.first_yield->critical.interference);
  const Case length = parsed({"tugging.normalised=false", "tugging.interference=2 mm"});
  EXPECT_EQ(sample::tugging(length).interference, 0.002);
  EXPECT_EQ(sample::tugging(length).offset, 0.0);
  const Case beside = parsed({"tugging.offset=-1.5"});
  EXPECT_EQ(sample::tugging(beside).offset, -1.5 * beside.first_yield->critical.contact_radius);
  EXPECT_EQ(
      sample::tugging(parsed({"tugging.normalised=false", "tugging.interference=2 mm", "tugging.offset=3 mm"})).offset,
      0.003);
}

TEST(Case, TheWeakerBodyGivesTheCriticalValues)
{
  const auto hardening = [](const char* stress)
  { return std::string("upper.material.hardening={law=\"perfect\", yield_stress=\"") + stress + "\"}"; };
  EXPECT_EQ(parsed().first_yield->body, YieldsFirst::lower);
  EXPECT_EQ(parsed({hardening("2 GPa")}).first_yield->body, YieldsFirst::lower);
  EXPECT_EQ(parsed({hardening("0.5 GPa")}).first_yield->body, YieldsFirst::upper);
  EXPECT_EQ(parsed({hardening("0.9115 GPa")}).first_yield->body, YieldsFirst::both);
  // Not the smaller yield stress counts, but the smaller C(nu) S_y.
  EXPECT_EQ(parsed({hardening("0.92 GPa"), "upper.material.poisson_ratio=0.2"}).first_yield->body, YieldsFirst::upper);
}

TEST(Case, ResolvedTextReadsBackTheSame)
{
  for (const auto& overrides : std::vector<std::vector<std::string>>{{},
                                                                     {"grid.resolution=12.5", "tugging.passes=3"},
                                                                     {"output.snapshots=[5, 1, 5]"},
                                                                     {"output.snapshots=every 4"},
                                                                     {"title=a \"b\" \\ c"}})
  {
    const Case c = parsed(overrides);
    const std::string text = resolved_text(c.values);
    const Case again = parse_case(text, "again.toml");
    EXPECT_EQ(again.values.all(), c.values.all()) << text;
    EXPECT_EQ(sample::tugging(again).interference, sample::tugging(c).interference);
  }
}

TEST(Case, OverridesWin)
{
  const Case c =
      parsed({"tugging.interference=4", "tugging.interference=6", "tugging.kinematics=paper",
              "lower.shape.radius=30 mm", "grid.resolution=8", "output.snapshots=[5, 1, 5]", "tugging.shift='1 mm'"});
  EXPECT_EQ(c.values.get<double>("tugging.interference"), 6.0); // the last of several
  EXPECT_EQ(sample::tugging(c).kinematics, simulation::Kinematics::paper);
  EXPECT_EQ(simulation::passing_radius(sample::tugging(c).lower.shape), 0.03);
  EXPECT_EQ(c.snapshots.steps, (std::vector{1, 5}));
  EXPECT_EQ(sample::tugging(c).shift, 0.001);
}

TEST(Case, OverridesPushOutWhatTheyExclude)
{
  EXPECT_FALSE(sample::tugging(parsed({"grid.resolution=10"})).spacing.has_value());
  const std::vector<std::string> elastic{"tugging.normalised=false", "tugging.interference=1 mm"};
  for (const char* law : {"lower.material.hardening.law=none", "lower.material.hardening={law = \"none\"}",
                          "lower.material.hardening={}"})
    EXPECT_FALSE(parsed({law, elastic[0], elastic[1]}).first_yield.has_value()) << law;
}

TEST(Case, OneDriveOnTheCommandLineCountsAlone)
{
  const auto drive = [](const std::vector<std::string>& overrides)
  {
    return std::get<simulation::RollingCase>(parse_case(case_template("rolling"), "case.toml", overrides).scenario)
        .drive;
  };
  using Kind = contact::Drive::Kind;
  EXPECT_EQ(drive({}).kind, Kind::load);
  EXPECT_NEAR(drive({"rolling.hertz_pressure=2 GPa"}).value, 8.0 / 27.0 * drive({"rolling.hertz_pressure=3 GPa"}).value,
              1e-6 * drive({}).value);
  EXPECT_EQ(drive({"rolling.approach=1 um"}).kind, Kind::approach);
  EXPECT_EQ(drive({"rolling.approach=1 um"}).value, 1e-6);
  EXPECT_THROW(static_cast<void>(drive({"rolling.approach=1 um", "rolling.load=3"})), InputError);
  const Case sliding = parse_case(case_template("sliding"), "case.toml", {"sliding.load=2 N"});
  EXPECT_EQ(std::get<simulation::SlidingCase>(sliding.scenario).press.value, 2.0);
  const Case pressed = parse_case(
      case_template("indentation"), "case.toml",
      {"indentation.pressure=1 MPa", "grid.boundary=periodic", "grid.size=['1 mm', '1 mm']", "grid.cells=[32, 32]"});
  EXPECT_DOUBLE_EQ(std::get<simulation::IndentationCase>(pressed.scenario).sequence.front().value, 1.0);
}

TEST(Case, NameComesFromTheFolderOfCaseToml)
{
  EXPECT_EQ(parse_case(sample::case_text, "cases/here/case.toml").name, "here");
  EXPECT_EQ(parse_case(sample::case_text, "cases/here/there.toml").name, "there");
}

TEST(Case, WarnsOfAForgottenUnit)
{
  const Case c = parsed({"upper.material.young_modulus=200", "tugging.normalised=false", "tugging.interference=1 mm"});
  ASSERT_FALSE(c.warnings.empty());
  EXPECT_EQ(c.warnings[0].key, "soft_material");
  EXPECT_NE(c.warnings[0].text.find("\"200 GPa\""), std::string::npos) << c.warnings[0].text;
  const Case in_mpa =
      parsed({"upper.material.young_modulus=70000", "tugging.normalised=false", "tugging.interference=1 mm"});
  EXPECT_NE(in_mpa.warnings.at(0).text.find("\"7e+04 MPa\""), std::string::npos) << in_mpa.warnings[0].text;
  EXPECT_TRUE(parsed().warnings.empty());
  const auto rolled = [](const char* pressure)
  {
    try
    {
      return parse_case(case_template("rolling"), "case.toml", {std::string("rolling.hertz_pressure=") + pressure})
          .warnings.size();
    }
    catch (const InputError& error)
    {
      EXPECT_NE(std::string(error.what()).find("is a unit missing, as in \"3 GPa\"?"), std::string::npos)
          << error.what();
      return std::size_t(99);
    }
  };
  EXPECT_EQ(rolled("3"), 99u) << "a track of far too many steps, and the reason";
  EXPECT_EQ(rolled("3 GPa"), 0u);
}

struct Bad
{
  const char* override;
  std::vector<const char*> fragments; ///< of the message
};

class BadCase : public testing::TestWithParam<Bad>
{
};

TEST_P(BadCase, SaysWhatIsWrong)
{
  try
  {
    (void)parsed({GetParam().override});
    FAIL() << GetParam().override << " was accepted";
  }
  catch (const InputError& error)
  {
    const std::string text = error.what();
    EXPECT_EQ(text.rfind("--set " + std::string(GetParam().override), 0), 0u) << text;
    for (const char* fragment : GetParam().fragments)
      EXPECT_NE(text.find(fragment), text.npos) << "no \"" << fragment << "\" in: " << text;
  }
}

INSTANTIATE_TEST_SUITE_P(
    Values, BadCase,
    testing::Values(Bad{"lower.shape.radius=-1", {"lower.shape.radius = -1", "> 0"}},
                    Bad{"lower.shape.radius=0", {"> 0"}}, Bad{"lower.shape.radius=nan", {"nan", "finite"}},
                    Bad{"lower.shape.radius=inf", {"inf", "finite"}},
                    Bad{"lower.shape.radius=3 GPa", {"\"3 GPa\"", "is a pressure", "allowed: length"}},
                    Bad{"lower.shape.radius='3'", {"has no unit", "without quotes"}},
                    Bad{"lower.shape.radius=3 lightyears", {"unknown unit \"lightyears\""}},
                    Bad{"lower.shape.radius=true", {"is a boolean"}}, Bad{"lower.shape.radius=[1]", {"is a list"}},
                    Bad{"lower.shape.type=cube", {"\"cube\"", "allowed: \"sphere\""}},
                    Bad{"lower.shape=3", {"must be a table", "type, radius"}},
                    Bad{"lower.material.poisson_ratio=0.5", {"in (-1, 0.5)", "steel"}},
                    Bad{"lower.material.poisson_ratio=-1", {"in (-1, 0.5)"}},
                    Bad{"lower.material.poisson_ratio='0.3'", {"is a string"}},
                    Bad{"lower.material.hardening.yield_stress=0", {"> 0", "law = \"none\""}},
                    Bad{"upper.material.hardening.yield_stress=1 GPa",
                        {"applies only with", "\"perfect\" or \"linear\"", "by default"}},
                    Bad{"lower.material.hardening.modulus=1 GPa", {"applies only with", "\"linear\""}},
                    Bad{"tugging.passes=1.5", {"not an integer"}}, Bad{"tugging.passes=0", {"integer in [1"}},
                    Bad{"tugging.interference=0", {"> 0"}},
                    Bad{"tugging.interference=2 mm", {"normalised = true", "normalised = false"}},
                    Bad{"tugging.interference=1e6", {"more than the radius", "alpha_c"}},
                    Bad{"tugging.offset=1e4", {"without touching", "between -"}},
                    Bad{"tugging.offset=2 mm", {"normalised = true", "normalised = false"}},
                    Bad{"tugging.kinematics=other", {"\"exact\" or \"paper\""}},
                    Bad{"tugging.normalised=1", {"is an integer", "true or false"}},
                    Bad{"grid.spacing=[1, 2]", {"has 2 elements", "three lengths"}},
                    Bad{"grid.spacing=[1, 2, -3]", {"element -3", "> 0"}}, Bad{"grid.spacing=1", {"is an integer"}},
                    Bad{"grid.spacing=1 um", {"as in [\"3.85 mm\", \"3.85 mm\", \"3.85 mm\"]"}},
                    Bad{"grid.spacing=[1 um, 2 um, 1 um]", {"not a list", "between quotes"}},
                    Bad{"solver.anderson_depth=-1", {"in [0, 50]"}},
                    Bad{"output.snapshots=[1.5]", {"not a step number"}}, Bad{"output.snapshots=every 0", {"every N"}},
                    Bad{"output.snapshots=3", {"is an integer"}}, Bad{"title=1979-05-27", {"date"}},
                    Bad{"gird.spacing=1", {"unknown key", "did you mean grid?"}},
                    Bad{"grid.spacin=1", {"unknown key grid.spacin = 1", "did you mean grid.spacing?"}},
                    Bad{"nothing", {"section.key=value"}}, Bad{"=3", {"section.key=value"}}));

/// The message of a case that must not be accepted.
std::string message(const std::string& text)
{
  try
  {
    (void)parse_case(text, "cases/bad.toml");
  }
  catch (const InputError& error)
  {
    return error.what();
  }
  ADD_FAILURE() << "accepted: " << text;
  return "";
}

/// The sample with one line replaced.
std::string with(const std::string& old_line, const std::string& new_line)
{
  std::string text(sample::case_text);
  const auto at = text.find(old_line);
  EXPECT_NE(at, text.npos);
  return text.replace(at, old_line.size(), new_line);
}

TEST(CaseErrors, NameFileAndLine)
{
  EXPECT_EQ(
      message(with("interference = 9", "interference = -9")).rfind("cases/bad.toml:10: tugging.interference = -9 ", 0),
      0u);
  EXPECT_NE(message(with("interference = 9", "interferense = 9"))
                .find("cases/bad.toml:10: unknown key tugging.interferense = 9; did you mean tugging.interference?"),
            std::string::npos);
}

// Python makes its texts itself: nobody could look up a line there.
TEST(CaseErrors, OfATextThatNobodySeesNameKeysOnly)
{
  const auto message = [](const std::vector<std::string>& overrides, std::string_view text = sample::case_text)
  {
    try
    {
      (void)parse_case(text, "hidden.toml", overrides, Places::none);
    }
    catch (const InputError& error)
    {
      return std::string(error.what());
    }
    return std::string("no error");
  };
  EXPECT_EQ(message({}), "no error");
  std::string text(sample::case_text);
  text.replace(text.find("poisson_ratio = 0."), 18, "poisson_ratio = 7.");
  EXPECT_EQ(message({}, text).rfind("lower.material.poisson_ratio = 7.", 0), 0u) << message({}, text);
  EXPECT_EQ(message({"grid.spacing=[1e-15, 1e-15, 1e-15]"}).find("hidden.toml"), std::string::npos);
  EXPECT_EQ(message({}, text + "\n[grd]\na = 1\n").find("hidden.toml"), std::string::npos);
  EXPECT_EQ(parse_case(sample::case_text, "hidden.toml", {}, Places::none).grid_source.find("hidden"),
            std::string::npos);
}

TEST(CaseErrors, MissingKeysNameTheirTable)
{
  const std::string text = message(with("interference = 9", ""));
  EXPECT_EQ(text.rfind("cases/bad.toml:9: tugging.interference is missing; allowed: number > 0", 0), 0u) << text;
  EXPECT_NE(message("").find("cases/bad.toml: scenario is missing"), std::string::npos);
}

TEST(CaseErrors, SyntaxNamesLineAndColumn)
{
  const std::string text = message(with("interference = 9", "interference = = 9"));
  EXPECT_EQ(text.rfind("cases/bad.toml:10:16: not valid TOML", 0), 0u) << text;
  EXPECT_NE(message(with("interference = 9", "interference = 9\ninterference = 8")).find("not valid TOML"),
            std::string::npos);
  const std::string comma = message(with("interference = 9", "interference = 9,5"));
  EXPECT_NE(comma.find("is a decimal comma meant?"), std::string::npos) << comma;
  const std::string path = message(with("interference = 9", "interference = 9\ntitle = \"C:\\data\""));
  EXPECT_NE(path.find("a backslash is written twice"), std::string::npos) << path;
}

TEST(CaseErrors, AreAllReportedInTheOrderOfTheFile)
{
  std::string text = with("interference = 9", "interference = 'x'");
  text.replace(text.find("0.32"), 4, "0.62");
  const std::string found = message(text);
  const auto first = found.find("bad.toml:5: lower.material.poisson_ratio"),
             second = found.find("bad.toml:10: tugging.interference");
  EXPECT_NE(first, found.npos) << found;
  EXPECT_NE(second, found.npos) << found;
  EXPECT_LT(first, second);
}

TEST(CaseErrors, SpacingAndResolutionExclude)
{
  const std::string text = message(std::string(sample::case_text) + "resolution = 8\n");
  EXPECT_NE(text.find("cannot stand together with"), text.npos) << text;
  EXPECT_EQ(text.find('\n'), text.npos) << "said twice: " << text;
}

TEST(CaseErrors, ElasticBodiesHaveNoCriticalInterference)
{
  const std::string text = message(with(", hardening = {law = \"perfect\", yield_stress = \"0.9115 GPa\"}", ""));
  EXPECT_NE(text.find("neither body can yield"), text.npos) << text;
  EXPECT_NE(text.find("normalised = false"), text.npos) << text;
}

TEST(CaseErrors, MissingFileAndFolder)
{
  EXPECT_THROW((void)read_case("/nowhere/case.toml"), InputError);
  EXPECT_THROW((void)read_case("/"), InputError);
}

} // namespace

} // namespace brinell::io::case_test
