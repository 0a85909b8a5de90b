// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/foundation/error.hpp"
#include "brinell/reference/hertz.hpp"
#include "sample.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <fmt/format.h>
#include <fstream>

/// Case files of indentation and rolling.
namespace brinell::io::scenario_case_test
{

namespace
{

constexpr const char* bodies = R"(
[lower]
shape = {type = "flat"}
material = {young_modulus = "200 GPa", poisson_ratio = 0.3, hardening = {law = "perfect", yield_stress = "1 GPa"}}
[upper]
shape = {type = "sphere", radius = "2 mm"}
material = {rigid = true}
)";

std::string indentation(const std::string& keys)
{
  return "scenario = \"indentation\"\n[indentation]\n" + keys + bodies;
}

std::string rolling(const std::string& keys)
{
  return "scenario = \"rolling\"\n[rolling]\n" + keys + bodies;
}

template <typename ScenarioCase>
ScenarioCase read(const std::string& text, const std::vector<std::string>& overrides = {},
                  const std::filesystem::path& file = "sample.toml")
{
  return std::get<ScenarioCase>(parse_case(text, file, overrides).scenario);
}

std::string refusal(const std::string& text, const std::vector<std::string>& overrides = {})
{
  try
  {
    (void)parse_case(text, "sample.toml", overrides);
  }
  catch (const InputError& error)
  {
    return error.what();
  }
  return "";
}

using simulation::IndentationCase;
using simulation::RollingCase;

TEST(ScenarioCase, IndentationByLoadAndByApproach)
{
  const auto c = read<IndentationCase>(indentation("load = [\"3 N\", \"500 mN\", 0]\nplaces = [\"-1 mm\", 0.001]\n"));
  ASSERT_EQ(c.sequence.size(), 3u);
  EXPECT_EQ(c.sequence[1], (contact::Drive{contact::Drive::Kind::load, 0.5}));
  EXPECT_EQ(c.places, (std::vector{-0.001, 0.001}));
  EXPECT_TRUE(c.upper.material.elastic.is_rigid());
  EXPECT_EQ(c.lower.shape, simulation::Shape(simulation::Plane{}));
  EXPECT_EQ(c.upper.shape, simulation::Shape(simulation::Paraboloid{2e-3, 2e-3}));
  const auto d = read<IndentationCase>(indentation("approach = [\"3 um\"]\n"));
  EXPECT_EQ(d.sequence[0], (contact::Drive{contact::Drive::Kind::approach, 3e-6}));
}

TEST(ScenarioCase, OneValueIsAListOfOne)
{
  EXPECT_EQ(read<IndentationCase>(indentation("load = \"3 N\"\n")).sequence,
            (std::vector<contact::Drive>{{contact::Drive::Kind::load, 3.0}}));
  EXPECT_NE(refusal(indentation("load = \"3 mm\"\n")).find("is a length; allowed: force, or list of forces"),
            std::string::npos);
}

// The groove of a ball bearing: 52 % of the ball's diameter as radius, hollow.
TEST(ScenarioCase, ABallMayLieInAGroove)
{
  const std::string groove = "lower.shape={type=\"ellipsoid\", radius_x=\"20 mm\", radius_y=\"-2.08 mm\"}";
  const auto c = std::get<IndentationCase>(parse_case(indentation("load = 20\n"), "sample.toml", {groove}).scenario);
  const simulation::IndentationPlan p = simulation::plan(c);
  const auto hertz =
      reference::elliptical_contact_at_load(1.0 / (1.0 / 20e-3 + 1.0 / 2e-3), 1.0 / (1.0 / 2e-3 - 1.0 / 2.08e-3),
                                            contact_modulus(c.lower.material.elastic, c.upper.material.elastic), 20.0);
  EXPECT_NEAR(p.contact_radius_y / hertz.semi_axis_y, 1.0, 0.05);
  EXPECT_GT(p.contact_radius_y, 5.0 * p.contact_radius);
  EXPECT_NE(refusal(indentation("load = 20\n"), {"lower.shape={type=\"ellipsoid\", radius_x=1, radius_y=0}"})
                .find("is out of range; allowed: length other than 0"),
            std::string::npos);
  EXPECT_NE(refusal(indentation("load = 20\n"), {"lower.shape={type=\"ellipsoid\", radius_x=1, radius_y=\"-1 mm\"}"})
                .find("sum of curvatures > 0"),
            std::string::npos);
}

TEST(ScenarioCase, AContactWiderThanItsBallIsRefused)
{
  const std::string text = refusal(indentation("load = \"2 GN\"\n"));
  EXPECT_NE(text.find("more than the radius of curvature there, 0.002 m"), std::string::npos) << text;
}

TEST(ScenarioCase, InUnitsOfFirstYield)
{
  const Case c = parse_case(indentation("normalised = true\nload = [20, 0]\n"), "sample.toml");
  ASSERT_TRUE(c.first_yield);
  EXPECT_EQ(std::get<IndentationCase>(c.scenario).sequence[0].value, 20.0 * c.first_yield->critical.load);
  EXPECT_NE(
      refusal(indentation("normalised = true\nload = [20, 0]\n"), {"upper.shape={type=\"vickers\"}"})
          .find("sample.toml:4: indentation.load = [20, 0] is in units of first yield, but the bodies are neither "
                "round where they touch, nor cylinders in plane strain"),
      std::string::npos);
}

TEST(ScenarioCase, CylindersInPlaneStrainHaveUnitsOfFirstYield)
{
  const std::vector<std::string> plane{
      "lower.shape={type=\"cylinder\", radius=1}", "upper.shape={type=\"cylinder\", radius=1}",
      "grid.boundary=[\"open\", \"periodic\"]", "grid.spacing=[\"3.85 mm\", \"50 mm\", \"1.925 mm\"]"};
  const std::string text(sample::case_text);
  const auto with = [&](std::vector<std::string> keys)
  {
    keys.insert(keys.begin(), plane.begin(), plane.end());
    return keys;
  };
  const Case c = parse_case(text, "sample.toml", plane);
  ASSERT_TRUE(c.first_yield);
  ASSERT_TRUE(c.first_yield->line);
  EXPECT_EQ(c.equivalent_radius, 0.5);
  EXPECT_EQ(sample::tugging(c).interference, 9.0 * c.first_yield->critical.interference);
  // Green (2005), E' = 111.4082 GPa, C = 1.8174385: per metre.
  EXPECT_NEAR(c.first_yield->critical.interference, 9.732120e-4, 1e-9);
  EXPECT_NEAR(c.first_yield->critical.load, 3.8693279e7, 20.0);
  EXPECT_NEAR(c.first_yield->critical.energy, 1.7758973e4, 0.02);
  // The approach of the elastic cylinders under P_c is alpha_c.
  std::string by_load = text;
  by_load.replace(by_load.find("interference = 9"), 16, "load = 1");
  EXPECT_NEAR(sample::tugging(parse_case(by_load, "sample.toml", plane)).interference /
                  c.first_yield->critical.interference,
              1.0, 1e-12);
  // Of finite length they yield at their ends first.
  const std::vector<std::string> finite{"lower.shape={type=\"cylinder\", radius=1, length=0.5}",
                                        "upper.shape={type=\"cylinder\", radius=1, length=0.5}"};
  EXPECT_NE(refusal(text, finite)
                .find("sample.toml:10: tugging.interference = 9 is in units of the critical interference "
                      "alpha_c, but the bodies are neither round where they touch, nor cylinders"),
            std::string::npos)
      << refusal(text, finite);
  EXPECT_NE(refusal(text, with({"grid.reference=1e-3"})).find("grid.reference = 0.001 m is too short"),
            std::string::npos)
      << refusal(text, with({"grid.reference=1e-3"}));
}

TEST(ScenarioCase, TuggingUnderLoad)
{
  std::string text(sample::case_text);
  text.replace(text.find("interference = 9"), 16, "load = 27");
  const Case c = parse_case(text, "sample.toml");
  const simulation::TuggingCase& t = sample::tugging(c);
  EXPECT_EQ(t.load, 27.0 * c.first_yield->critical.load);
  EXPECT_NEAR(t.interference, 9.0 * c.first_yield->critical.interference, 1e-6 * t.interference); // 27^(2/3)
  EXPECT_NE(refusal(text, {"tugging.kinematics=paper"}).find("constant height only"), std::string::npos);
}

TEST(ScenarioCase, TuggingTakesWhatCanPassAndAnyTexture)
{
  const std::string text(sample::case_text);
  const auto tugging = [&](const std::vector<std::string>& overrides)
  { return read<simulation::TuggingCase>(text, overrides); };
  const std::vector<std::string> length{"tugging.normalised=false", "tugging.interference=2 mm"};
  const auto with = [&](std::vector<std::string> keys)
  {
    keys.insert(keys.end(), length.begin(), length.end());
    return keys;
  };
  const std::string ellipsoid = "lower.shape={type=\"ellipsoid\", radius_x=1, radius_y=\"3 m\"}";
  EXPECT_EQ(tugging(with({ellipsoid})).lower.shape, simulation::Shape(simulation::Paraboloid{1.0, 3.0}));
  const std::string roller = "shape={type=\"cylinder\", radius=1, length=\"0.15 m\"}";
  EXPECT_EQ(tugging(with({"lower." + roller, "upper." + roller, "grid.spacing=[5e-3, \"50 mm\", 2e-3]"})).upper.shape,
            simulation::Shape(simulation::Roller{1.0, 0.15}));
  EXPECT_EQ(tugging({"lower.texture={type=\"dent\", depth=\"1 mm\", edge_radius=\"10 mm\"}"}).lower.texture,
            simulation::Texture(simulation::Dent{0.0, 0.0, 1e-3, 10e-3}));
  // Without one radius for all directions there is no unit of first yield.
  EXPECT_NE(refusal(text, {ellipsoid})
                .find("tugging.interference = 9 is in units of the critical interference alpha_c, "
                      "but the bodies are neither round where they touch, nor cylinders in plane strain "
                      "(grid.boundary = [\"open\", \"periodic\"]), so there is none; allowed: "
                      "tugging.normalised = false with a length"),
            std::string::npos)
      << refusal(text, {ellipsoid});
  for (const char* shape : {"flat", "vickers", "berkovich"})
  {
    const std::string what = refusal(text, {std::string("upper.shape={type=\"") + shape + "\"}"});
    EXPECT_NE(what.find(std::string("upper.shape.type = \"") + shape +
                        "\" cannot pass another body; allowed with scenario "
                        "= \"tugging\": \"sphere\", \"ellipsoid\" or"),
              std::string::npos)
        << what;
  }
}

TEST(ScenarioCase, ShapesAndTextures)
{
  const auto shaped = [](const std::string& shape)
  { return read<IndentationCase>(indentation("load = [1]\n"), {"upper.shape=" + shape}).upper.shape; };
  EXPECT_EQ(shaped("{type=\"ellipsoid\", radius_x=1, radius_y=\"2 m\"}"),
            simulation::Shape(simulation::Paraboloid{1.0, 2.0}));
  EXPECT_EQ(shaped("{type=\"cylinder\", radius=1e-3, length=2e-3}"), simulation::Shape(simulation::Roller{1e-3, 2e-3}));
  EXPECT_NEAR(std::get<simulation::Cone>(shaped("{type=\"cone\", half_angle=60, tip_radius=1e-6}")).half_angle,
              std::acos(0.5), 1e-12);
  for (const char* angle : {"60 deg", "60°", "1.0471975511965976 rad"})
    EXPECT_NEAR(
        std::get<simulation::Cone>(shaped("{type=\"cone\", half_angle=\"" + std::string(angle) + "\"}")).half_angle,
        std::acos(0.5), 1e-12);
  EXPECT_THROW(static_cast<void>(shaped("{type=\"cone\", half_angle=\"60 m\"}")), InputError);
  EXPECT_THROW(static_cast<void>(shaped("{type=\"cone\", half_angle=\"2 rad\"}")), InputError); // above 90 degrees
  EXPECT_EQ(std::get<simulation::Pyramid>(shaped("{type=\"berkovich\"}")).faces, 3);
  const auto bump = read<RollingCase>(rolling("load = 5\ndistance = 1e-4\n"),
                                      {"lower.texture={type=\"bump\", height=\"1 um\", edge_radius=\"10 um\", x=2e-5}"})
                        .lower.texture;
  EXPECT_EQ(bump, simulation::Texture(simulation::Dent{2e-5, 0.0, -1e-6, 10e-6}));
}

TEST(ScenarioCase, HeightMapsComeFromAFile)
{
  const sample::TemporaryFolder folder;
  std::ofstream(folder.path() / "map.csv") << "# nm\n1e-9, 2e-9, 3e-9\r\n\n4e-9; 5e-9\t6e-9\n";
  const auto read_map = [&](const std::string& spacing)
  {
    return read<RollingCase>(rolling("load = 5\ndistance = 1e-4\n"),
                             {"lower.texture={type=\"height_map\", file=\"map.csv\", spacing=" + spacing + "}"},
                             folder.path() / "case.toml")
        .lower.texture;
  };
  const auto map = std::get<simulation::HeightMap>(read_map("[\"1 um\", \"2 um\"]").parts.at(0));
  EXPECT_EQ(map.nx, 3);
  EXPECT_EQ(map.ny, 2);
  EXPECT_EQ(map.dy, 2e-6);
  EXPECT_EQ(map.heights, (std::vector{1e-9, 2e-9, 3e-9, 4e-9, 5e-9, 6e-9}));
  EXPECT_THROW((void)read_map("[1e-6]"), InputError);
  std::ofstream(folder.path() / "map.csv") << "1 2\n3\n";
  EXPECT_THROW((void)read_map("[1e-6, 1e-6]"), InputError);
}

TEST(ScenarioCase, HeightMapsStandInTheCase)
{
  const sample::TemporaryFolder folder;
  std::ofstream(folder.path() / "map.csv") << "1e-9 2e-9 3e-9\n4e-9 5e-9 6e-9\n";
  const std::string text = rolling("load = 5\ndistance = 1e-4\n");
  const auto with = [&](const std::string& keys)
  {
    return parse_case(text, folder.path() / "case.toml",
                      {"lower.texture={type=\"height_map\", spacing=[1e-6, 2e-6], x=3e-6" + keys + "}"});
  };
  const Case by_file = with(", file=\"map.csv\"");
  const Case here = with(R"(, columns=3, heights=["1 nm", 2e-9, 3e-9, 4e-9, 5e-9, 6e-9])");
  EXPECT_EQ(std::get<RollingCase>(by_file.scenario).lower.texture, std::get<RollingCase>(here.scenario).lower.texture);
  // The resolved case is the same, so it needs no other file.
  EXPECT_EQ(resolved_text(by_file.values), resolved_text(here.values));
  const Case again = parse_case(resolved_text(by_file.values), "elsewhere/case.toml");
  EXPECT_EQ(std::get<RollingCase>(again.scenario).lower.texture, std::get<RollingCase>(here.scenario).lower.texture);
  // A file on the command line stands for all that the case has.
  const Case replaced = parse_case(resolved_text(by_file.values), folder.path() / "case.toml",
                                   {"lower.texture.file=map.csv", "lower.texture.x=0"});
  EXPECT_EQ(resolved_text(replaced.values),
            resolved_text(parse_case(resolved_text(by_file.values), "case.toml", {"lower.texture.x=0"}).values));

  const auto refused = [&](const std::string& keys)
  { return refusal(text, {"lower.texture={type=\"height_map\", spacing=[1e-6, 2e-6]" + keys + "}"}); };
  const std::pair<std::string, const char*> refusals[] = {
      {refused(""), "needs lower.texture.heights and lower.texture.columns, or lower.texture.file"},
      {refused(", heights=[1e-9, 2e-9]"), "needs lower.texture.heights and lower.texture.columns"},
      {refused(", columns=2"), "needs lower.texture.heights and lower.texture.columns"},
      {refused(", columns=2, heights=[1e-9, 2e-9, 3e-9]"), "columns = 2 does not divide the 3 numbers"},
      {refused(", columns=0, heights=[1e-9]"), "columns = 0 is out of range"},
      {refused(", columns=1, heights=[\"1 Pa\"]"), "is a pressure"},
      {refused(", file=\"map.csv\", columns=1, heights=[1e-9]"), "cannot stand together with lower.texture.heights"},
      {refused(", file=\"map.csv\", columns=1"), "cannot stand together with lower.texture.file"},
  };
  for (const auto& [message, expected] : refusals)
    EXPECT_NE(message.find(expected), std::string::npos) << expected << "\n  in: " << message;
}

TEST(ScenarioCase, FrettingHasItsDirectionInDegrees)
{
  const std::string ball = R"({young_modulus = "210 GPa", poisson_ratio = 0.3})";
  const std::string text = "scenario = \"fretting\"\nlower.material = " + ball + "\nupper.material = " + ball +
                           R"(
lower.shape.type = "flat"
upper.shape = {type = "sphere", radius = "10 mm"}
interface.friction = 0.5
[fretting]
load = 50
displacement = "0.5 um"
)";
  const auto direction = [&](const std::string& value)
  {
    const Case c = parse_case(text + "direction = " + value + "\n", "sample.toml");
    return std::get<simulation::FrettingCase>(c.scenario).direction;
  };
  EXPECT_DOUBLE_EQ(direction("90"), 0.5 * std::numbers::pi);
  EXPECT_DOUBLE_EQ(direction("\"0.5 rad\""), 0.5);
}

