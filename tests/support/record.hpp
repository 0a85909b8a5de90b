// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <sys/file.h>
#include <unistd.h>

/// Assertions that leave what they measured in a file, from which the verification page is rendered
/// (tools/render_verification.py). The file is $BRINELL_VERIFICATION_JSON, else verification.json in the build folder.
namespace brinell::test
{

/// Path of the record.
inline std::filesystem::path record_path()
{
  if (const char* path = std::getenv("BRINELL_VERIFICATION_JSON"); path != nullptr && *path != '\0')
    return path;
  return std::filesystem::path(BRINELL_PROGRAM).parent_path().parent_path() / "verification.json";
}

/// Adds an entry under the suite and name of the running test, in place of an earlier one of the same name. Safe for
/// several test processes at once: they take turns by a lock file.
inline void record(const std::string& name, nlohmann::ordered_json entry)
{
  const testing::TestInfo* test = testing::UnitTest::GetInstance()->current_test_info();
  const std::filesystem::path path = record_path();
  const int lock = open((path.string() + ".lock").c_str(), O_CREAT | O_RDWR | O_CLOEXEC, 0644);
  if (lock < 0 || flock(lock, LOCK_EX) != 0)
    throw std::runtime_error("cannot lock " + path.string());
  nlohmann::ordered_json all = nlohmann::ordered_json::object();
  if (std::ifstream file(path); file)
  {
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    all = nlohmann::ordered_json::parse(text, nullptr, false);
    if (!all.is_object())
      all = nlohmann::ordered_json::object();
  }
  all[test->test_suite_name()][test->name()][name] = std::move(entry);
  std::ofstream(path) << all.dump(2) << '\n';
  flock(lock, LOCK_UN);
  close(lock);
}

/// EXPECT_NEAR with a record.
/// @param tolerance  absolute; its cause stands beside the call.
/// @param origin     where the expected value comes from.
inline void expect_close(const std::string& name, double measured, double expected, double tolerance,
                         const std::string& origin)
{
  EXPECT_NEAR(measured, expected, tolerance) << name << " (" << origin << ")";
  std::printf("  %-58s %14.7g, expected %14.7g, %5.1f %% of the tolerance\n", name.c_str(), measured, expected,
              100.0 * std::abs(measured - expected) / tolerance);
  record(name, {{"expected", expected}, {"measured", measured}, {"tolerance", tolerance}, {"origin", origin}});
}

/// low <= measured <= high.
inline void expect_between(const std::string& name, double measured, double low, double high, const std::string& origin)
{
  EXPECT_TRUE(measured >= low && measured <= high)
      << name << " = " << measured << ", expected within [" << low << ", " << high << "] (" << origin << ")";
  std::printf("  %-58s %14.7g, expected within [%g, %g]\n", name.c_str(), measured, low, high);
}

/// The same with a record.
inline void expect_within(const std::string& name, double measured, double low, double high, const std::string& origin)
{
  expect_between(name, measured, low, high, origin);
  record(name, {{"low", low}, {"high", high}, {"measured", measured}, {"origin", origin}});
}

} // namespace brinell::test
