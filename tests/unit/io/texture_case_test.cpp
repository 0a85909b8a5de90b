// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/foundation/error.hpp"
#include "brinell/io/case_file.hpp"
#include "io/npy.hpp"
#include "sample.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <fstream>
#include <limits>
#include <string>
#include <vector>

/// Waves and roughness in a case file, and lists of textures.
namespace brinell::io::texture_case_test
{

namespace
{

using simulation::Dent;
using simulation::RandomSurface;
using simulation::SelfAffine;
using simulation::Sinusoid;
using simulation::Texture;

constexpr const char* head = R"(scenario = "rolling"
[rolling]
load = 5
distance = 1e-4
[upper]
shape = {type = "sphere", radius = "2 mm"}
material = {rigid = true}
[lower]
shape = {type = "flat"}
material = {young_modulus = "200 GPa", poisson_ratio = 0.3}
)"; // ten lines

Texture texture(const std::string& lower, const std::vector<std::string>& overrides = {})
{
  const Case c = parse_case(head + lower, "sample.toml", overrides);
  return std::get<simulation::RollingCase>(c.scenario).lower.texture;
}

std::string refusal(const std::string& lower, const std::vector<std::string>& overrides = {})
{
  try
  {
    static_cast<void>(texture(lower, overrides));
  }
  catch (const InputError& error)
  {
    return error.what();
  }
  return "";
}

void expect_refused(const std::string& message, const std::string& part)
{
  EXPECT_NE(message.find(part), std::string::npos) << part << "\n  in: " << message;
}

constexpr const char* random_keys = R"(type = "random", hurst = 0.7, rolloff = "100 um", cutoff = "30 um")";

TEST(TextureCase, WavesAndRoughness)
{
  EXPECT_EQ(texture(R"(texture = {type = "sinusoid", amplitude = "1 um", wavelength_y = "50 um", x = "3 um"})"),
            Texture(Sinusoid{.amplitude = 1e-6, .wavelength_y = 50e-6, .x = 3e-6}));
  const std::string keys = random_keys;
  SelfAffine p{.hurst = 0.7,
               .rms_height = 1e-7,
               .rms_slope = {},
               .rolloff = 100e-6,
               .cutoff = 30e-6,
               .size_x = 800e-6,
               .size_y = 800e-6,
               .seed = 0};
  EXPECT_EQ(texture("texture = {" + keys + ", rms_height = \"0.1 um\"}"), Texture(RandomSurface(p)));
  p.rms_height.reset();
  p.rms_slope = 0.01;
  p.seed = 12;
  p.size_x = 1e-3;
  p.size_y = 5e-4;
  EXPECT_EQ(texture("texture = {" + keys + ", rms_slope = 0.01, size = [\"1 mm\", \"0.5 mm\"], seed = 12}"),
            Texture(RandomSurface(p)));
}

TEST(TextureCase, SeveralAddUp)
{
  const Texture both(std::vector<simulation::TexturePart>{Dent{0.0, 0.0, 1e-6, 10e-6},
                                                          Sinusoid{.amplitude = 1e-7, .wavelength_x = 5e-5}});
  const std::string tables = R"([[lower.texture]]
type = "dent"
depth = "1 um"
edge_radius = "10 um"
[[lower.texture]]
type = "sinusoid"
amplitude = "0.1 um"
wavelength_x = "50 um"
)";
  const std::string list = R"(texture = [{type = "dent", depth = 1e-6, edge_radius = 1e-5}, )"
                           R"({type = "sinusoid", amplitude = 1e-7, wavelength_x = 5e-5}])";
  EXPECT_EQ(texture(tables), both);
  EXPECT_EQ(texture(list), both);
  EXPECT_EQ(texture("", {"lower." + list}), both) << "by --set";
  EXPECT_EQ(texture(R"(texture = {type = "bump", height = 1, edge_radius = 0.25})", {"lower." + list}), both)
      << "in its place";
  EXPECT_EQ(texture(list, {R"(lower.texture={type = "dent", depth = 1e-6, edge_radius = 1e-5})"}),
            Texture(Dent{0.0, 0.0, 1e-6, 10e-6}));
  EXPECT_EQ(texture("texture = []"), Texture());
  EXPECT_EQ(texture(R"(texture = [{type = "smooth"}])"), Texture());
  // One of them.
  EXPECT_EQ(std::get<Dent>(texture(list, {"lower.texture[0].depth=2e-6"}).parts.at(0)).depth, 2e-6);
  EXPECT_EQ(
      std::get<Dent>(texture(list, {R"(lower.texture[1]={type="bump", height=3e-6, edge_radius=2.5e-6})"}).parts.at(1))
          .depth,
      -3e-6);
  // The resolved case stands for itself.
  const Case c = parse_case(head + tables, "sample.toml");
  const Case again = parse_case(resolved_text(c.values), "sample.toml");
  EXPECT_EQ(std::get<simulation::RollingCase>(again.scenario).lower.texture, both);
  EXPECT_EQ(resolved_text(again.values), resolved_text(c.values));
}

