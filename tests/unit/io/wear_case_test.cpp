// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/foundation/error.hpp"
#include "brinell/io/case_file.hpp"

#include <gtest/gtest.h>

#include <string>

/// Wear as it stands in a case file.
namespace brinell::io::wear_case_test
{
namespace
{

using elastoplastic::WearLaw;

constexpr std::string_view case_text = R"(scenario = "sliding"
[lower]
shape = {type = "flat"}
material = {young_modulus = "200 GPa", poisson_ratio = 0.3}
[upper]
shape = {type = "sphere", radius = "10 mm"}
material = {rigid = true}
[sliding]
load = "10 N"
distance = "0.1 mm"
[interface]
)";

Case with(const std::string& keys)
{
  return parse_case(std::string(case_text) + keys, "sample.toml");
}

const simulation::SlidingCase& sliding(const Case& c)
{
  return std::get<simulation::SlidingCase>(c.scenario);
}

void expect_message(const std::string& keys, const std::string& part)
{
  try
  {
    (void)with(keys);
    ADD_FAILURE() << "not refused: " << keys;
  }
  catch (const InputError& error)
  {
    EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << part << " is not in: " << error.what();
  }
}

TEST(WearCase, IsReadInSI)
{
  const Case c = with("wear = {lower = \"1e-6 mm^3/(N m)\", upper = 2e-15, law = \"energy\"}\nfriction = 0.1");
  EXPECT_EQ(sliding(c).wear, (WearLaw{1e-15, 2e-15, WearLaw::Kind::energy}));
  EXPECT_EQ(sliding(with("")).wear, WearLaw{});
  EXPECT_EQ(sliding(with("wear = {upper = \"1e-15 1/Pa\"}")).wear, (WearLaw{0.0, 1e-15, WearLaw::Kind::archard}));
  const Case again = parse_case(resolved_text(c.values), "resolved.toml");
  EXPECT_EQ(sliding(again).wear, sliding(c).wear);
}

TEST(WearCase, BadInputNamesTheKeyAndWhatIsAllowed)
{
  expect_message("wear = {lower = -1e-15}",
                 "interface.wear.lower = -1e-15 is out of range; allowed: wear coefficient >= 0, in 1/Pa");
  expect_message("wear = {upper = \"1e-6 mm^3\"}", "interface.wear.upper");
  expect_message("wear = {upper = \"1e-6 mm^3/(N m\"}", "unknown unit");
  expect_message("wear = {upper = 1e-15, law = \"holm\"}", "archard");
  expect_message("wear = {upper = 1e-15, law = \"energy\"}", "interface.friction = 0");
  expect_message("wear = {middle = 1e-15}", "interface.wear.middle");
}

TEST(WearCase, OfAnotherScenarioIsTold)
{
  std::string text(case_text);
  text.replace(text.find("sliding"), 7, "indentation");
  text.replace(text.find("[sliding]"), std::string::npos, "[indentation]\nload = \"10 N\"\n[interface]\n");
  try
  {
    (void)parse_case(text + "wear = {lower = 1e-15}", "sample.toml");
    ADD_FAILURE();
  }
  catch (const InputError& error)
  {
    EXPECT_NE(std::string(error.what()).find("interface.wear.lower"), std::string::npos) << error.what();
  }
}

TEST(WearCase, WarnsOfACoefficientThatNoSolidHas)
{
  EXPECT_TRUE(with("wear = {lower = 1e-15}").warnings.empty());
  const Case c = with("wear = {lower = 1e-6}");
  ASSERT_FALSE(c.warnings.empty());
  EXPECT_EQ(c.warnings.front().key, "unusual_wear");
}

} // namespace
} // namespace brinell::io::wear_case_test
