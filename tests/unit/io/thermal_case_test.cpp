// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/foundation/error.hpp"
#include "brinell/io/case_file.hpp"
#include "brinell/io/case_template.hpp"
#include "sample.hpp"

#include <gtest/gtest.h>

#include <algorithm>

/// What a material has to do with heat, as it stands in a case file.
namespace brinell::io::thermal_case_test
{
namespace
{

const std::string steel = R"x(conductivity = "50 W/(m K)", density = "7.85 g/cm^3", specific_heat = "0.46 kJ/kg/K", )x"
                          R"(expansion = "12 um/m/K")";

Case with(const std::string& keys, const std::string& body = "lower")
{
  return sample::parsed({body + ".material.thermal={" + keys + "}"});
}

std::string message(const std::string& keys, const std::string& body = "lower")
{
  try
  {
    (void)with(keys, body);
  }
  catch (const InputError& error)
  {
    return error.what();
  }
  return "no error";
}

void expect_message(const std::string& keys, const std::string& part)
{
  EXPECT_NE(message(keys).find(part), std::string::npos) << part << " is not in: " << message(keys);
}

bool warns(const Case& c, const std::string& code)
{
  return std::any_of(c.warnings.begin(), c.warnings.end(), [&](const Warning& w) { return w.key == code; });
}

TEST(ThermalCase, ConstantsAreReadInSI)
{
  const auto material = sample::tugging(with(steel + R"(, temperature = "373.15 K")")).lower.material;
  EXPECT_EQ(material.thermal, (Thermal{50.0, 7850.0, 460.0, 12e-6}));
  EXPECT_DOUBLE_EQ(material.temperature, 100.0);
  EXPECT_DOUBLE_EQ(sample::tugging(with(steel)).lower.material.temperature, 20.0);
  EXPECT_DOUBLE_EQ(sample::tugging(with(steel + ", temperature = \"-40 degC\"")).lower.material.temperature, -40.0);
  EXPECT_DOUBLE_EQ(sample::tugging(with(steel + ", temperature = 150")).lower.material.temperature, 150.0);
  EXPECT_FALSE(sample::tugging(sample::parsed({})).lower.material.thermal);
}

TEST(ThermalCase, TheResolvedCaseIsTheSame)
{
  const Case c = with(steel + R"(, temperature = "300 K")");
  const Case again = parse_case(resolved_text(c.values), "resolved.toml");
  EXPECT_EQ(sample::tugging(again).lower.material, sample::tugging(c).lower.material);
  EXPECT_NE(resolved_text(c.values).find("degC"), std::string::npos);
}

TEST(ThermalCase, ARigidBodyConductsButDoesNotSwell)
{
  const auto rigid = [](const std::string& keys) {
    return sample::parsed({"upper.material.rigid=true", "upper.material.thermal={" + keys + "}"});
  };
  const auto material = sample::tugging(rigid("conductivity = 30, density = 3200, specific_heat = 700")).upper.material;
  EXPECT_TRUE(material.elastic.is_rigid());
  EXPECT_EQ(material.thermal, (Thermal{30.0, 3200.0, 700.0, 0.0}));
  EXPECT_THROW((void)rigid("conductivity = 30, density = 3200, specific_heat = 700, expansion = 3e-6"), InputError);
}

TEST(ThermalCase, BadConstantsNameTheKeyAndWhatIsAllowed)
{
  expect_message("conductivity = 0", "lower.material.thermal.conductivity = 0 is out of range");
  expect_message("conductivity = 0", "a steel has 15 to 60 W/(m K)");
  expect_message("density = -1", "lower.material.thermal.density = -1 is out of range; allowed: density > 0");
  expect_message("specific_heat = 0", "specific_heat = 0 is out of range");
  expect_message("expansion = 12",
                 "expansion = 12 is out of range; allowed: thermal expansion in [-0.001, 0.001], in 1/K");
  expect_message("expansion = nan", "is not a finite number");
  expect_message("conductivity = \"50 W\"", "is a power; allowed: thermal conductivity > 0");
  expect_message("temperature = -300", "temperature = -300 is out of range; allowed: temperature > -273.15, in degC");
  expect_message("temperature = \"0 K\"", "is out of range");
  expect_message("temperature = \"20 K\"", "conductivity is missing");
  expect_message("temperature = \"68 degF\"", "allowed: a number in degC, or text as in \"20 degC\" or \"293.15 K\"");
  expect_message("temperature = \"20\"", "is not a temperature");
  expect_message("conductivity = 50, density = 7850, expansion = 0", "lower.material.thermal.specific_heat is missing; "
                                                                     "allowed: specific heat > 0, in J/(kg K)");
}

TEST(ThermalCase, WarnsOfWhatIsSeldomMeant)
{
  EXPECT_FALSE(warns(with(steel), "unusual_thermal"));
  EXPECT_TRUE(warns(with("conductivity = 50, density = 7.85, specific_heat = 460, expansion = 0"), "unusual_thermal"));
  EXPECT_TRUE(warns(with(steel + ", temperature = 293.15"), "hot_bulk"));
  EXPECT_FALSE(warns(with(steel + ", temperature = \"293.15 degC\""), "hot_bulk"));
  EXPECT_FALSE(warns(with(steel + ", temperature = 120"), "hot_bulk"));
}

TEST(ThermalCase, FrictionHeatsWhereThereIsASpeed)
{
  const std::string lower = "lower.material.thermal={" + steel + "}", upper = "upper.material.thermal={" + steel + "}";
  const std::string friction = "interface.friction=0.1", speed = "tugging.speed=\"3 m/s\"";
  const Case c = sample::parsed({lower, upper, friction, speed, "interface.heat_fraction=0.9", "thermal.partition=0.3",
                                 "thermal.displacement=false", "thermal.stress=false"});
  const simulation::TuggingCase& t = sample::tugging(c);
  EXPECT_EQ(t.speed, 3.0);
  elastoplastic::HeatSettings expected{.fraction = 0.9, .partition = 0.3, .displacement = false, .stress = false};
  EXPECT_EQ(t.heat, expected);
  EXPECT_FALSE(warns(c, "no_heat"));
  EXPECT_EQ(sample::tugging(sample::parsed({})).heat, elastoplastic::HeatSettings{});
  const std::vector<std::string> steady{lower,
                                        upper,
                                        friction,
                                        speed,
                                        "thermal.conductance=\"3 W/(cm^2 K)\"",
                                        "thermal.regime=\"steady\"",
                                        "thermal.heat_of_plastic_work=0",
                                        "thermal.reference=\"20 mm\"",
                                        "lower.material.softening={law=\"linear\",melting_temperature=1500}"};
  expected = {
      .of_plastic_work = 0.0, .conductance = 3e4, .regime = elastoplastic::HeatRegime::steady, .reference = 0.02};
  EXPECT_EQ(sample::tugging(sample::parsed(steady)).heat, expected);

  const auto refused = [](const std::vector<std::string>& overrides, const std::string& part)
  {
    std::string message = "not refused";
    try
    {
      (void)sample::parsed(overrides);
    }
    catch (const InputError& error)
    {
      message = error.what();
    }
    EXPECT_NE(message.find(part), std::string::npos) << part << " is not in: " << message;
  };
  refused({lower, upper, friction}, "tugging.speed is missing");
  refused({lower, friction, speed}, "upper.material.thermal is missing");
  refused({lower, upper, friction, "tugging.speed=0"}, "tugging.speed = 0 is out of range");
  refused({lower, upper, friction, speed, "thermal.partition=1.5"}, "thermal.partition = 1.5 is out of range");
  refused({lower, upper, friction, speed, "thermal.conductance=-1"}, "thermal.conductance = -1 is out of range");
  refused({lower, upper, friction, speed, "thermal.regime=\"steady\""},
          "allowed: thermal.heat_of_plastic_work = 0, or \"transient\"");
  refused({lower, upper, friction, speed, "thermal.reference=0"}, "thermal.reference = 0 is out of range");
  refused({lower, upper, friction, speed, "thermal.heat_of_plastic_work=1.5"},
          "thermal.heat_of_plastic_work = 1.5 is out of range");
  refused({lower, upper, friction, speed, "lower.material.softening={law=\"linear\",melting_temperature=60}",
           "lower.material.thermal.temperature=80"},
          "lower.material.thermal.temperature = 80 degC, but by its softening law the body melts at 60 degC");
  const std::string rigid = "upper.material={rigid=true}";
  refused({lower, rigid, friction, speed, "thermal.partition=0.5"},
          "thermal.partition = 0.5, but the upper body has no thermal constants");
  refused({lower, rigid, friction, speed, "thermal.conductance=1e4"},
          "thermal.conductance = 10000, but the upper body has no thermal constants");
  refused({lower, upper, friction, speed, "thermal.at_melting=\"wait\""}, "thermal.at_melting");
  refused({lower, upper, friction, speed, "interface.heat_fraction=-1"},
          "interface.heat_fraction = -1 is out of range");
}

TEST(ThermalCase, SlipHeatsWhereThereIsAPace)
{
  const std::string heat = "lower.material.thermal={" + steel + "}", upper = "upper.material.thermal={" + steel + "}";
  const auto parsed = [&](const std::string& scenario, std::vector<std::string> overrides)
  {
    overrides.insert(overrides.end(), {heat, upper, "interface.friction=0.3"});
    return parse_case(case_template(scenario), "case.toml", overrides);
  };
  const Case fretting = parsed("fretting", {"fretting.frequency=\"2 kHz\""});
  EXPECT_EQ(std::get<simulation::FrettingCase>(fretting.scenario).frequency, 2000.0);
  EXPECT_FALSE(warns(fretting, "no_heat"));
  EXPECT_TRUE(warns(parse_case(case_template("fretting"), "case.toml", {"fretting.frequency=10"}), "no_heat"));
  const Case creeping = parsed("rolling", {"rolling.creepage=0.002", "rolling.speed=1"});
  EXPECT_FALSE(warns(creeping, "no_heat"));

  const auto refused =
      [&](const std::string& scenario, const std::vector<std::string>& overrides, const std::string& part)
  {
    std::string message = "not refused";
    try
    {
      (void)parsed(scenario, overrides);
    }
    catch (const InputError& error)
    {
      message = error.what();
    }
    EXPECT_NE(message.find(part), std::string::npos) << part << " is not in: " << message;
  };
  refused("fretting", {}, "allowed: a frequency > 0, as \"1 Hz\"");
  refused("fretting", {"fretting.frequency=-1"}, "fretting.frequency = -1 is out of range");
  refused("fretting", {"fretting.frequency=\"1 s\""}, "frequency");
  refused("fretting", {"fretting.frequency=1", "thermal.regime=\"steady\""}, "where they stick in places");
  refused("rolling", {"rolling.creepage=0.002"}, "rolling.speed is missing");
  refused("rolling", {"rolling.creepage=0.002", "rolling.speed=1", "thermal.regime=\"steady\""},
          "where they stick in places");
}

TEST(ThermalCase, WarnsOfConstantsThatNothingUses)
{
  EXPECT_TRUE(warns(sample::parsed({"tugging.speed=1"}), "no_heat"));
  EXPECT_TRUE(warns(with(steel), "no_heat"));
  EXPECT_TRUE(warns(with(steel, "upper"), "no_heat"));
  EXPECT_FALSE(warns(sample::parsed({}), "no_heat"));
}

constitutive::Material softened(const std::string& keys)
{
  return sample::tugging(sample::parsed({"lower.material.softening={" + keys + "}"})).lower.material;
}

TEST(SofteningCase, EveryLawIsRead)
{
  using namespace constitutive;
  EXPECT_FALSE(sample::tugging(sample::parsed({})).lower.material.softening);
  EXPECT_EQ(*softened(R"(law = "linear", melting_temperature = 1500)").softening,
            SofteningLaw(LinearSoftening{20.0, 1500.0}));
  EXPECT_EQ(
      *softened(
           R"(law = "johnson_cook", reference_temperature = "25 degC", melting_temperature = 1520, exponent = 1.03)")
           .softening,
      SofteningLaw(JohnsonCookSoftening{25.0, 1520.0, 1.03}));
  EXPECT_EQ(*softened(R"(law = "table", temperature = [20, "300 degC"], factor = [1, 0.8])").softening,
            SofteningLaw(TabulatedSoftening({20.0, 300.0}, {1.0, 0.8})));
  const Case c =
      sample::parsed({R"(lower.material.softening={law = "table", temperature = [20, 300], factor = [1, 0.8]})"});
  EXPECT_EQ(sample::tugging(parse_case(resolved_text(c.values), "again.toml")).lower.material,
            sample::tugging(c).lower.material);
  EXPECT_TRUE(warns(c, "no_heat"));
}

TEST(SofteningCase, WhatIsNoLawIsRefused)
{
  const auto refused = [](const std::string& keys, const std::string& part)
  {
    try
    {
      (void)softened(keys);
      FAIL() << keys;
    }
    catch (const InputError& error)
    {
      EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
    }
  };
  refused(R"(law = "linear")", "softening.melting_temperature is missing; allowed: temperature > -273.15, in degC");
  refused(R"(law = "linear", melting_temperature = 20)",
          "melting_temperature = 20 degC is not above reference_temperature = 20 degC");
  refused(R"(law = "johnson_cook", melting_temperature = 1500, exponent = 0)", "exponent = 0 is out of range");
  refused(R"(law = "linear", melting_temperature = 1500, exponent = 1)", "applies only with");
  refused(R"(law = "table", temperature = [20, 10], factor = [1, 1])", "must ascend");
  refused(R"(law = "table", temperature = [20], factor = [1, 1])", "1 temperatures and 2 factors");
  refused(R"(law = "table", temperature = [20], factor = [0])", "element 0, which is out of range");
  refused(R"(law = "melts")", "\"linear\", \"johnson_cook\" or \"table\"");
  refused("melting_temperature = 1500", "applies only with lower.material.softening.law");
}

TEST(ThermalCase, ASourceOfHeat)
{
  using elastoplastic::HeatSource;
  const std::string lower = "lower.material.thermal={" + steel + "}", upper = "upper.material.thermal={" + steel + "}";
  const std::string speed = "tugging.speed=\"3 m/s\"", disc = "thermal.source={shape=\"disc\", on=\"upper\", ";
  const Case c = sample::parsed({lower, upper, speed, disc + "power=\"2 W\", radius=\"50 um\", offset=\"-20 um\"}"});
  const HeatSource expected{
      .shape = HeatSource::Shape::disc, .on = HeatSource::Side::upper, .power = 2.0, .radius = 50e-6, .offset = -20e-6};
  EXPECT_EQ(sample::tugging(c).heat.source, expected);
  EXPECT_FALSE(warns(c, "no_heat"));
  const auto refused = [&](const std::string& source, const std::string& part, const std::vector<std::string>& others)
  {
    std::vector<std::string> overrides = others;
    overrides.push_back(source);
    try
    {
      static_cast<void>(sample::parsed(overrides));
      ADD_FAILURE() << "not refused: " << source;
    }
    catch (const InputError& error)
    {
      EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
    }
  };
  const std::vector<std::string> both{lower, upper, speed};
  refused(disc + "power=2, radius=-1}", "thermal.source.radius = -1 is out of range", both);
  refused(disc + "power=2}", "thermal.source.radius is missing", both);
  refused(disc + "radius=\"50 um\"}", "thermal.source.power is missing", both);
  refused(disc + "power=2, flux=1e6, radius=\"50 um\"}", "cannot stand together with thermal.source.flux", both);
  refused(disc + "power=\"2 N\", radius=\"50 um\"}", "allowed: power > 0, in W", both);
  refused(disc + "power=2, radius=\"50 um\", length=1}", "thermal.source.length = 1 applies only with", both);
  refused("thermal.source={shape=\"rectangle\", power=2, length=\"50 um\"}", "thermal.source.width is missing", both);
  refused("thermal.source={shape=\"contact\", flux=2}", "applies only with thermal.source.shape", both);
  refused("thermal.source={shape=\"ring\", power=2}", "thermal.source.shape = \"ring\"", both);
  refused("thermal.source={shape=\"contact\", power=2}", "with a heat source and the thermal constants",
          {lower, upper});
  refused(disc + "power=2, radius=\"50 um\"}", "upper.material.thermal is missing: thermal.source heats this body",
          {lower, speed, "upper.material.rigid=true"});
  refused("thermal.source={shape=\"contact\", power=2}", "lower.material.thermal is missing", {speed});
}

} // namespace
} // namespace brinell::io::thermal_case_test
