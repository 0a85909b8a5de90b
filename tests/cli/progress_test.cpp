// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/progress.hpp"

#include <gtest/gtest.h>

namespace brinell::app::progress_test
{

namespace
{

constexpr const char* text = "step 3/40  approach 1.868e-06 m  load 1.162e+01 N  12 of them  1 min 53 s left";

TEST(ProgressLine, LeavesOutTheLeastImportantPartsFirst)
{
  EXPECT_EQ(progress_line(0.5, text, 79),
            "[#####.....] step 3/40  approach 1.868e-06 m  load 1.162e+01 N  1 min 53 s left");
  EXPECT_EQ(progress_line(0.5, text, 60), "[####.....] step 3/40  approach 1.868e-06 m  1 min 53 s left");
  EXPECT_EQ(progress_line(0.5, text, 40), "[#####......] step 3/40  1 min 53 s left");
}

TEST(ProgressLine, NeverCutsTheTimeLeft)
{
  constexpr std::string_view left = "1 min 53 s left";
  for (std::size_t width = left.size(); width < 140; ++width)
  {
    const std::string line = progress_line(0.3, text, width);
    EXPECT_LE(line.size(), width);
    EXPECT_TRUE(line.ends_with(left)) << line;
  }
}

TEST(ProgressLine, HasALongBarWhereThereIsRoom)
{
  EXPECT_EQ(progress_line(1.0, "step 1/1", 200), "[########################] step 1/1");
}

} // namespace

} // namespace brinell::app::progress_test
