// SPDX-License-Identifier: BSD-3-Clause
#include "io/results/case_difference.hpp"

#include <gtest/gtest.h>

namespace brinell::io::case_difference_test
{

namespace
{

constexpr const char* resolved = R"(scenario = "rolling"

[lower]
[[lower.texture]]
depth = 1e-06 # m

[[lower.texture]]
depth = 2e-06 # m
heights = [1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0, 10.0, 11.0, 12.0, 13.0] # m

[grid]
resolution = 5.0
extent = 1.0
)";

std::string with(std::string text, const std::string& what, const std::string& by)
{
  return text.replace(text.find(what), what.size(), by);
}

TEST(CaseDifference, NoneOfTheSameCaseAndNoneOfTheFirstExtent)
{
  EXPECT_EQ(case_difference(resolved, resolved), "");
  EXPECT_EQ(case_difference(resolved, with(resolved, "extent = 1.0", "extent = 2.0")), "");
  EXPECT_EQ(case_difference(resolved, std::string(resolved) + "[output]\ncheckpoint_interval = 5.0\n"), "");
}

TEST(CaseDifference, NamesKeysWithBothValues)
{
  EXPECT_EQ(case_difference(resolved, with(resolved, "resolution = 5.0", "resolution = 6.0")),
            "grid.resolution = 5.0 there, 6.0 here");
  EXPECT_EQ(case_difference(resolved, with(resolved, "depth = 2e-06 # m", "depth = 3e-06 # m")),
            "lower.texture[1].depth = 2e-06 there, 3e-06 here");
  EXPECT_EQ(case_difference(resolved, with(resolved, "resolution = 5.0\n", "spacing = [1.0, 1.0, 1.0] # m\n")),
            "grid.resolution = 5.0 there, not set here; grid.spacing = not set there, [1.0, 1.0, 1.0] here");
}

TEST(CaseDifference, IsShort)
{
  EXPECT_EQ(case_difference(resolved, with(resolved, "heights = [1.0", "heights = [1.5")),
            "lower.texture[1].heights = [1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0, 10.0, 11.0,... there, "
            "[1.5, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0, 10.0, 11.0,... here");
  EXPECT_NE(case_difference("a = 1\nb = 1\nc = 1\nd = 1\ne = 1\nf = 1\n", "").find("; and 2 more"), std::string::npos);
}

} // namespace

} // namespace brinell::io::case_difference_test
