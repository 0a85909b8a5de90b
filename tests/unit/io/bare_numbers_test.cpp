// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/foundation/error.hpp"
#include "brinell/io/case_file.hpp"
#include "brinell/io/case_template.hpp"
#include "sample.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

/// Plain numbers that were probably meant in N, mm and MPa.
namespace brinell::io::bare_numbers_test
{
namespace
{

constexpr const char* plain_case = R"(scenario = "indentation"
[lower]
shape = {type = "flat"}
[lower.material]
young_modulus = 210000
poisson_ratio = 0.3
hardening = {law = "linear", yield_stress = 600, modulus = 2000}
[upper]
shape = {type = "sphere", radius = 10}
material = {rigid = true}
[indentation]
load = [1000, 0]
[grid]
resolution = 8
)";

/// Texts of the warnings about plain numbers; those of a case that is refused stand in its error.
std::string told(const std::vector<std::string>& overrides = {}, std::string_view text = plain_case)
{
  std::string texts;
  try
  {
    for (const Warning& warning : parse_case(text, "case.toml", overrides).warnings)
      texts += warning.key == "bare_number" ? warning.text + "\n" : "";
  }
  catch (const InputError& error)
  {
    texts = error.what();
  }
  return texts;
}

void expect_in(const std::string& text, const std::string& part)
{
  EXPECT_NE(text.find(part), std::string::npos) << part << " is not in: " << text;
}

TEST(BareNumbers, InclusionsAreAskedFor)
{
  const auto of = [](const std::string& modulus)
  {
    return told({R"(lower.inclusion=[{type="ellipsoid", depth=1, size=1, poisson_ratio=0.25, young_modulus=)" +
                 modulus + "}]"});
  };
  expect_in(of("390"), "lower.inclusion[0].young_modulus = 390 is in Pa because it has no unit");
  expect_in(of("390"), "which is written \"390 GPa\"");
  expect_in(of("390000"), "which is written \"390000 MPa\"");
  EXPECT_EQ(of("390e9").find("inclusion[0].young_modulus"), std::string::npos);
}

TEST(BareNumbers, NewtonMillimetreMegapascalIsAskedFor)
{
  const std::string text = told();
  expect_in(text, "lower.material.young_modulus = 210000 is in Pa because it has no unit");
  expect_in(text, "it looks like MPa, which is written \"210000 MPa\"");
  expect_in(text, "lower.material.hardening.yield_stress = 600 is in Pa");
  expect_in(text, "lower.material.hardening.modulus = 2000 is in Pa");
  expect_in(text, "upper.shape.radius = 10 is in m because it has no unit");
  expect_in(text, "\"10 mm\". If SI is meant, the unit confirms it: \"10 m\"");
  EXPECT_EQ(text.find("load"), std::string::npos) << "newton is newton in both systems";
}

TEST(BareNumbers, AUnitConfirmsAnUnusualValue)
{
  EXPECT_EQ(told({"lower.material.young_modulus=0.21 MPa", "lower.material.hardening.yield_stress=600 Pa",
                  "lower.material.hardening.modulus=2 kPa", "upper.shape.radius=10 m", "indentation.load=[1e-3, 0]"}),
            "");
}

TEST(BareNumbers, ASmallRadiusIsDoubtfulBesideMegapascal)
{
  expect_in(told({"upper.shape.radius=0.5"}), "upper.shape.radius = 0.5 is in m");
  const std::vector<std::string> in_si{"lower.material.young_modulus=2.1e11",
                                       "lower.material.hardening.yield_stress=6e8",
                                       "lower.material.hardening.modulus=2e9", "upper.shape.radius=0.5"};
  EXPECT_EQ(told(in_si), "");
}

TEST(BareNumbers, EachKindOfKeyIsLookedAt)
{
  const std::vector<std::string> steel{"lower.material.young_modulus=210 GPa",
                                       "lower.material.hardening={law=\"perfect\", yield_stress=\"600 MPa\"}",
                                       "upper.shape.radius=10 mm"};
  const auto with = [&](const std::string& override)
  {
    std::vector<std::string> all = steel;
    all.push_back(override);
    return told(all);
  };
  EXPECT_EQ(told(steel), "");
  expect_in(with("lower.material.initial_stress={depth=[0, \"1 mm\"], value=[-200, 0]}"), "it looks like MPa");
  expect_in(with("lower.material.yield_profile={depth=[0, 0.3], factor=[1.5, 1]}"), "it looks like mm");
  expect_in(with("lower.material.hardening={law=\"voce\", yield_stress=\"600 MPa\", saturation=300, rate=10}"),
            "hardening.saturation = 300");
  expect_in(with("lower.material.hardening.back_stresses=[{modulus=90000, recall=600}]"),
            "back_stresses[0].modulus = 90000");
  EXPECT_EQ(told({"lower.material.young_modulus=70000"}).find("young_modulus"), std::string::npos)
      << "it has a warning";
  expect_in(told({"rolling.hertz_pressure=1500"}, case_template("rolling")), "1500");
}

TEST(BareNumbers, ShippedCasesAndTemplatesAreNotDoubted)
{
  int count = 0;
  for (const auto& folder : std::filesystem::directory_iterator(BRINELL_SOURCE_DIR "/cases"))
    if (const auto file = folder.path() / "case.toml"; std::filesystem::exists(file))
    {
      ++count;
      const Case c = read_case(file);
      for (const Warning& warning : c.warnings)
        EXPECT_NE(warning.key, "bare_number") << file << ": " << warning.text;
      // Resolved cases have plain numbers only.
      for (const Warning& warning : parse_case(resolved_text(c.values), file).warnings)
        EXPECT_NE(warning.key, "bare_number") << file << ": " << warning.text;
    }
  EXPECT_GT(count, 20);
  EXPECT_EQ(told({}, sample::case_text), "");
}

} // namespace
} // namespace brinell::io::bare_numbers_test
