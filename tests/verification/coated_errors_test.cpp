// SPDX-License-Identifier: BSD-3-Clause
// The errors that are stated for coated bodies, against runs with finer cells.
#include "brinell/io/case_file.hpp"
#include "brinell/quality/quality.hpp"
#include "brinell/simulation/run.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>
#include <variant>
#include <vector>

namespace brinell::verification::coated_errors_test
{
namespace
{

using simulation::IndentationCase, simulation::IndentationSummary;

IndentationCase pressed(const std::string& layer, double cells)
{
  const std::string text = fmt::format(R"(scenario = "indentation"
[lower]
shape = {{type = "flat"}}
[lower.material]
young_modulus = "210 GPa"
poisson_ratio = 0.3
hardening = {{law = "linear", yield_stress = "2 GPa", modulus = "20 GPa"}}
layers = [{}]
[upper]
shape = {{type = "sphere", radius = "50 um"}}
material = {{young_modulus = "1140 GPa", poisson_ratio = 0.07}}
[indentation]
load = ["300 mN", 0]
steps = 12
[grid]
resolution = {}
)",
                                       layer, cells);
  return std::get<IndentationCase>(io::parse_case(text, "coated.toml").scenario);
}

std::map<std::string, double> numbers(const IndentationSummary& summary)
{
  const simulation::Indent& indent = summary.indents.front();
  return {{"residual depth", indent.residual_depth},
          {"hardness", indent.hardness},
          {"pile-up", indent.pile_up},
          {"loading stiffness", indent.loading_stiffness},
          {"unloading stiffness", indent.unloading_stiffness},
          {"largest plastic strain", summary.max_equivalent_plastic_strain}};
}

class CoatedErrors : public testing::TestWithParam<const char*>
{
};

TEST_P(CoatedErrors, HoldAgainstFinerCells)
{
  const std::map<std::string, double> finer = numbers(simulation::run(pressed(GetParam(), 24)));
  const IndentationCase c = pressed(GetParam(), 10);
  const IndentationSummary summary = simulation::run(c);
  const std::map<std::string, double> coarse = numbers(summary);
  int held = 0;
  for (const quality::ExpectedError& stated :
       quality::judged(c, simulation::plan(c), summary).resolution.expected_errors)
    if (const auto found = coarse.find(stated.quantity); found != coarse.end())
    {
      const double error = found->second / finer.at(stated.quantity) - 1.0;
      EXPECT_LT(std::abs(error), stated.relative) << stated.quantity;
      std::printf("%-24s %6.2f %% of %5.2f %% stated\n", stated.quantity.c_str(), 100.0 * error,
                  100.0 * stated.relative);
      ++held;
    }
  EXPECT_EQ(held, 6);
}

INSTANTIATE_TEST_SUITE_P(
    Coats, CoatedErrors,
    testing::Values(
        // hard and soft, thick and thin; the error of the pile-up is largest for soft ones
        R"({thickness = "1 um", young_modulus = "400 GPa", poisson_ratio = 0.25, hardening = {law = "linear", yield_stress = "8 GPa", modulus = "10 GPa"}})",
        R"({thickness = "1 um", young_modulus = "60 GPa", poisson_ratio = 0.25, hardening = {law = "linear", yield_stress = "500 MPa", modulus = "10 GPa"}})",
        R"({thickness = "2 um", young_modulus = "120 GPa", poisson_ratio = 0.25, hardening = {law = "linear", yield_stress = "1 GPa", modulus = "10 GPa"}})"));

} // namespace
} // namespace brinell::verification::coated_errors_test