TEST(TextureCase, ErrorsNameLineAndKey)
{
  const std::string tables = "[[lower.texture]]\ntype = \"dent\"\ndepth = \"1 um\"\nedge_radius = \"10 um\"\n"
                             "[[lower.texture]]\ntype = \"sinusoid\"\namplitude = \"0.1 um\"\n";
  expect_refused(refusal(tables), "sample.toml:16: lower.texture[1].type = \"sinusoid\" needs "
                                  "lower.texture[1].wavelength_x or lower.texture[1].wavelength_y");
  expect_refused(refusal(tables + "wavelength_x = -1\n"),
                 "sample.toml:18: lower.texture[1].wavelength_x = -1 is out of range; allowed: length > 0");
  expect_refused(refusal(tables + "wavelength_x = 1e-5\nwavelenth_y = 1\n"), "sample.toml:19: unknown key "
                                                                             "lower.texture[1].wavelenth_y = 1");
  expect_refused(refusal(tables + "wavelength_x = 1e-5\ndepth = 1\n"),
                 "sample.toml:19: lower.texture[1].depth = 1 applies only with lower.texture[1].type = \"dent\"");
  expect_refused(refusal("[[lower.texture]]\ntype = \"dent\"\ndepth = 1e-6\n"),
                 "sample.toml:11: lower.texture[0].edge_radius is missing");
  expect_refused(refusal("texture = [{type = \"smooth\"}, 3]"),
                 "sample.toml:11: lower.texture[1] = 3 is an integer, but must be a table with the keys type, ");
  expect_refused(refusal("[[lower.shape]]\ntype = \"flat\"\n").substr(0, 400), "lower.shape");
  expect_refused(refusal("\"texture[0]\".type = \"dent\"\n"), "unknown key lower.texture[0]");
}

TEST(TextureCase, HeightsInAnotherUnitAreWarnedOf)
{
  const auto warnings = [](const std::string& heights)
  {
    return parse_case(
               head + (R"(texture = {type = "height_map", columns = 2, spacing = ["5 um", "5 um"], heights = )" +
                       heights + "}"),
               "sample.toml",
               {"upper.material.rigid=false", "upper.material.young_modulus=2e11", "upper.material.poisson_ratio=0.3"})
        .warnings;
  };
  EXPECT_TRUE(warnings("[0.3e-6, -0.2e-6, 0.1e-6, 0]").empty());
  const auto steep = warnings("[0.3, -0.2, 0.1, 0]"); // in um
  ASSERT_EQ(steep.size(), 1u);
  EXPECT_EQ(steep.front().key, "steep_texture");
  // Slopes 0.5, 0.2, 0.1, 0.2 over 5 um.
  EXPECT_NE(steep.front().text.find("slope of 5.83e+04"), std::string::npos) << steep.front().text;
}

TEST(TextureCase, SlopesOfAMissingUnitAreWarnedOf)
{
  const auto warnings = [](const std::string& texture)
  {
    const std::vector<Warning> all = parse_case(head + texture, "sample.toml",
                                                {"upper.material.rigid=false", "upper.material.young_modulus=2e11",
                                                 "upper.material.poisson_ratio=0.3"})
                                         .warnings;
    return std::count_if(all.begin(), all.end(), [](const Warning& w) { return w.key == "steep_texture"; });
  };
  EXPECT_EQ(warnings(R"(texture = {type = "dent", depth = 1e-6, edge_radius = 1e-5})"), 0);
  EXPECT_EQ(warnings(R"(texture = {type = "dent", depth = "1 mm", edge_radius = "150 um"})"), 1);
  EXPECT_EQ(warnings(R"(texture = {type = "sinusoid", amplitude = "0.2 um", wavelength_x = "20 um"})"), 0);
  EXPECT_EQ(warnings(R"(texture = {type = "sinusoid", amplitude = 0.2, wavelength_x = "20 um"})"), 1);
  const std::string rough = R"(texture = {type = "random", hurst = 0.8, rolloff = "20 um", cutoff = "5 um", )"
                            R"(size = ["40 um", "40 um"], seed = 1, rms_)";
  EXPECT_EQ(warnings(rough + R"(height = "0.1 um"})"), 0);
  EXPECT_EQ(warnings(rough + "height = 0.1}"), 1);
  EXPECT_EQ(warnings(rough + "slope = 5}"), 1);
}

