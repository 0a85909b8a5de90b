// SPDX-License-Identifier: BSD-3-Clause
#include "program.hpp"

#include <cmath>
#include <numbers>

namespace brinell::cli::heat_source_test
{

namespace
{

class HeatSource : public Program
{
protected:
  /// A number of the summary.
  [[nodiscard]] double number(const std::string& key) const
  {
    const std::string text = file_text(folder() / "out/summary.json");
    const std::size_t at = text.find("\"" + key + "\":");
    return at == text.npos ? std::nan("") : std::stod(text.substr(at + key.size() + 3));
  }
};

// A ball at rest under a spot of 0.1 mm while a flat, which takes no heat, slides past; the first law, and q a/K within a twentieth
// when nearly all of the rise has come.
constexpr const char* spot = R"(scenario = "sliding"
[lower]
shape = {type = "flat"}
material = {rigid = true}
[upper]
shape = {type = "sphere", radius = "10 mm"}
[upper.material]
young_modulus = "200 GPa"
poisson_ratio = 0.3
thermal = {conductivity = 50, density = 7800, specific_heat = 470, expansion = 12e-6}
[sliding]
load = "20 N"
distance = "0.4 mm"
speed = "4 mm/s"
[thermal.source]
shape = "disc"
on = "upper"
flux = "20 W/mm^2"
radius = "0.1 mm"
[grid]
spacing = ["20 um", "20 um", "20 um"]
[output]
directory = "out"
)";

TEST_F(HeatSource, ASpotInACase)
{
  write("case.toml", spot);
  const Outcome outcome = run({"run", "case.toml", "--quiet"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NEAR(number("balance_error"), 0.0, 2e-2);
  EXPECT_NEAR(number("upper_J"), number("of_source_J"), 1e-8 * number("of_source_J"));
  const double power = 20e6 * std::numbers::pi * 1e-8;
  EXPECT_GT(number("of_source_J"), power * 0.4e-3 / 4e-3);
  const double rise = number("max_temperature_upper_degC") - 20.0;
  EXPECT_NEAR(rise, 20e6 * 0.1e-3 / 50.0, 0.05 * rise);
}

TEST_F(HeatSource, WhatIsNoSourceIsRefusedAtItsLine)
{
  write("case.toml", spot);
  const auto refused = [&](const std::string& setting, const std::string& part)
  {
    const Outcome outcome = run({"check", "case.toml", "--set", setting});
    EXPECT_EQ(outcome.exit_code, 2) << setting;
    EXPECT_NE(outcome.err.find(part), std::string::npos) << outcome.err;
  };
  refused("thermal.source.radius=\"-1 mm\"", "thermal.source.radius = \"-1 mm\" is out of range");
  refused("thermal.source.on=lower", "lower.material.thermal is missing: thermal.source heats this body");
  refused("thermal.regime=steady", "thermal.reference is missing: the upper body rests under its heat flux");
  refused("thermal.source.shape=rectangle", "thermal.source.length is missing");
  refused("sliding.speed=0", "sliding.speed = 0 is out of range");
}

} // namespace

} // namespace brinell::cli::heat_source_test
