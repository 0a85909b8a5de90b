// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/foundation/error.hpp"
#include "brinell/io/case_file.hpp"
#include "io/npy.hpp"
#include "sample.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <fmt/format.h>
#include <fstream>
#include <string>
#include <vector>

/// Inclusions as they stand in a case file.
namespace brinell::io::inclusion_case_test
{
namespace
{

using simulation::BodyInclusion;
using simulation::InclusionCluster;
using simulation::InclusionShape;
using simulation::InclusionVoxels;

constexpr const char* ball =
    R"({type="ellipsoid", depth="20 mm", size="16 mm", young_modulus="390 GPa", poisson_ratio=0.25})";

std::string inclusions(const std::string& tables)
{
  return "lower.inclusion=[" + tables + "]";
}

const std::vector<BodyInclusion>& of_lower(const Case& c)
{
  return sample::tugging(c).lower.inclusions;
}

TEST(InclusionCase, ShapesAreRead)
{
  using Kind = InclusionShape::Kind;
  const Case c = sample::parsed({inclusions(
      std::string(ball) +
      R"(, {type="cylinder", axis="y", x="-50 mm", y="2 mm", depth="30 mm", size=["40 mm", "60 mm", "30 mm"], young_modulus=1e11,)" +
      R"( poisson_ratio=0.3, yield_factor=0.5, misfit=["0.1 %", 0, "-0.1 %", 0, 2e-3, 0]},)" +
      R"({type="cuboid", x="60 mm", depth="20 mm", size="20 mm", content="void"})")});
  const std::vector<BodyInclusion>& read = of_lower(c);
  ASSERT_EQ(read.size(), 3U);
  EXPECT_EQ(read[0],
            (BodyInclusion{{390e9, 0.25}, InclusionShape{Kind::ellipsoid, {0.0, 0.0, 0.02}, {8e-3, 8e-3, 8e-3}}}));
  EXPECT_EQ(std::get<InclusionShape>(read[1].region),
            (InclusionShape{Kind::cylinder, {-0.05, 2e-3, 0.03}, {0.02, 0.03, 0.015}, 1}));
  EXPECT_EQ(read[1].yield_factor, 0.5);
  EXPECT_EQ(read[1].own, (halfspace::Inclusion::Own{Deviator{{1e-3, 0.0, 0.0, 2e-3, 0.0}}, 0.0}));
  EXPECT_EQ(read[2].elastic.young_modulus, 0.0);
  const Case rigid =
      sample::parsed({"lower.inclusion.type=cuboid", "lower.inclusion.size=20 mm", "lower.inclusion.depth=20 mm",
                      "lower.inclusion.content=rigid", "lower.inclusion.misfit=1e-3"});
  ASSERT_EQ(of_lower(rigid).size(), 1U);
  EXPECT_TRUE(std::isinf(of_lower(rigid).front().elastic.young_modulus));
  EXPECT_EQ(of_lower(rigid).front().own.dilatation, 1e-3);
}

TEST(InclusionCase, ClustersAndVoxelsAreRead)
{
  const Case c = sample::parsed({inclusions(
      R"({type="cluster", depth="20 mm", size=["80 mm", "80 mm", "30 mm"], count=3, diameter=["16 mm", "18 mm"], gap="1 mm", seed=7,)"
      R"( young_modulus=4e11, poisson_ratio=0.2})")});
  EXPECT_EQ(std::get<InclusionCluster>(of_lower(c).front().region),
            (InclusionCluster{{0.0, 0.0, 0.02}, {0.04, 0.04, 0.015}, 8e-3, 9e-3, 3, 1e-3, 7}));
  const Case v = sample::parsed({inclusions(
      R"({type="voxels", depth="20 mm", size="8 mm", voxels=[1, 1, 0, 1], columns=2, rows=1, young_modulus=4e11, poisson_ratio=0.2})")});
  const auto& voxels = std::get<InclusionVoxels>(of_lower(v).front().region);
  EXPECT_EQ(voxels.count, (std::array{2, 1, 2}));
  EXPECT_NEAR(voxels.corner[0], -8e-3, 1e-15);
  EXPECT_NEAR(voxels.corner[2], 0.012, 1e-15);
  EXPECT_EQ(voxels.is_filled, (std::vector<char>{1, 1, 0, 1}));
}

TEST(InclusionCase, TheResolvedCaseGivesThemBack)
{
  const Case c = sample::parsed({inclusions(
      std::string(ball) +
      R"(, {type="voxels", x="60 mm", depth="20 mm", size="8 mm", voxels=[1, 1, 0, 1], columns=2, rows=1, content="rigid"})")});
  const Case again = parse_case(resolved_text(c.values), "resolved.toml", {});
  EXPECT_EQ(of_lower(again), of_lower(c));
}

// Voxels of a file in [z, y, x], and the file that a folder of results keeps of many of them.
TEST(InclusionCase, VoxelsOfAFileAreKeptWithTheResults)
{
  const sample::TemporaryFolder folder;
  constexpr int nx = 12, ny = 10, nz = 11;
  std::vector<double> filled(static_cast<std::size_t>(nx * ny * nz), 1.0);
  filled[3] = 0.0;
  std::string content = npy_content(filled, nx);
  const std::string flat = fmt::format("({}, {}), ", ny * nz, nx), volume = fmt::format("({},{},{}),", nz, ny, nx);
  content.replace(content.find(flat), flat.size(), volume + std::string(flat.size() - volume.size(), ' '));
  std::ofstream(folder.path() / "filled.npy", std::ios::binary) << content;
  const auto parsed = [&](const std::string& text) { return parse_case(text, folder.path() / "case.toml", {}); };
  const Case c = parsed(std::string(sample::case_text) + R"(
[lower.inclusion]
type = "voxels"
file = "filled.npy"
depth = "25 mm"
size = "4 mm"
content = "rigid"
)");
  const auto& voxels = std::get<InclusionVoxels>(of_lower(c).front().region);
  EXPECT_EQ(voxels.count, (std::array{nx, ny, nz}));
  EXPECT_EQ(voxels.is_filled[3], 0);
  write_resolved(folder.path() / "resolved.toml", c.values);
  EXPECT_EQ(of_lower(read_case(folder.path() / "resolved.toml")), of_lower(c));
  remove_resolved_maps(folder.path());
  EXPECT_THROW((void)read_case(folder.path() / "resolved.toml"), InputError);
}

// Each mistake is told once, at its key.
TEST(InclusionCase, ClustersTellWhatIsWrong)
{
  const auto told = [](const std::string& keys)
  {
    try
    {
      (void)sample::parsed({inclusions(R"({type="cluster", depth="20 mm", count=3, content="void", )" + keys + "}")});
    }
    catch (const InputError& error)
    {
      return std::string(error.what());
    }
    return std::string();
  };
  const std::string size = told(R"(size=["20 mm", "20 mm"], diameter="1 mm")"),
                    diameter = told(R"(size="20 mm", diameter=["2 mm", "1 mm"])");
  EXPECT_NE(size.find("lower.inclusion[0].size"), std::string::npos) << size;
  EXPECT_EQ(size.find("lower.inclusion[0].count"), std::string::npos) << size;
  EXPECT_NE(diameter.find("lower.inclusion[0].diameter"), std::string::npos) << diameter;
  EXPECT_EQ(diameter.find("lower.inclusion[0].count"), std::string::npos) << diameter;
}

TEST(InclusionCase, VoxelFilesTellWhatIsWrong)
{
  const sample::TemporaryFolder folder;
  std::vector<double> filled(24, 1.0);
  const auto told = [&](const std::string& keys)
  {
    std::ofstream(folder.path() / "filled.npy", std::ios::binary) << npy_content(filled, 4);
    try
    {
      (void)parse_case(std::string(sample::case_text) + R"(
[lower.inclusion]
type = "voxels"
file = "filled.npy"
depth = "25 mm"
size = "8 mm"
content = "rigid"
)" + keys,
                       folder.path() / "case.toml", {});
    }
    catch (const InputError& error)
    {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(told("rows = 3"), ""); // two layers
  EXPECT_NE(told("columns = 3").find("lower.inclusion.columns = 3 does not fit the 4 columns"), std::string::npos);
  EXPECT_NE(told("rows = 4").find("lower.inclusion.rows = 4 does not fit the 6 rows"), std::string::npos);
  filled[5] = std::nan("");
  EXPECT_NE(told("").find("lower.inclusion.file = \"filled.npy\" has a voxel that is no finite number"),
            std::string::npos)
      << told("");
}

TEST(InclusionCase, ErrorsNameTheInclusion)
{
  sample::expect_message(
      {inclusions(R"({type="ellipsoid", depth="2 m", size="16 mm", young_modulus="390 GPa", poisson_ratio=0.25})")},
      "lower.inclusion[0] reaches down to 2.008 m");
  sample::expect_message({inclusions(R"({type="cuboid", depth="2 mm", size="1 mm", content="rigid", misfit=0.5})")},
                         "lower.inclusion[0].misfit = 0.5");
  sample::expect_message({inclusions(R"({type="ellipsoid", size="2 mm", young_modulus=4e11, poisson_ratio=0.2})")},
                         "lower.inclusion[0].depth is missing; allowed: length >= 0");
  sample::expect_message({inclusions(R"({type="ellipsoid", depth="2 mm", size="2 mm", poisson_ratio=0.2})")},
                         "lower.inclusion[0].young_modulus is missing");
  sample::expect_message({inclusions(R"({type="cuboid", depth="2 mm", size=[1, 2], content="void"})")},
                         "lower.inclusion[0].size = [1, 2] has 2 lengths; allowed: one, or three");
  sample::expect_message(
      {inclusions(R"({type="cuboid", depth="2 mm", size="1 mm", content="void", young_modulus=1e9})")},
      R"(lower.inclusion[0].young_modulus = 1000000000.0 applies only with lower.inclusion[0].content = "elastic")");
  sample::expect_message(
      {inclusions(R"({type="cuboid", depth="2 mm", size="1 mm", content="rigid", misfit=[0.01, 0.02]})")},
      "lower.inclusion[0].misfit = [0.01, 0.02] has 2 numbers");
  sample::expect_message({inclusions(R"({depth="2 mm"})")}, "lower.inclusion[0].depth");
  sample::expect_message(
      {inclusions(R"({type="cluster", depth="20 mm", size="20 mm", count=99, diameter="9 mm", content="void"})")},
      "found room");
  sample::expect_message({"lower.material.hardening={law=\"none\"}", inclusions(ball)}, "allowed: a hardening law");
  sample::expect_message({"upper.material={rigid=true}",
                          R"(upper.inclusion={type="ellipsoid", depth="20 mm", size="16 mm", content="void"})"},
                         "upper.material.rigid does not go with upper.inclusion");
}

} // namespace
} // namespace brinell::io::inclusion_case_test