TEST(TextureCase, TheEarlierRadiusOfADentIsConverted)
{
  for (const char* kind : {R"(type = "dent", depth)", R"(type = "bump", height)"})
    expect_refused(
        refusal(fmt::format(R"(texture = {{{} = 1e-6, radius = "200 um"}})", kind)),
        "lower.texture.radius = \"200 um\"; a dent or bump has lower.texture.edge_radius, at which it crosses "
        "the undisturbed surface; the earlier radius was the wavelength of its profile: edge_radius = 0.25 x "
        "radius. Half of the depth is at 0.124 x radius, the crest of the shoulder at 0.315 x radius");
  const std::string list = R"(texture = [{type = "smooth"}, {type = "dent", depth = 1e-6, edge_radius = 1e-5}])";
  expect_refused(refusal(list, {"lower.texture[1].radius=1e-4"}), "lower.texture[1].edge_radius");
}

TEST(TextureCase, OverridesThatMissTheList)
{
  const std::string list = R"(texture = [{type = "smooth"}, {type = "dent", depth = 1e-6, edge_radius = 1e-5}])";
  expect_refused(refusal(list, {"lower.texture[2].type=smooth"}),
                 "--set lower.texture[2].type=smooth: lower.texture[2] does not exist: the list has 2, counted from 0");
  expect_refused(refusal(list, {"lower.texture.depth=1"}),
                 "lower.texture is a list of 2: name one of them, as lower.texture[0].depth");
  expect_refused(refusal("", {"lower.texture[0].type=smooth"}), "lower.texture is one table, not a list");
  expect_refused(refusal("", {"lower[0].shape.type=flat"}), "unknown key lower[0].shape.type");
}

TEST(TextureCase, RoughnessThatCannotBe)
{
  const std::string keys = random_keys;
  const auto refused = [&](const std::string& more) { return refusal("texture = {" + keys + more + "}"); };
  expect_refused(refused(""), "sample.toml:11: lower.texture.type = \"random\" needs lower.texture.rms_height or "
                              "lower.texture.rms_slope");
  expect_refused(refused(", rms_height = 1e-7, rms_slope = 0.1"), "cannot stand together with lower.texture.rms");
  expect_refused(refused(", rms_height = 1e-7, size = [1e-3]"), "lower.texture.size = [0.001] needs two lengths");
  expect_refused(refused(", rms_height = 1e-7, size = [1e-3, 1e-5]"), "lower.texture.cutoff: cutoff = 3e-05");
  expect_refused(refused(", rms_height = 1e-7, seed = -1"), "lower.texture.seed = -1 is out of range");
  expect_refused(refusal(R"(texture = {type = "random", rms_height = 1e-7, cutoff = 1e-5})"),
                 "needs lower.texture.size or lower.texture.rolloff");
  expect_refused(refusal(R"(texture = {type = "random", rms_height = 1e-7, cutoff = 1e-5, rolloff = 5e-6})"),
                 "lower.texture.rolloff = 5e-06 is shorter than lower.texture.cutoff = 1e-05 m");
  EXPECT_EQ(refusal(R"(texture = {type = "random", rms_height = 1e-7, cutoff = 1e-5, size = [1e-4, 1e-4]})"), "");
  // On the command line the other rms wins.
  EXPECT_EQ(refusal("texture = {" + keys + ", rms_height = 1e-7}", {"lower.texture.rms_slope=0.1"}), "");
}

/// Heights in a file, read with more keys.
class HeightFile : public testing::Test
{
protected:
  simulation::HeightMap read(const std::string& name, const std::string& content, const std::string& keys = "")
  {
    std::ofstream(folder_.path() / name) << content;
    const std::string text = std::string(head) + "texture = {type = \"height_map\", file = \"" + name +
                             "\", spacing = [1e-6, 1e-6]" + keys + "}";
    const Case c = parse_case(text, folder_.path() / "sample.toml");
    resolved_ = resolved_text(c.values);
    warned_ = c.warnings.empty() ? "" : c.warnings.back().text;
    return std::get<simulation::HeightMap>(std::get<simulation::RollingCase>(c.scenario).lower.texture.parts.at(0));
  }
  std::string refused(const std::string& name, const std::string& content, const std::string& keys = "")
  {
    try
    {
      (void)read(name, content, keys);
    }
    catch (const InputError& error)
    {
      return error.what();
    }
    return "";
  }

