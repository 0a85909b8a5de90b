// SPDX-License-Identifier: BSD-3-Clause
#include "program.hpp"

/// How the program's threads wait for each other, as OpenMP tells it when it is asked to by OMP_DISPLAY_ENV.
namespace brinell::cli::waiting_test
{

namespace
{

class Waiting : public Program
{
protected:
  /// The program may start itself again: what it tells last counts.
  /// @param policy, count  OMP_WAIT_POLICY and GOMP_SPINCOUNT; nullptr: not set
  [[nodiscard]] std::string told(const std::string& variable, const char* policy = nullptr,
                                 const char* count = nullptr) const
  {
    const std::string text =
        run({"--version"}, {{"OMP_DISPLAY_ENV", "verbose"}, {"OMP_WAIT_POLICY", policy}, {"GOMP_SPINCOUNT", count}})
            .err;
    const std::size_t line = text.rfind(variable + " = '");
    if (line == std::string::npos)
      return "not told: " + text;
    const std::size_t first = text.find('\'', line) + 1;
    return text.substr(first, text.find('\'', first) - first);
  }
};

TEST_F(Waiting, ThreadsLookForAMomentBeforeTheySleep)
{
  EXPECT_EQ(told("OMP_WAIT_POLICY"), "PASSIVE");
  EXPECT_EQ(told("GOMP_SPINCOUNT"), "1000");
}

TEST_F(Waiting, WhatAUserHasSetStays)
{
  EXPECT_EQ(told("GOMP_SPINCOUNT", nullptr, "77"), "77");
  EXPECT_EQ(told("OMP_WAIT_POLICY", nullptr, "77"), "PASSIVE");
  EXPECT_EQ(told("GOMP_SPINCOUNT", "passive"), "0") << "sleeps at once, as it is told to";
  EXPECT_EQ(told("OMP_WAIT_POLICY", "active"), "ACTIVE");
  EXPECT_GT(std::stod(told("GOMP_SPINCOUNT", "active")), 1e9);
}

TEST_F(Waiting, WhatItAsksForIsNotForOtherTests)
{
  EXPECT_EQ(told("OMP_WAIT_POLICY"), "PASSIVE");
  EXPECT_EQ(run({"--version"}).err, "");
}

} // namespace

} // namespace brinell::cli::waiting_test