TEST(ScenarioCase, HertzPressureIsALoad)
{
  // p0 = (6 P E'^2 / (pi^3 R^2))^(1/3) for balls, (P E' / (pi R L))^(1/2) for rollers.
  const double modulus = 200e9 / 0.91;
  const auto ball = read<RollingCase>(rolling("hertz_pressure = \"3 GPa\"\ndistance = 1e-4\n"));
  EXPECT_NEAR(std::cbrt(6.0 * ball.drive.value * modulus * modulus / (std::pow(3.14159265358979, 3) * 4e-6)), 3e9, 1e3);
  const auto roller = read<RollingCase>(rolling("hertz_pressure = \"3 GPa\"\ndistance = 1e-4\n"),
                                        {"upper.shape={type=\"cylinder\", radius=2e-3, length=1e-3}"});
  EXPECT_NEAR(std::sqrt(roller.drive.value * modulus / (3.14159265358979 * 2e-6)), 3e9, 1e3);
}

TEST(ScenarioCase, SaysWhatIsMissingOrTooMuch)
{
  const std::pair<std::string, const char*> refusals[] = {
      {refusal(indentation("")),
       "none of indentation.load, indentation.approach, indentation.pressure and indentation.mean_gap is given; one is "
       "needed, as a list"},
      {refusal(indentation("load = [1, 0]\napproach = [1, 0]\n")), "cannot stand together"},
      {refusal(indentation("load = [0, 0]\n")), "never presses the bodies together"},
      {refusal(indentation("load = [-1]\n")), "out of range"},
      {refusal(indentation("load = [\"1 um\"]\n")), "is a length"},
      {refusal(indentation("load = [1]\ncycles = 2\n")), "must end with 0"},
      {refusal(indentation("load = [1]\n"), {"lower.material={rigid=true}"}), "no body that deforms"},
      {refusal(indentation("load = [1]\n"), {"upper.material={rigid=true, young_modulus=2e11}"}),
       "applies only with upper.material.rigid = false"},
      {refusal(indentation("load = [1]\n"), {"upper.shape={type=\"flat\"}"}),
       "upper.shape.type = \"flat\" and the lower body touch neither"},
      {refusal(indentation("load = [1]\n"), {"tugging.passes=2"}), "applies only with scenario"},
      {refusal(rolling("distance = 1e-4\n")), "none of rolling.load"},
      {refusal(rolling("distance = 1e-4\nload = 1\napproach = 1e-6\n")), "cannot stand together with rolling.load"},
      {refusal(rolling("load = 1\n")), "rolling.distance is missing"},
      {refusal(rolling("distance = 1e3\nload = 1\n")), "cells"},
      {refusal(rolling("distance = 1e-4\nload = 1\nslide_to_roll = -2\n")), "out of range"},
      {refusal(rolling("distance = 1e-4\nhertz_pressure = 1e9\n"), {"upper.shape={type=\"cone\", half_angle=70}"}),
       "has no meaning for these shapes"},
  };
  for (const auto& [text, expected] : refusals)
    EXPECT_NE(text.find(expected), std::string::npos) << expected << "\n  in: " << text;
}

