// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/foundation/error.hpp"
#include "brinell/io/feasibility.hpp"
#include "sample.hpp"

#include <gtest/gtest.h>

namespace brinell::io
{

namespace
{

std::string refusal(const Case& c, double memory)
{
  try
  {
    (void)plan_case(c, memory);
  }
  catch (const InputError& error)
  {
    return error.what();
  }
  return "";
}

TEST(Feasibility, RefusesWhatDoesNotFit)
{
  const std::string text = refusal(sample::parsed(), 1e4);
  EXPECT_EQ(text.rfind("sample.toml:12: grid.spacing = [\"3.85 mm\", \"7.7 mm\", \"1.925 mm\"] needs ", 0), 0u) << text;
  EXPECT_NE(text.find("10 kB"), text.npos) << text;
  EXPECT_EQ(refusal(sample::parsed(), 1e12), "");
}

// The indices of such a grid do not even fit into an int, so the planner must not be asked.
TEST(Feasibility, RefusesAbsurdGrids)
{
  const std::string text = refusal(sample::parsed({"grid.spacing=[1e-9, 1e-9, 1e-300]"}), 1e300);
  EXPECT_NE(text.find("cells; allowed: larger cells"), text.npos) << text;
}

TEST(Feasibility, NamesTheDefaultResolution)
{
  const std::string text(sample::case_text);
  const Case c = parse_case(text.substr(0, text.find("[grid]")), "sample.toml");
  const std::string refused = refusal(c, 1e4);
  EXPECT_NE(refused.find("grid.resolution = "), refused.npos) << refused;
  EXPECT_NE(refused.find("(the default)"), refused.npos) << refused;
}

TEST(Feasibility, MachineHasMemory)
{
  EXPECT_GT(machine_memory(), 1e8);
}

TEST(Feasibility, ReportIsACaseFile)
{
  const Case c = sample::parsed();
  const std::string report = check_report(c, plan_case(c));
  EXPECT_EQ(parse_case(report, "report.toml").values.all(), c.values.all());
  for (const char* fragment :
       {"alpha_c = ", "P_c = ", "steps per pass", "lower body", "of memory", "the lower body yields first"})
    EXPECT_NE(report.find(fragment), report.npos) << fragment;
}

} // namespace

} // namespace brinell::io
