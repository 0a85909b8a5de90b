// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/foundation/error.hpp"
#include "brinell/io/measured_curve.hpp"
#include "sample.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <functional>
#include <random>

/// Hardening curves from curves that a test made from a known law.
namespace brinell::io::measured_curve_test
{
namespace
{

using Law = std::function<double(double)>;

constexpr double E = 210e9; // [Pa]

double linear(double e)
{
  return 800e6 + 4e9 * e;
}
double swift(double e)
{
  return 1.5e9 * std::pow(0.004 + e, 0.1);
}
double voce(double e)
{
  return 600e6 + 300e6 * -std::expm1(-40.0 * e);
}

/// A tensile test in true values: 20 elastic points from the origin, then plastic strains up to `end`.
Curve tensile_test(const Law& law, double end = 0.12, double slope = E)
{
  Curve curve;
  for (int i = 0; i < 20; ++i)
  {
    curve.stress.push_back(law(0.0) * i / 20.0);
    curve.strain.push_back(curve.stress.back() / slope);
  }
  constexpr int n = 241;
  for (int i = 0; i < n; ++i)
  {
    const double e = end * i / (n - 1);
    curve.stress.push_back(law(e));
    curve.strain.push_back(e + law(e) / slope);
  }
  return curve;
}

CurveRules total_rules()
{
  return {.strain = CurveRules::Strain::total, .young_modulus = E};
}

/// Largest relative deviation from a law at the points beyond a plastic strain.
double deviation(const HardeningCurve& curve, const Law& law, double from)
{
  double most = 0.0;
  for (std::size_t i = 0; i < curve.stress.size(); ++i)
    if (curve.plastic_strain[i] >= from)
      most = std::max(most, std::abs(curve.stress[i] / law(curve.plastic_strain[i]) - 1.0));
  return most;
}

std::string message(const Curve& curve, const CurveRules& rules)
{
  try
  {
    (void)hardening_curve(curve, rules);
  }
  catch (const InputError& error)
  {
    return error.what();
  }
  return "no error";
}

void expect_in(const std::string& text, const std::string& part)
{
  EXPECT_NE(text.find(part), std::string::npos) << part << " is not in: " << text;
}

std::string joined(const std::vector<std::string>& texts)
{
  std::string all;
  for (const std::string& text : texts)
    all += text + "\n";
  return all;
}

TEST(MeasuredCurve, TotalStrainGivesTheLawBeyondTheOffset)
{
  for (const Law& law : {Law(linear), Law(swift), Law(voce)})
  {
    const HardeningCurve curve = hardening_curve(tensile_test(law), total_rules());
    EXPECT_EQ(curve.plastic_strain.front(), 0.0);
    EXPECT_EQ(curve.plastic_strain[1], 0.002);
    EXPECT_EQ(curve.stress[0], curve.stress[1]); // constant up to the offset
    // Linear interpolation between points 5e-4 apart: below 1e-4 where these laws bend most.
    EXPECT_NEAR(curve.stress.front() / law(0.002), 1.0, 1e-4);
    EXPECT_LT(deviation(curve, law, 0.0021), 1e-12); // the points themselves, up to rounding
    EXPECT_NEAR(curve.slope.value(), E, 1e-6 * E);
    EXPECT_TRUE(curve.warnings.empty());
    expect_in(joined(curve.notes), "at 0.2 % plastic strain");
  }
}

TEST(MeasuredCurve, AFitFindsWhereAKnownLawBegins)
{
  CurveRules rules = total_rules();
  rules.yield_from = CurveRules::YieldFrom::fit;
  for (const Law& law : {Law(linear), Law(swift), Law(voce)})
  {
    const HardeningCurve curve = hardening_curve(tensile_test(law), rules);
    EXPECT_NEAR(curve.stress.front() / law(0.0), 1.0, 1e-4); // the fit has converged, and the law is among those tried
    EXPECT_LT(deviation(curve, law, 0.0), 1e-4);
  }
}

TEST(MeasuredCurve, EngineeringValuesOfTensionAndCompressionGiveTheSameLaw)
{
  const Curve test = tensile_test(swift, 0.08); // below the largest force, at e = 0.1
  for (const double sign : {1.0, -1.0})
  {
    Curve engineering;
    for (std::size_t i = 0; i < test.strain.size(); ++i)
    {
      engineering.strain.push_back(std::expm1(sign * test.strain[i]));
      engineering.stress.push_back(sign * test.stress[i] / (1.0 + engineering.strain[i]));
    }
    CurveRules rules = total_rules();
    rules.measure = CurveRules::Measure::engineering;
    const HardeningCurve curve = hardening_curve(engineering, rules);
    EXPECT_LT(deviation(curve, swift, 0.0021), 1e-12);
    expect_in(joined(curve.notes), sign > 0.0 ? "of a tensile test" : "of a compression test");
  }
}

TEST(MeasuredCurve, EngineeringValuesEndAtTheLargestForce)
{
  Curve engineering;
  const Curve test = tensile_test(swift, 0.3);
  double most = 0.0;
  for (std::size_t i = 0; i < test.strain.size(); ++i)
  {
    engineering.strain.push_back(std::expm1(test.strain[i]));
    engineering.stress.push_back(test.stress[i] / (1.0 + engineering.strain[i]));
    most = std::max(most, engineering.stress.back());
  }
  CurveRules rules = total_rules();
  rules.measure = CurveRules::Measure::engineering;
  const HardeningCurve curve = hardening_curve(engineering, rules);
  // Considere: d sigma/d eps = sigma, for Swift's law at 0.004 + e = 0.1 (elastic strain apart).
  EXPECT_NEAR(curve.plastic_strain.back(), 0.096, 0.004);
  expect_in(joined(curve.notes), fmt::format("after the largest force, {:.4g} Pa; the specimen necks there", most));
}

TEST(MeasuredCurve, UnloadingAndRepeatedStrainsChangeNothing)
{
  const HardeningCurve plain = hardening_curve(tensile_test(voce), total_rules());
  Curve looped;
  const Curve test = tensile_test(voce);
  for (std::size_t i = 0; i < test.strain.size(); ++i)
  {
    looped.strain.push_back(test.strain[i]);
    looped.stress.push_back(test.stress[i]);
    if (i == 100 || i == 180)
      for (const double share : {0.7, 0.3, 0.05, 0.4, 0.8})
      {
        looped.stress.push_back(share * test.stress[i]);
        looped.strain.push_back(test.strain[i] - (test.stress[i] - looped.stress.back()) / E);
      }
    if (i == 60) // held: the stress relaxes
    {
      looped.stress.push_back(0.97 * test.stress[i]);
      looped.strain.push_back(test.strain[i]);
    }
  }
  const HardeningCurve curve = hardening_curve(looped, total_rules());
  EXPECT_EQ(curve.plastic_strain, plain.plastic_strain);
  EXPECT_EQ(curve.stress, plain.stress);
  expect_in(joined(curve.notes), "10 points at strains below an earlier one (2 unloadings)");
  expect_in(joined(curve.notes), "1 point at a repeated strain");
}

TEST(MeasuredCurve, TheLineOfTheCurveTakesOffComplianceAndZero)
{
  Curve curve = tensile_test(swift);
  for (std::size_t i = 0; i < curve.strain.size(); ++i)
    curve.strain[i] += curve.stress[i] * (1.0 / 50e9 - 1.0 / E) + 0.001;
  const HardeningCurve wrong = hardening_curve(curve, total_rules());
  ASSERT_FALSE(wrong.warnings.empty());
  EXPECT_EQ(wrong.warnings.front().key, "curve_slope");
  expect_in(wrong.warnings.front().text, "5e+10 Pa, is 76 % below Young's modulus, 2.1e+11 Pa");
  CurveRules rules = total_rules();
  rules.slope = CurveRules::Slope::curve;
  rules.young_modulus.reset();
  const HardeningCurve right = hardening_curve(curve, rules);
  EXPECT_NEAR(right.zero, 0.001, 1e-12);
  EXPECT_LT(deviation(right, swift, 0.0021), 1e-9);
  EXPECT_TRUE(right.warnings.empty());
}

TEST(MeasuredCurve, ScatterIsLevelledAndAFallIsRefused)
{
  Curve curve = tensile_test(voce);
  std::mt19937 engine(5);
  std::normal_distribution<double> noise(0.0, 2e6);
  for (double& stress : curve.stress)
    stress += noise(engine);
  const HardeningCurve levelled = hardening_curve(curve, total_rules());
  EXPECT_TRUE(std::is_sorted(levelled.stress.begin(), levelled.stress.end()));
  // Four standard deviations of the noise, of 600 MPa; means of blocks lie between what they replace.
  EXPECT_LT(deviation(levelled, voce, 0.0021), 4.0 * 2e6 / 600e6);
  expect_in(joined(levelled.notes), "scatter levelled");

  Curve peak = tensile_test(linear);
  peak.stress[24] *= 1.2; // an upper yield point
  expect_in(message(peak, total_rules()), "fall by more than scatter");
  CurveRules rules = total_rules();
  rules.monotone = true;
  const HardeningCurve raised = hardening_curve(peak, rules);
  EXPECT_TRUE(std::is_sorted(raised.stress.begin(), raised.stress.end()));
}

TEST(MeasuredCurve, TheYieldStressMayBeTheFirstPoint)
{
  CurveRules rules = total_rules();
  rules.yield_from = CurveRules::YieldFrom::first_point;
  const Curve sheet{{0.0, 900e6 / E, 0.01 + 1000e6 / E}, {0.0, 900e6, 1000e6}};
  const HardeningCurve curve = hardening_curve(sheet, rules);
  EXPECT_EQ(curve.stress, (std::vector<double>{900e6, 1000e6}));
  EXPECT_EQ(curve.plastic_strain.front(), 0.0);
  EXPECT_NEAR(curve.plastic_strain.back(), 0.01, 1e-15);
  expect_in(message({{0.0, 0.02}, {0.0, 900e6}}, rules), "too far from 0 to begin to yield there");
}

TEST(MeasuredCurve, FewPointsAroundTheOffsetAreTold)
{
  const HardeningCurve curve = hardening_curve({{0.0, 0.02, 0.05}, {0.0, 900e6, 1000e6}}, total_rules());
  ASSERT_EQ(curve.warnings.size(), 1);
  expect_in(curve.warnings.front().text, "lies between points of 0 and 9e+08 Pa");
}

TEST(MeasuredCurve, WhatIsWrongIsSaid)
{
  const Curve good = tensile_test(swift);
  CurveRules rules = total_rules();
  rules.young_modulus.reset();
  expect_in(message(good, rules), "which need young_modulus");
  rules.slope = CurveRules::Slope::curve;
  expect_in(message({{0.0, 0.01, 0.02}, {0.0, 9e8, 1e9}}, rules), "less than 3 points between 10 and 40 %");
  rules = total_rules();
  rules.offset = 0.5;
  expect_in(message(good, rules), "reaches a plastic strain of 0.12 only");
  rules = total_rules();
  rules.young_modulus = 210e3; // of another unit
  expect_in(message(good, rules), "above Young's modulus, 2.1e+05 Pa");
  expect_in(message({{0.0, 0.01, 0.02}, {0.0, -9e8, -1e9}}, total_rules()), "strains mainly above 0, but stresses");
  rules = total_rules();
  rules.test = CurveRules::Test::tension;
  expect_in(message({{0.0, -0.01, -0.02}, {0.0, -9e8, -1e9}}, rules), "allowed with test = \"tension\": above 0");
  expect_in(message({{0.0, std::nan("")}, {0.0, 1.0}}, rules), "finite numbers");
  expect_in(message({{0.0, 0.01}, {0.0, 9e8}}, {}), "strain_type = \"total\"");
  expect_in(message({{0.01, 0.02}, {8e8, 9e8}}, {}), "begins at a strain of 0.01");
}

TEST(MeasuredCurve, ACaseReadsItAndTellsWhatWasDone)
{
  const auto file = std::filesystem::temp_directory_path() / "brinell_measured_curve_test.csv";
  {
    std::ofstream stream(file);
    const Curve curve = tensile_test(swift);
    stream << "strain;stress\n%;MPa\n";
    for (std::size_t i = 0; i < curve.strain.size(); ++i)
      stream << fmt::format("{:.12g};{:.12g}\n", 100.0 * curve.strain[i], 1e-6 * curve.stress[i]);
  }
  const std::string keys = fmt::format(R"(law="table", file="{}", stress_unit="MPa", strain_unit="%")", file.string());
  const auto parsed = [&](const std::string& more) {
    return sample::parsed({"lower.material.young_modulus=210 GPa", "lower.material.hardening={" + keys + more + "}"});
  };
  const Case c = parsed(R"(, strain_type="total", yield_offset="0.1 %")");
  const auto law = sample::tugging(c).lower.material.hardening.value();
  EXPECT_NEAR(constitutive::initial_yield_stress(law) / swift(0.001), 1.0, 1e-4);
  expect_in(joined(c.notes), "at 0.1 % plastic strain");
  for (const char* key : {"strain_type", "yield_offset", "file"}) // resolved: the hardening curve itself
    EXPECT_EQ(resolved_text(c.values).find(key), std::string::npos);
  const auto error = [&](const std::string& more)
  {
    try
    {
      (void)parsed(more);
    }
    catch (const InputError& caught)
    {
      return std::string(caught.what());
    }
    return std::string("no error");
  };
  expect_in(error(""), "strain_type = \"total\"");
  expect_in(error(R"(, strain_type="elastic")"), "is not known; allowed: \"plastic\" or \"total\"");
  expect_in(error(R"(, strain_type="total", yield_offset=2)"), "out of range");
  std::filesystem::remove(file);
}

} // namespace
} // namespace brinell::io::measured_curve_test
