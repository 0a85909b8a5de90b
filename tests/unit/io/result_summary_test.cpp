// SPDX-License-Identifier: BSD-3-Clause
#include "sample_result.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <numbers>

namespace brinell::io::result_summary_test
{

namespace
{

namespace fs = std::filesystem;
using sample::write_complete;

TEST(ResultSummary, IsNormalised)
{
  const sample::TemporaryFolder folder;
  write_complete(folder.path(), sample::parsed());
  const auto json = nlohmann::json::parse(sample::file_text(folder.path() / "summary.json"));
  EXPECT_EQ(json["format_version"], 3);
  EXPECT_EQ(json["complete"], true);
  EXPECT_DOUBLE_EQ(json["normalised"]["peak_F_X"], 0.25);
  EXPECT_DOUBLE_EQ(json["normalised"]["X_over_R_at_peak_F_X"], -0.45); // radii 1 and 2: R = 2/3
  EXPECT_DOUBLE_EQ(json["normalised"]["net_energy"], 3.0);
  EXPECT_DOUBLE_EQ(json["normalised"]["max_residual_lower"], 0.5);
  EXPECT_DOUBLE_EQ(json["normalised"]["interference"], 9.0);
  EXPECT_TRUE(json["load_ratio"]["end"].is_null()) << "a ratio that does not exist";
  EXPECT_EQ(json["critical"]["yields_first"], "lower");
  EXPECT_EQ(json["run"]["threads"], 3);
  EXPECT_EQ(json["case"]["lower"]["material"]["hardening"]["yield_stress"], 0.9115e9);
  EXPECT_EQ(json["case"]["grid"]["spacing"][2], 0.001925);
}

TEST(ResultSummary, TellsInWhatTheBodiesTouch)
{
  const sample::TemporaryFolder folder;
  write_complete(folder.path() / "point", sample::parsed());
  const auto critical = nlohmann::json::parse(sample::file_text(folder.path() / "point" / "summary.json"))["critical"];
  EXPECT_EQ(critical["contact"], "point");
  const double a = critical["contact_radius_m"];
  EXPECT_DOUBLE_EQ(critical["contact_area_m2"], std::numbers::pi * a * a);
  EXPECT_TRUE(critical["line_length_m"].is_null());

  write_complete(folder.path() / "line",
                 sample::parsed({"lower.shape={type=\"cylinder\", radius=1}",
                                 "upper.shape={type=\"cylinder\", radius=1}", "grid.boundary=[\"open\", \"periodic\"]",
                                 "grid.spacing=[\"3.85 mm\", \"50 mm\", \"1.925 mm\"]"}));
  const auto line = nlohmann::json::parse(sample::file_text(folder.path() / "line" / "summary.json"));
  EXPECT_EQ(line["critical"]["contact"], "line");
  EXPECT_EQ(line["critical"]["line_length_m"], 1.0);
  EXPECT_DOUBLE_EQ(line["critical"]["line_reference_m"], 1.0 / std::numbers::e); // 2 R/e, R = 0.5
  EXPECT_DOUBLE_EQ(line["critical"]["contact_area_m2"], 2.0 * line["critical"]["contact_radius_m"].get<double>());
  EXPECT_DOUBLE_EQ(line["normalised"]["peak_F_X"], 0.25);
  EXPECT_DOUBLE_EQ(line["normalised"]["interference"], 9.0);
}

TEST(ResultSummary, OfElasticBodiesHasNoScales)
{
  const sample::TemporaryFolder folder;
  write_complete(folder.path(), sample::parsed({"lower.material.hardening.law=none", "tugging.normalised=false",
                                                "tugging.interference=1 mm"}));
  const auto json = nlohmann::json::parse(sample::file_text(folder.path() / "summary.json"));
  EXPECT_TRUE(json["critical"]["load_N"].is_null());
  for (const auto& [key, value] : json["normalised"].items())
    EXPECT_TRUE(value.is_null() || key == "X_over_R_at_peak_F_X") << key;
}

} // namespace

} // namespace brinell::io::result_summary_test