/// A rough flat under a rigid one, over a period.
std::string rough(const std::string& keys, const std::string& texture_keys = "")
{
  return "scenario = \"indentation\"\n[indentation]\n" + keys + R"(
[lower]
shape = {type = "flat"}
material = {young_modulus = "200 GPa", poisson_ratio = 0.3}
texture = {type = "random", rms_slope = 0.01, cutoff = "25 um")" +
         texture_keys + R"(}
[upper]
shape = {type = "flat"}
material = {rigid = true}
[grid]
boundary = "periodic"
size = ["200 um", "100 um"]
cells = [32, 16]
)";
}

TEST(ScenarioCase, MeanGapsOverAPeriod)
{
  const Case c = parse_case(rough("mean_gap = [\"50 nm\", \"1 mm\"]\n"), "sample.toml");
  const auto& i = std::get<IndentationCase>(c.scenario);
  EXPECT_EQ(i.sequence, (std::vector<contact::Drive>{{contact::Drive::Kind::mean_gap, 5e-8},
                                                     {contact::Drive::Kind::mean_gap, 1e-3}}));
  const double touch = simulation::plan(i).touching_gap;
  const auto with_touch = [&](const char* format) { return fmt::format(fmt::runtime(format), touch); };
  const std::pair<std::string, std::string> refusals[] = {
      {refusal(indentation("mean_gap = [1e-6]\n")),
       "indentation.mean_gap = [1e-06] is the mean over a period; allowed "
       "with grid.boundary = \"periodic\"; otherwise indentation.approach"},
      {refusal(rough("mean_gap = [-1e-6]\n")), "out of range; allowed: length, or list of lengths > 0"},
      {refusal(rough("mean_gap = [0]\n")), "out of range; allowed: length, or list of lengths > 0"},
      {refusal(rough("mean_gap = [\"1 MPa\"]\n")), "is a pressure"},
      {refusal(rough("mean_gap = [1e-7]\npressure = [1e6]\n")), "cannot stand together with indentation.pressure"},
      {refusal(rough("mean_gap = [\"1 mm\"]\n")),
       with_touch(
           "indentation.mean_gap = [\"1 mm\"] does not fit: the mean gap is never below {:g} m, where the surfaces "
           "first touch")},
      {refusal(rough("mean_gap = [1e-7]\ncycles = 2\n")),
       with_touch("the last mean gap must not be below {:g} m, where the surfaces first touch")},
  };
  for (const auto& [text, expected] : refusals)
    EXPECT_NE(text.find(expected), std::string::npos) << expected << "\n  in: " << text;
}

