// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "record.hpp"

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <string>

namespace brinell::test
{

/// Which cases of a sweep over random ones a run computes: every seventh, others each day, so that a week computes all.
/// The environment says otherwise: BRINELL_SWEEP=all, or 0 ... 6 for the part of another day (docs/developer/checks.md).
/// Each case depends on its number alone and not on which others are computed.
class Sweep
{
public:
  static constexpr int parts = 7;

  /// @param count  cases in all; fewer than seven are always computed
  explicit Sweep(int count) : count_(count), part_(count < parts ? whole : part_of_run())
  {
    if (!is_whole())
      std::printf("part %d of 0 ... %d of %d random cases: BRINELL_SWEEP=%d computes the same ones, =all all of them\n",
                  part_, parts - 1, count_, part_);
  }

  [[nodiscard]] bool is_whole() const { return part_ == whole; }
  [[nodiscard]] bool has(int number) const { return is_whole() || number % parts == part_; }
  [[nodiscard]] int count() const { return count_; } ///< number of all cases
  /// Number of cases that are computed.
  [[nodiscard]] int size() const { return is_whole() ? count_ : (count_ - part_ + parts - 1) / parts; }

  /// As test::expect_within, but the measured number of a part is not recorded: the verification page shows that of all cases.
  void expect_within(const std::string& name, double measured, double low, double high, const std::string& origin) const
  {
    if (is_whole())
      test::expect_within(name, measured, low, high, origin);
    else
      test::expect_between(name, measured, low, high, origin);
  }

private:
  static constexpr int whole = -1;

  static int part_of_run()
  {
    const char* given = std::getenv("BRINELL_SWEEP");
    const std::string wanted = given == nullptr ? "" : given;
    if (wanted == "all")
      return whole;
    if (wanted.size() == 1 && wanted[0] >= '0' && wanted[0] < '0' + parts)
      return wanted[0] - '0';
    if (!wanted.empty())
      throw std::invalid_argument("BRINELL_SWEEP is '" + wanted +
                                  "'; allowed: all, 0 ... 6, or nothing for the day's part");
    const auto now = std::chrono::system_clock::now().time_since_epoch();
    return static_cast<int>(std::chrono::floor<std::chrono::days>(now).count() % parts);
  }

  int count_, part_;
};

} // namespace brinell::test