  sample::TemporaryFolder folder_;
  std::string resolved_, warned_;
};

TEST_F(HeightFile, HasAUnit)
{
  const auto map = read("map.csv", "0, 1\n2, 30\n", ", unit = \"nm\"");
  for (const auto& [found, expected] :
       {std::pair{map.heights[1], 1e-9}, {map.heights[2], 2e-9}, {map.heights[3], 30e-9}})
    EXPECT_DOUBLE_EQ(found, expected);
  EXPECT_EQ(resolved_.find("unit"), std::string::npos) << "what is resolved is in m";
  const std::vector<double> heights{0.0, 1.5, -2.0, 0.25};
  EXPECT_DOUBLE_EQ(read("map.npy", npy_content(heights, 2), ", unit = \"um\"").heights[2], -2e-6);
  EXPECT_EQ(read("map.npy", npy_content(heights, 2)).heights, heights);
  expect_refused(refused("map.csv", "0 1\n", ", unit = \"GPa\""),
                 "unit = \"GPa\" is a unit of pressure; allowed: a unit of length");
  expect_refused(refused("map.csv", "0 1\n", ", unit = \"furlong\""), "has the unknown unit");
  expect_refused(
      refusal(R"(texture = {type = "height_map", heights = [0, 1], columns = 2, spacing = [1, 1], unit = "um"})"),
      "it goes with lower.texture.file only");
}

TEST_F(HeightFile, OfAnotherUnitIsTold)
{
  static_cast<void>(read("map.csv", "0 1e-3\n"));
  EXPECT_NE(warned_.find("are in m unless lower.texture.unit names another unit, such as \"um\""), std::string::npos)
      << warned_;
  static_cast<void>(read("map.csv", "0 1\n", ", unit = \"mm\""));
  EXPECT_NE(warned_.find("is lower.texture.unit = \"mm\" the unit of the file?"), std::string::npos) << warned_;
  static_cast<void>(read("map.csv", "0 1\n", ", unit = \"nm\""));
  EXPECT_EQ(warned_, "");
}

// As spreadsheets of many countries write them: two numbers for each would be another surface, without a word.
TEST_F(HeightFile, MayHaveDecimalCommas)
{
  const std::vector<double> heights{0.0, 1.5, -2.0, 25.0};
  const std::vector<std::string> texts{"0,0;1,5\r\n-2;2,5E1\r\n", "0\t1,5\n-2,0\t25\n", "0,0 +1,5\n-2,0  25\n",
                                       "0;1,5;\n-2;25;\n",        "0, 1.5\n-2, 25\n",   "0,1.5\n-2,25\n"};
  for (const std::string& text : texts)
  {
    EXPECT_EQ(read("map.csv", text).heights, heights) << text;
    EXPECT_EQ(read("map.csv", text).nx, 2) << text;
  }
  EXPECT_EQ(read("map.csv", "0,5;\n1,5;\n").heights, (std::vector<double>{0.5, 1.5}));
  EXPECT_EQ(read("map.csv", "1,2,3\n4,5,6\n").nx, 3) << "between whole numbers";
  expect_refused(refused("map.csv", "0,5;1,5\n2,5;NaN\n"), "has in line 2, column 2 a height that is not finite");
  expect_refused(refused("map.csv", "0,5;1,5\n2,5\n"), "has in line 2 \"2,5\"; allowed: 4 heights");
}

TEST_F(HeightFile, WhatWasNotMeasuredIsToldWithItsPlace)
{
  const std::string remedy = "fill what was not measured, as \"brinell surface convert FILE OUT.npy --fill\"";
  const std::string text = refused("map.csv", "# heights\n0, 1, 2\n3, NaN, nan\n-inf, 1, 2\n");
  expect_refused(text, "has in line 3, column 2 a height that is not finite, the first of 3; " + remedy);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<double> heights{0.0, 1.0, 2.0, 3.0, 4.0, nan};
  expect_refused(refused("map.npy", npy_content(heights, 3)),
                 "has in row 2, column 3 a height that is not finite; " + remedy);
  expect_refused(refused("map.csv", "0 1\n2 x\n"), "has in line 2 \"2 x\"; allowed: 2 heights");
}

} // namespace

} // namespace brinell::io::texture_case_test
