// SPDX-License-Identifier: BSD-3-Clause
#include "program.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace brinell::cli::quality_test
{

namespace
{

using Json = nlohmann::json;

/// A rigid ball on a flat that yields, by load: some tenths of a second with few cells.
constexpr const char* press = R"(scenario = "indentation"
lower = {shape = {type = "flat"}, material = {young_modulus = "210 GPa", poisson_ratio = 0.3, hardening = {law = "perfect", yield_stress = "1 GPa"}}}
upper = {shape = {type = "sphere", radius = "1 mm"}, material = {rigid = true}}
[indentation]
load = ["5 N", 0]
steps = 6
[grid]
resolution = 7
[output]
snapshots = "none"
)";

class QualityOfRuns : public Program
{
protected:
  void SetUp() override
  {
    Program::SetUp();
    write("case.toml", press);
  }
  [[nodiscard]] Json summary() const { return Json::parse(file_text(folder() / "out" / "summary.json")); }
  /// Keys of the warnings in the summary of a run with these options.
  std::vector<std::string> keys_of(std::vector<std::string> options)
  {
    std::vector<std::string> arguments{"run", "case.toml", "-o", "out", "-q"};
    for (std::string& option : options)
    {
      arguments.emplace_back("--set");
      arguments.push_back(std::move(option));
    }
    outcome_ = run(arguments);
    EXPECT_EQ(outcome_.exit_code, 0) << outcome_.err;
    std::vector<std::string> keys;
    const Json read = summary();
    for (const Json& warning : read.at("warnings"))
    {
      keys.push_back(warning.at("key"));
      EXPECT_NE(outcome_.err.find(warning.at("text").get<std::string>()), std::string::npos) << outcome_.err;
    }
    return keys;
  }
  [[nodiscard]] const Outcome& outcome() const { return outcome_; }

private:
  Outcome outcome_;
};

using Keys = std::vector<std::string>;

TEST_F(QualityOfRuns, AGoodRunIsSilentAndTellsItsResolution)
{
  EXPECT_EQ(keys_of({}), Keys{});
  EXPECT_EQ(outcome().err, "");
  const Json resolution = summary().at("resolution");
  EXPECT_GT(resolution.at("cells_per_contact_radius").get<double>(), 6.0);
  EXPECT_GT(resolution.at("layers_of_plastic_zone").get<int>(), 4);
  EXPECT_GT(resolution.at("expected_errors").at("hardness").get<double>(), 0.0);
  const Outcome loud = run({"run", "case.toml", "-o", "out"});
  EXPECT_NE(loud.out.find("resolution: "), std::string::npos) << loud.out;
}

TEST_F(QualityOfRuns, WarningsAreToldAlsoWhenQuiet)
{
  EXPECT_EQ(keys_of({"grid.resolution=3"}), Keys{"coarse_contact"});
  EXPECT_EQ(keys_of({"lower.material.hardening.yield_stress=20 GPa"}), Keys{"no_yield"});
  EXPECT_EQ(keys_of({"solver.contact_tolerance=0.05"}), Keys{"loose_tolerance"});
  EXPECT_EQ(keys_of({"lower.texture={type=\"bump\", height=\"1 nm\", edge_radius=\"0.5 um\", x=\"50 um\"}"}),
            Keys{"coarse_texture"});
  const Keys hard = keys_of({"indentation.load=[\"2000 N\", 0]", "grid.resolution=6", "grid.extent=1.4"});
  EXPECT_EQ(std::count(hard.begin(), hard.end(), "large_strain"), 1);
}

// A ball that slides with friction 0.4 yields first at its trailing edge, between the cells.
TEST_F(QualityOfRuns, FirstYieldWithFrictionIsToldBeforeAndAfterARun)
{
  write("case.toml", R"(scenario = "rolling"
[lower]
shape = {type = "flat"}
material = {young_modulus = "210 GPa", poisson_ratio = 0.3, hardening = {law = "linear", yield_stress = "1 GPa", modulus = "10 GPa"}}
[upper]
shape = {type = "sphere", radius = "10 mm"}
material = {young_modulus = "210 GPa", poisson_ratio = 0.3}
[rolling]
hertz_pressure = "1.36 GPa"
distance = "0.3 mm"
slide_to_roll = 0.5
[interface]
friction = 0.4
)");
  EXPECT_EQ(keys_of({}), Keys{"missed_yield"});
  EXPECT_NE(outcome().err.find("no cell has yielded, but by the exact solution"), std::string::npos) << outcome().err;
  EXPECT_EQ(keys_of({"rolling.hertz_pressure=1.2 GPa"}), Keys{"no_yield"});
  const auto checked = [&](const std::vector<std::string>& more)
  {
    std::vector<std::string> arguments{"check", "case.toml"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(arguments).out;
  };
  EXPECT_NE(checked({}).find("1.360000e+09 Pa, 1.09"), std::string::npos) << checked({});
  EXPECT_NE(checked({}).find("times that at first yield of surfaces that slide with friction 0.4\n"),
            std::string::npos);
  const std::string ellipse =
      checked({"--set", "upper.shape={type=\"ellipsoid\", radius_x=\"10 mm\", radius_y=\"30 mm\"}"});
  EXPECT_NE(ellipse.find("(estimate for a round contact)"), std::string::npos) << ellipse;
}

TEST_F(QualityOfRuns, NoErrorIsStatedOfACoatInFewLayersOfCells)
{
  const std::string coat = "lower.material.layers=[{thickness=\"5 um\", young_modulus=\"200 GPa\", poisson_ratio=0.3, "
                           "hardening={law=\"perfect\", yield_stress=\"900 MPa\"}}]";
  const std::string cells = "grid.spacing=[\"3 um\", \"3 um\", ";
  EXPECT_EQ(keys_of({coat, cells + "\"1.25 um\"]"}), Keys{});
  EXPECT_FALSE(summary().at("resolution").at("expected_errors").empty());
  EXPECT_EQ(keys_of({coat, cells + "\"2.5 um\"]"}), Keys{"coarse_coat"});
  EXPECT_TRUE(summary().at("resolution").at("expected_errors").empty());
}

TEST_F(QualityOfRuns, FirstYieldOfACoatedBody)
{
  write("case.toml", R"(scenario = "indentation"
[lower]
shape = {type = "flat"}
[lower.material]
young_modulus = "210 GPa"
poisson_ratio = 0.3
hardening = {law = "linear", yield_stress = "2 GPa", modulus = "10 GPa"}
layers = [{thickness = "1 um", young_modulus = "100 GPa", poisson_ratio = 0.3, hardening = {law = "perfect", yield_stress = "0.5 GPa"}}]
[upper]
shape = {type = "sphere", radius = "50 um"}
material = {rigid = true}
[indentation]
load = ["5 mN", 0]
[grid]
resolution = 12
)");
  const std::string report = run({"check", "case.toml"}).out;
  EXPECT_NE(report.find("# First yield with layers, in layer 1 of the lower body: approach"), std::string::npos)
      << report;
  EXPECT_NE(report.find("# First yield without layers ("), std::string::npos) << report;
  // The substrate alone would stay elastic: nobody is told that nothing will yield.
  EXPECT_EQ(keys_of({}), Keys{});
  const Json of_run = summary();
  const Json& critical = of_run.at("critical");
  EXPECT_EQ(critical.at("with_layers").at("layer"), 0);
  EXPECT_LT(critical.at("with_layers").at("load_N").get<double>(), 0.1 * critical.at("load_N").get<double>());
  EXPECT_GT(of_run.at("residual").at("max_equivalent_plastic_strain").get<double>(), 0.0);
}

// Waves over a period, pressed so lightly that their mean planes stay apart.
TEST_F(QualityOfRuns, RoughFlatsTellOfWavesAndOfMeanPlanes)
{
  write("case.toml", R"(scenario = "indentation"
[lower]
shape = {type = "flat"}
material = {young_modulus = "200 GPa", poisson_ratio = 0.3}
[upper]
shape = {type = "flat"}
texture = {type = "sinusoid", amplitude = "1 um", wavelength_x = "40 um", wavelength_y = "40 um"}
material = {young_modulus = "200 GPa", poisson_ratio = 0.3}
[indentation]
pressure = ["5 MPa", 0]
steps = 3
[grid]
boundary = "periodic"
size = ["40 um", "40 um"]
cells = [16, 16]
)");
  const Outcome rough = run({"run", "case.toml", "-o", "out"});
  EXPECT_EQ(rough.exit_code, 0);
  EXPECT_EQ(rough.err.find("cells per radius"), std::string::npos) << rough.err;
  EXPECT_NE(rough.out.find("resolution: 16 cells per shortest wave"), std::string::npos) << rough.out;
  EXPECT_NE(rough.out.find("approach: from where the mean planes meet; negative"), std::string::npos) << rough.out;
  EXPECT_LT(summary().at("indents").at(0).at("max_approach_m").get<double>(), 0.0);
  EXPECT_EQ(summary().at("resolution").at("cells_per_shortest_wave").get<double>(), 16.0);
  EXPECT_TRUE(summary().at("resolution").at("cells_per_contact_radius").is_null());
}

TEST_F(QualityOfRuns, CheckTellsBefore)
{
  const Outcome coarse = run({"check", "case.toml", "--set", "grid.resolution=2.5"});
  EXPECT_EQ(coarse.exit_code, 0);
  EXPECT_NE(coarse.err.find("2.5 x 2.5 cells per radius"), std::string::npos) << coarse.err;
  EXPECT_NE(coarse.out.find("# Resolution: 2.5 x 2.5 cells per contact radius"), std::string::npos) << coarse.out;
  const Outcome elastic = run({"check", "case.toml", "--set", "upper.shape.radius=1"});
  EXPECT_NE(elastic.err.find("nothing will yield"), std::string::npos) << elastic.err;
  EXPECT_EQ(run({"check", "case.toml"}).err, "");
}

TEST_F(QualityOfRuns, WhatComputesNothingIsRefused)
{
  const Outcome cells = run({"run", "case.toml", "--set", "grid.spacing=[\"1 mm\", \"1 mm\", \"1 mm\"]", "-o", "out"});
  EXPECT_EQ(cells.exit_code, 2);
  EXPECT_NE(cells.err.find("grid.spacing"), std::string::npos) << cells.err;
  EXPECT_NE(cells.err.find("at least one cell per half-width"), std::string::npos) << cells.err;
  const Outcome loose = run({"run", "case.toml", "--set", "solver.contact_tolerance=0.9", "-o", "out"});
  EXPECT_EQ(loose.exit_code, 2);
  EXPECT_NE(loose.err.find("allowed: number in (0, 0.1)"), std::string::npos) << loose.err;
  write("tug.toml", quick_case);
  const Outcome shift = run({"run", "tug.toml", "--set", "tugging.shift=1 m", "-o", "out"});
  EXPECT_EQ(shift.exit_code, 2);
  EXPECT_NE(shift.err.find("tugging.shift"), std::string::npos) << shift.err;
  EXPECT_NE(shift.err.find("longer than the contact"), std::string::npos) << shift.err;
  EXPECT_FALSE(fs::exists(folder() / "out"));
}

// --- Accuracy --------------------------------------------------------------------------------------------------------

TEST_F(QualityOfRuns, AccuracyRunsASeries)
{
  const Outcome series = run({"run", "case.toml", "-o", "out", "--set", "grid.resolution=4", "--accuracy", "40%"});
  ASSERT_EQ(series.exit_code, 0) << series.err;
  EXPECT_NE(series.out.find("accuracy 40 % reached"), std::string::npos) << series.out;
  EXPECT_NE(series.out.find("indents[0].hardness_Pa"), std::string::npos) << series.out;
  const Json read = summary();
  const Json& accuracy = read.at("accuracy");
  EXPECT_EQ(accuracy.at("asked"), 0.4);
  EXPECT_TRUE(accuracy.at("reached").get<bool>());
  ASSERT_EQ(accuracy.at("runs").size(), 3u);
  EXPECT_EQ(accuracy.at("runs")[2].at("spacing_m"), read.at("grid").at("spacing_m")) << "the finest is the result";
  EXPECT_NEAR(accuracy.at("runs")[0].at("cells").get<double>(), 2.0, 1e-12);
  for (const Json& name : accuracy.at("key_numbers"))
  {
    const Json& number = accuracy.at("numbers").at(name.get<std::string>());
    EXPECT_LE(number.at("low").get<double>(), number.at("value").get<double>()) << name;
    EXPECT_GE(number.at("high").get<double>(), number.at("value").get<double>()) << name;
    EXPECT_LE(number.at("relative_error").get<double>(), 0.4) << name;
  }
  EXPECT_EQ(accuracy.at("numbers").at("indents[0].hardness_Pa").at("value"), read.at("indents")[0].at("hardness_Pa"));
  const Json& hardness = accuracy.at("numbers").at("indents[0].hardness_Pa");
  const double half = hardness.at("high").get<double>() - hardness.at("value").get<double>();
  const Json& resolution = read.at("resolution");
  EXPECT_NEAR(resolution.at("expected_errors").at("hardness").get<double>(), half / hardness.at("value").get<double>(),
              1e-12)
      << "the measured error takes the place of that of the tables";
  EXPECT_NE(resolution.at("errors_of_tables").at("hardness"), resolution.at("expected_errors").at("hardness"));
  EXPECT_NE(series.out.find("errors, measured by the series of runs: "), std::string::npos) << series.out;
  const auto expected = series.out.find("expected errors, estimated from the convergence tables: ");
  EXPECT_EQ(series.out.substr(std::min(expected, series.out.size())).find(" % hardness"), std::string::npos)
      << "no second error: " << series.out;
  for (const char* file : {"history.csv", "summary.json", "result.vtkhdf", "resolved.toml"})
    EXPECT_TRUE(fs::exists(folder() / "out" / file)) << file;
  EXPECT_TRUE(fs::exists(folder() / "out" / "accuracy" / "2" / "summary.json"));
  EXPECT_FALSE(fs::exists(folder() / "out" / "accuracy" / "3"));
  EXPECT_EQ(file_text(folder() / "out" / "resolved.toml"),
            file_text(folder() / "out" / "accuracy" / "1" / "resolved.toml"));
}

TEST_F(QualityOfRuns, CellsThatFitAShortTrackFallFromRunToRun)
{
  // Two cells to the radius, and 2.8, fit this track with the same six; the elastic radius is 25.3 micrometres.
  write("track.toml", R"(scenario = "rolling"
lower = {shape = {type = "flat"}, material = {young_modulus = "210 GPa", poisson_ratio = 0.3}}
upper = {shape = {type = "sphere", radius = "1 mm"}, material = {rigid = true}}
rolling = {load = "5 N", distance = "53.2 um", load_steps = 1}
grid = {resolution = 4}
)");
  const Outcome series = run({"run", "track.toml", "-o", "out", "-q", "--accuracy", "50%"});
  ASSERT_EQ(series.exit_code, 0) << series.err;
  const Json read = summary();
  const Json& runs = read.at("accuracy").at("runs");
  ASSERT_GE(runs.size(), 3u);
  for (std::size_t i = 0; i < runs.size(); ++i)
  {
    const double dx = runs[i].at("spacing_m")[0];
    const double cells = 53.2e-6 / dx;
    EXPECT_NEAR(cells, std::round(cells), 1e-6);
    if (i > 0)
    {
      EXPECT_LT(dx, (1.0 - 1e-6) * runs[i - 1].at("spacing_m")[0].get<double>());
      EXPECT_LT(runs[i].at("cells").get<double>(), runs[i - 1].at("cells").get<double>());
    }
  }
}

TEST_F(QualityOfRuns, AnIntervalThatContainsZeroIsTold)
{
  const Outcome series = run({"run", "case.toml", "-o", "out", "--set", "grid.resolution=3", "--set",
                              "lower.material.hardening={law=\"none\"}", "--accuracy", "40%"});
  ASSERT_EQ(series.exit_code, 0) << series.err;
  EXPECT_NE(series.out.find("indents[0].residual_depth_m: the interval contains zero"), std::string::npos)
      << series.out;
  EXPECT_EQ(series.out.find("indents[0].hardness_Pa: the interval"), std::string::npos) << series.out;
}

TEST_F(QualityOfRuns, AnAccuracyThatIsMissedIsTold)
{
  const Outcome series =
      run({"run", "case.toml", "-o", "out", "-q", "--set", "grid.resolution=2", "--set", "solver.accuracy=0.0001 %"});
  ASSERT_EQ(series.exit_code, 0) << series.err;
  EXPECT_NE(series.err.find("is not reached"), std::string::npos) << series.err;
  const Json read = summary();
  EXPECT_FALSE(read.at("accuracy").at("reached").get<bool>());
  EXPECT_EQ(read.at("accuracy").at("runs").size(), 5u);
  EXPECT_EQ(read.at("warnings").back().at("key"), "accuracy_missed");
  const auto advice = read.at("warnings").back().at("text").get<std::string>();
  for (const char* part : {"the requested accuracy of 0.0001 % is not reached", "indents[0].", ", in ",
                           "a larger grid.resolution", "would reduce it"})
    EXPECT_NE(advice.find(part), std::string::npos) << part << "\n  in: " << advice;
  EXPECT_EQ(advice.find("indentation.steps"), std::string::npos) << "six steps are enough: " << advice;
  const Outcome of_few = run({"run", "case.toml", "-o", "few", "-q", "--set", "grid.resolution=2", "--set",
                              "indentation.steps=2", "--set", "solver.accuracy=0.0001 %"});
  ASSERT_EQ(of_few.exit_code, 0) << of_few.err;
  EXPECT_NE(of_few.err.find("more steps than indentation.steps = 2, which the series keeps"), std::string::npos)
      << of_few.err;
}

TEST_F(QualityOfRuns, BadAccuracies)
{
  for (const char* bad : {"0", "-1%", "60 %", "much", "1 percent"})
  {
    const Outcome outcome = run({"check", "case.toml", "--set", std::string("solver.accuracy=") + bad});
    EXPECT_EQ(outcome.exit_code, 2) << bad;
    EXPECT_NE(outcome.err.find("solver.accuracy"), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find("allowed: number in (0, 0.5]"), std::string::npos) << outcome.err;
  }
}

TEST_F(QualityOfRuns, AnInterruptedSeriesTakesOverWhatIsFinished)
{
  const std::vector<std::string> arguments{"run",   "case.toml",         "-o",         "out",
                                           "--set", "grid.resolution=4", "--accuracy", "40%"};
  ASSERT_EQ(run(arguments).exit_code, 0);
  const Json whole = summary();
  // As if it had been killed in the last run: no summary, two finished coarser runs.
  fs::remove(folder() / "out" / "summary.json");
  std::vector<std::string> resumed = arguments;
  resumed.emplace_back("--resume");
  const Outcome outcome = run(resumed);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.err.find("run 2 for the accuracy, cells of 1.41 times the size: reused"), std::string::npos)
      << outcome.err;
  EXPECT_EQ(outcome.err.find("run 3 for the accuracy, cells of 1 times the size: reused"), std::string::npos);
  EXPECT_EQ(summary().at("accuracy"), whole.at("accuracy"));

  // A finished run of another case is not taken over.
  fs::remove(folder() / "out" / "summary.json");
  const fs::path stranger = folder() / "out" / "accuracy" / "2" / "resolved.toml";
  const std::string text = file_text(stranger);
  std::ofstream(stranger) << text << "# another\n";
  const Outcome again = run(resumed);
  ASSERT_EQ(again.exit_code, 0) << again.err;
  EXPECT_EQ(again.err.find("run 2 for the accuracy, cells of 1.41 times the size: reused"), std::string::npos)
      << again.err;
  EXPECT_EQ(summary().at("accuracy"), whole.at("accuracy"));
}

} // namespace

