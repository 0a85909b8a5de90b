// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/io/accuracy.hpp"
#include "brinell/io/versions.hpp"
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

/// A series takes the numbers of a run from the run itself, or from the summary of an earlier process: they are the same.
TEST(ResultSummary, HasTheNumbersOfARunOfASeries)
{
  const sample::TemporaryFolder folder;
  const Case c = sample::parsed();
  write_complete(folder.path(), c);
  const std::string text = sample::file_text(folder.path() / "summary.json");
  const simulation::TuggingPlan plan;
  const simulation::TuggingSummary summary = sample::hand_made_summary(c);
  const Level run = level_of(c, plan, summary, {}, 2.0);
  const auto read = level_of_this_build(text, 2.0);
  ASSERT_TRUE(read);
  EXPECT_EQ(read->cells, 2.0);
  EXPECT_EQ(read->spacing, run.spacing);
  EXPECT_EQ(read->numbers, run.numbers);
  EXPECT_EQ(read->stated_errors, run.stated_errors);
  EXPECT_EQ(run.numbers.at("forces.peak_F_X_N"), 0.25 * c.first_yield->critical.load);
  EXPECT_FALSE(run.numbers.contains("load_ratio.end")) << "a ratio that does not exist";

  const std::string hash = library_versions().git_hash;
  std::string other = text;
  other.replace(other.find(hash, other.find("\"git_hash\"")), hash.size(), "of another build");
  EXPECT_FALSE(level_of_this_build(other, 2.0));
  EXPECT_FALSE(level_of_this_build(text.substr(0, text.size() / 2), 2.0)) << "damaged";
  EXPECT_FALSE(level_of_this_build("{}", 2.0));
}

} // namespace

} // namespace brinell::io::result_summary_test
