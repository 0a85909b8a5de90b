// SPDX-License-Identifier: BSD-3-Clause
#include "program.hpp"

/// How the program's threads wait for each other, as OpenMP tells it when it is asked to by OMP_DISPLAY_ENV.
namespace brinell::cli
{

namespace
{

class Waiting : public Program
{
protected:
  void SetUp() override
  {
    Program::SetUp();
    setenv("OMP_DISPLAY_ENV", "verbose", 1);
    unsetenv("OMP_WAIT_POLICY");
    unsetenv("GOMP_SPINCOUNT");
  }

  /// The program may start itself again: what it tells last counts.
  [[nodiscard]] std::string told(const std::string& variable) const
  {
    const std::string text = run({"--version"}).err;
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
  setenv("GOMP_SPINCOUNT", "77", 1);
  EXPECT_EQ(told("GOMP_SPINCOUNT"), "77");
  EXPECT_EQ(told("OMP_WAIT_POLICY"), "PASSIVE");
  unsetenv("GOMP_SPINCOUNT");
  setenv("OMP_WAIT_POLICY", "passive", 1);
  EXPECT_EQ(told("GOMP_SPINCOUNT"), "0") << "sleeps at once, as it is told to";
  setenv("OMP_WAIT_POLICY", "active", 1);
  EXPECT_EQ(told("OMP_WAIT_POLICY"), "ACTIVE");
  EXPECT_GT(std::stod(told("GOMP_SPINCOUNT")), 1e9);
}

} // namespace

} // namespace brinell::cli
