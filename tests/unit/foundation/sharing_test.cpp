// SPDX-License-Identifier: BSD-3-Clause
#include "foundation/sharing.hpp"

#include <gtest/gtest.h>

#include <array>
#include <stdexcept>

namespace brinell::sharing_test
{
namespace
{

TEST(SharingTest, SideBySideDoesBothAndSharesNothingWithin)
{
  std::array<int, 2> done{}, team{};
  side_by_side(
      [&](std::size_t i)
      {
        ++done[i];
#pragma omp parallel num_threads(3)
#pragma omp single
        team[i] = omp_get_num_threads();
      });
  EXPECT_EQ(done, (std::array{1, 1}));
  EXPECT_EQ(team, (std::array{1, 1}));
}

TEST(SharingTest, SideBySidePassesTheFirstExceptionOnAfterBothAreDone)
{
  for (const std::size_t failing : {std::size_t{0}, std::size_t{1}})
  {
    std::array<int, 2> done{};
    const auto work = [&](std::size_t i)
    {
      ++done[i];
      if (i >= failing)
        throw std::runtime_error(i == 0 ? "first" : "second");
    };
    try
    {
      side_by_side(work);
      FAIL() << "no exception";
    }
    catch (const std::runtime_error& error)
    {
      EXPECT_STREQ(error.what(), failing == 0 ? "first" : "second");
    }
    EXPECT_EQ(done, (std::array{1, 1}));
  }
}

} // namespace
} // namespace brinell::sharing_test