TEST_F(QualityOfRuns, TellWhereTheStrainOfASlidingSurfaceIsThatOfItsCells)
{
  write("case.toml", R"(scenario = "tugging"
lower = {shape = {type = "sphere", radius = "10 um"}, material = {young_modulus = "200 GPa", poisson_ratio = 0.3, hardening = {law = "linear", yield_stress = "600 MPa", modulus = "0 GPa"}}}
upper = {shape = {type = "sphere", radius = "10 um"}, material = {young_modulus = "200 GPa", poisson_ratio = 0.3}}
tugging = {interference = 3}
interface = {friction = 0.4}
grid = {resolution = 4}
output = {snapshots = "none"}
)");
  const auto tells = [&](const std::string& key, const std::string& value)
  {
    const Outcome outcome = run({"run", "case.toml", "-o", "out", "--set", key + "=" + value});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    const bool is_told = outcome.err.find("depends on the thickness of the uppermost layer") != std::string::npos;
    const bool flows = outcome.err.find("the shear is at the limit of the surface") != std::string::npos;
    EXPECT_EQ(flows, summary().at("max_share_at_shear_limit") > 0.05 && key != "interface.shear_limit");
    EXPECT_EQ(flows, summary().at("resolution").at("expected_errors").empty()) << outcome.err;
    const std::string warnings = summary().at("warnings").dump();
    EXPECT_EQ(warnings.find("free_flow") != std::string::npos, is_told) << warnings;
    return is_told;
  };
  EXPECT_TRUE(tells("lower.material.hardening.modulus", "0 GPa"));
  EXPECT_GT(summary().at("max_share_at_shear_limit"), 0.0);
  EXPECT_FALSE(tells("lower.material.hardening.modulus", "20 GPa")) << "strain of a surface that hardens is definite";
  EXPECT_GT(summary().at("max_share_at_shear_limit"), 0.05) << "but its errors are not those of the tables";
  EXPECT_FALSE(tells("interface.shear_limit", "200 MPa")) << "a film below the strength of the body";
  EXPECT_FALSE(tells("interface.friction", "0.05")) << "the limit is not reached";
}

} // namespace brinell::cli::quality_test