TEST(ScenarioCase, ARandomSurfaceHasThePeriodOfTheGrid)
{
  const auto size = [](const std::string& keys, const std::vector<std::string>& overrides = {})
  {
    const auto c = read<IndentationCase>(rough("pressure = [1e6]\n", keys), overrides);
    const auto& p = std::get<simulation::RandomSurface>(c.lower.texture.parts.front()).parameters();
    return std::array{p.size_x, p.size_y};
  };
  EXPECT_EQ(size(""), (std::array{200e-6, 100e-6}));
  EXPECT_EQ(size(", rolloff = \"50 um\""), (std::array{200e-6, 100e-6}));
  EXPECT_EQ(size(", size = [\"100 um\", \"50 um\"]"), (std::array{100e-6, 50e-6})); // twice along each axis
}

TEST(ScenarioCase, ResolvedTextReadsBackTheSame)
{
  for (const std::string& text :
       {indentation("load = [\"3 N\", 0]\n"), indentation("normalised = true\napproach = [4, 0]\n"),
        rolling("hertz_pressure = \"2 GPa\"\ndistance = \"1 mm\"\nslide_to_roll = 0.1\n")})
  {
    const Case c = parse_case(text, "sample.toml");
    const Case again = parse_case(resolved_text(c.values), "again.toml");
    EXPECT_EQ(again.values.all(), c.values.all());
  }
}

} // namespace

} // namespace brinell::io::scenario_case_test
