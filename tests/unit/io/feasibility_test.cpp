// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/foundation/error.hpp"
#include "brinell/io/feasibility.hpp"
#include "sample.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace brinell::io::feasibility_test
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

// The indices of such a grid do not even fit into an int.
TEST(Feasibility, RefusesAbsurdGrids)
{
  for (const auto& [spacing, reason] : {std::pair{"[1e-9, 1e-9, 1e-300]", "are too small for a contact of"},
                                        {"[1e-6, 1e-6, 1e-6]", "allowed: fewer than"}})
    try
    {
      static_cast<void>(sample::parsed({std::string("grid.spacing=") + spacing}));
      FAIL() << spacing;
    }
    catch (const InputError& error)
    {
      const std::string text = error.what();
      EXPECT_NE(text.find(reason), text.npos) << text;
      EXPECT_NE(text.find("grid.spacing = "), text.npos) << text;
    }
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

std::string result_line(const std::string& snapshots)
{
  const Case c = sample::parsed({"tugging.passes=2", "output.snapshots=" + snapshots});
  const std::string report = check_report(c, plan_case(c));
  const auto begin = report.find("# Result: ");
  return begin == report.npos ? "" : report.substr(begin, report.find('\n', begin) - begin);
}

TEST(Feasibility, TellsTheSizeOfTheResult)
{
  const Case c = sample::parsed({"tugging.passes=2"});
  const auto plan = std::get<simulation::TuggingPlan>(plan_case(c));
  const double numbers = 2.0 * static_cast<double>(plan.contact.size()) +
                         14.0 * static_cast<double>(plan.lower.size() + plan.upper.size()) +
                         static_cast<double>(plan.lower.surface.size() + plan.upper.surface.size());
  const double megabytes = 8e-6 * numbers; // of one state
  const auto expected = [&](int steps)
  {
    return fmt::format("# Result: {} stored step{} and the final state, {:.3g} MB before compression", steps,
                       steps == 1 ? "" : "s", (steps + 1) * megabytes);
  };
  ASSERT_LT(4 * megabytes, 1e3);
  EXPECT_EQ(result_line("none"), expected(0));
  EXPECT_EQ(result_line("[3]"), expected(1));
  EXPECT_EQ(result_line("[3, 1000000]"), expected(1)) << "there is no such step";
  EXPECT_EQ(result_line("aligned"), expected(2)) << "one in each pass";
  EXPECT_EQ(result_line(fmt::format("every {}", plan.steps / 2)), expected(plan.steps % 2 == 0 ? 2 : 3));
  EXPECT_EQ(result_line("all").rfind(fmt::format("# Result: {} stored steps", plan.steps), 0), 0u);
}

} // namespace

} // namespace brinell::io::feasibility_test
