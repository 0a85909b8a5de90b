// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/foundation/error.hpp"
#include "brinell/io/case_file.hpp"

#include <gtest/gtest.h>

#include <string>

namespace brinell::io::fatigue_case_test
{
namespace
{

constexpr const char* ball = R"(
scenario = "rolling"
[rolling]
hertz_pressure = "1 GPa"
distance = "1 mm"
[lower]
shape = { type = "flat" }
[lower.material]
young_modulus = "210 GPa"
poisson_ratio = 0.3
[upper]
shape = { type = "sphere", radius = "10 mm" }
material = { young_modulus = "210 GPa", poisson_ratio = 0.3 }
)";

Case parsed(const std::string& fatigue)
{
  return parse_case(std::string(ball) + fatigue, "case.toml");
}

const simulation::RollingCase& rolling(const Case& c)
{
  return std::get<simulation::RollingCase>(c.scenario);
}

std::string error_of(const std::string& fatigue)
{
  try
  {
    static_cast<void>(parsed(fatigue));
  }
  catch (const InputError& error)
  {
    return error.what();
  }
  return {};
}

TEST(FatigueCase, IsComputedOnRequestOnly)
{
  EXPECT_FALSE(rolling(parsed("")).lower.fatigue);
  const Case c = parsed("[lower.material.fatigue]\ncriterion = \"dang_van\"\ntorsion_limit = \"400 MPa\"\n"
                        "bending_limit = \"600 MPa\"\nshear_threshold = \"100 MPa\"\n");
  const auto& fatigue = rolling(c).lower.fatigue;
  ASSERT_TRUE(fatigue);
  EXPECT_EQ(fatigue->criterion, constitutive::Fatigue::Criterion::dang_van);
  EXPECT_EQ(fatigue->torsion_limit, 400e6);
  EXPECT_EQ(fatigue->bending_limit, 600e6);
  EXPECT_EQ(fatigue->threshold, 100e6);
  EXPECT_DOUBLE_EQ(fatigue->stress_exponent, 31.0 / 3.0);
  EXPECT_DOUBLE_EQ(fatigue->weibull_slope, 10.0 / 9.0);
  EXPECT_DOUBLE_EQ(fatigue->depth_exponent, 7.0 / 3.0);
  EXPECT_FALSE(rolling(c).upper.fatigue);
}

TEST(FatigueCase, OfLifeAloneNeedsNoLimits)
{
  EXPECT_EQ(rolling(parsed("[lower.material.fatigue]\ncriterion = \"none\"\nweibull_slope = 1.125\n"))
                .lower.fatigue->weibull_slope,
            1.125);
}

TEST(FatigueCase, NamesWhatDoesNotFit)
{
  const std::string missing =
      error_of("[lower.material.fatigue]\ncriterion = \"findley\"\ntorsion_limit = \"400 MPa\"\n");
  EXPECT_NE(missing.find("lower.material.fatigue.bending_limit is missing"), std::string::npos) << missing;
  const std::string ratio =
      error_of("[lower.material.fatigue]\ncriterion = \"crossland\"\ntorsion_limit = \"300 MPa\"\n"
               "bending_limit = \"600 MPa\"\n");
  EXPECT_NE(ratio.find("case.toml:16"), std::string::npos) << ratio;
  EXPECT_NE(ratio.find("torsion_limit = 3e+08 Pa does not fit"), std::string::npos) << ratio;
  EXPECT_NE(ratio.find("0.5774"), std::string::npos) << ratio;
  EXPECT_NE(error_of("[lower.material.fatigue]\ntorsion_limit = \"300 MPa\"\n").find("criterion"), std::string::npos);
  EXPECT_NE(error_of("[lower.material.fatigue]\ncriterion = \"walker\"\n").find("dang_van"), std::string::npos);
}

} // namespace
} // namespace brinell::io::fatigue_case_test
