// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/foundation/error.hpp"
#include "brinell/io/case_file.hpp"
#include "brinell/simulation/rolling.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

/// The table [interface]. What cannot be computed is refused with its line, its key and value, and what is allowed.
namespace brinell::io::friction_case_test
{

namespace
{

/// A case whose table [interface] has its first key in line 13.
std::string sample(const std::string& scenario, const std::string& interface)
{
  return "scenario = \"" + scenario.substr(0, scenario.find('\n')) + R"("
[lower]
shape = {type = "flat"}
material = {young_modulus = "200 GPa", poisson_ratio = 0.3}
[upper]
shape = {type = "sphere", radius = "10 mm"}
material = {young_modulus = "200 GPa", poisson_ratio = 0.3}
)" + scenario.substr(scenario.find('\n') + 1) +
         "[interface]\n" + interface + "\n";
}
const std::string rolling = "rolling\n[rolling]\nload = \"10 N\"\ndistance = \"1 mm\"\nslide_to_roll = 0.5\n";
const std::string pure_rolling = "rolling\n[rolling]\nload = \"10 N\"\ndistance = \"1 mm\"\nslide_to_roll = 0\n";
std::string creeping(const std::string& keys)
{
  return "rolling\n[rolling]\nload = \"10 N\"\ndistance = \"1 mm\"\n" + keys + "\n";
}
const std::string indentation = "indentation\n[indentation]\nload = [\"10 N\"]\nsteps = 2\ncycles = 1\n";

void expect_refused(const std::string& text, int line, const std::vector<std::string>& parts)
{
  std::string message = "not refused";
  try
  {
    static_cast<void>(parse_case(text, "sample.toml", {}));
  }
  catch (const InputError& error)
  {
    message = error.what();
  }
  EXPECT_EQ(message.rfind("sample.toml:" + std::to_string(line) + ": ", 0), 0u) << "line " << line << " of\n"
                                                                                << message;
  for (const std::string& part : parts)
    EXPECT_NE(message.find(part), std::string::npos) << part << "\n  in: " << message;
}

TEST(FrictionCase, WhatIsGoodIsRead)
{
  const auto read = [](const std::string& keys)
  { return std::get<simulation::RollingCase>(parse_case(sample(rolling, keys), "sample.toml", {}).scenario).friction; };
  EXPECT_EQ(read("friction = 0.25"), (elastoplastic::Friction{0.25, {}, true}));
  EXPECT_EQ(read("friction = 0.4\nshear_limit = \"300 MPa\"\ncoupling = false"),
            (elastoplastic::Friction{0.4, 300e6, false}));
  EXPECT_NO_THROW(static_cast<void>(parse_case(sample(pure_rolling, "friction = 0"), "sample.toml", {})));
}

TEST(FrictionCase, CreepageIsRead)
{
  const auto read = [](const std::string& keys)
  {
    const io::Case c = parse_case(sample(creeping(keys), "friction = 0.3"), "sample.toml", {});
    return std::get<simulation::RollingCase>(c.scenario).creepage;
  };
  using simulation::Creepage;
  EXPECT_EQ(read("creepage = 0.002"), (Creepage{0.002, 0.0, 0.0}));
  EXPECT_EQ(read("creepage = [\"0.2 %\", 0]"), (Creepage{0.002, 0.0, 0.0}));
  EXPECT_EQ(read("creepage = [0.002, -0.001]"), (Creepage{0.002, -0.001, 0.0}));
  EXPECT_EQ(read("creepage = [0.002, 0]\nspin = 3"), (Creepage{0.002, 0.0, 3.0}));
  EXPECT_EQ(read("spin = \"0.5 rad/mm\""), (Creepage{0.0, 0.0, 500.0}));
  EXPECT_EQ(read("creepage = [0, 0]"), Creepage{});
  EXPECT_EQ(read("slide_to_roll = 0.1"), std::nullopt);
}

TEST(FrictionCase, CreepageThatDoesNotFitIsRefused)
{
  const auto with = [](const std::string& keys) { return sample(creeping(keys), "friction = 0.3"); };
  expect_refused(with("creepage = [0.002, 0, 0.1]"), 11,
                 {"rolling.creepage", "more than two numbers; allowed: [longitudinal, lateral]"});
  expect_refused(with("creepage = [0.2, 0]"), 11, {"rolling.creepage", "[-0.1, 0.1]"});
  expect_refused(with("creepage = [nan, 0]"), 11, {"rolling.creepage"});
  expect_refused(with("spin = \"2 mm\""), 11, {"rolling.spin", "rad/m"});
  expect_refused(with("spin = \"2 rad\""), 11, {"rolling.spin", "rad"});
  expect_refused(with("spin = 1e6"), 11, {"rolling.spin = 1e+06 rad/m", "half-length"});
  expect_refused(sample(creeping("creepage = [0.002, 0]"), "friction = 0"), 11,
                 {"rolling.creepage", "interface.friction = 0"});
  expect_refused(with("slide_to_roll = 0.1\ncreepage = [0.002, 0]"), 12, {"rolling.creepage", "slide_to_roll = 0.1"});
}

TEST(FrictionCase, WhatIsBadIsRefused)
{
  expect_refused(sample(rolling, "friction = -0.1"), 13, {"interface.friction", "-0.1", ">= 0"});
  expect_refused(sample(rolling, "friction = 0.1\nshear_limit = 0"), 14, {"interface.shear_limit", "> 0"});
  expect_refused(sample(rolling, "friction = 0.1\ncoupling = 3"), 14, {"interface.coupling"});
  expect_refused(sample(pure_rolling, "friction = 0.1"), 13, {"interface.friction = 0.1", "slide_to_roll"});
  expect_refused(sample(indentation, "friction = 0.1"), 13, {"interface.friction", "indentation"});
  expect_refused(sample(rolling, "fricton = 0.1"), 13, {"interface.fricton", "interface.friction"});
}

} // namespace

} // namespace brinell::io::friction_case_test
