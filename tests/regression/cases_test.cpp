// SPDX-License-Identifier: BSD-3-Clause
#include "expected.hpp"

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <nlohmann/json.hpp>
#include <unistd.h>

/// Runs each folder of cases/ as a user would and compares summary.json with expected.toml. With BRINELL_UPDATE=1 in the
/// environment the values that were recorded are recorded anew; analytic ones and those of the literature never are.
namespace brinell::regression::cases_test
{

namespace
{

namespace fs = std::filesystem;

std::vector<std::string> case_names()
{
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(BRINELL_SOURCE_DIR "/cases"))
    if (fs::exists(entry.path() / "case.toml"))
      names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

std::string file_text(const fs::path& path)
{
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

class Cases : public testing::TestWithParam<std::string>
{
protected:
  void SetUp() override
  {
    results_ = fs::temp_directory_path() / ("brinell-case-" + GetParam() + "-" + std::to_string(getpid()));
  }
  void TearDown() override
  {
    std::error_code ignored;
    fs::remove_all(results_, ignored);
  }

  [[nodiscard]] static fs::path folder() { return fs::path(BRINELL_SOURCE_DIR) / "cases" / GetParam(); }

  /// Runs the case and returns its summary.
  [[nodiscard]] nlohmann::json summary() const
  {
    const std::string command = std::string("'") + BRINELL_PROGRAM + "' run --quiet '" +
                                (folder() / "case.toml").string() + "' -o '" + results_.string() + "'";
    if (std::system(command.c_str()) != 0)
      throw std::runtime_error("failed: " + command);
    return nlohmann::json::parse(file_text(results_ / "summary.json"));
  }

private:
  fs::path results_;
};

TEST_P(Cases, IsExampleAndPage)
{
  EXPECT_FALSE(file_text(folder() / "README.md").empty());
  for (const Check& check : read_checks(folder() / "expected.toml"))
    EXPECT_TRUE(check.origin.starts_with("analytic: ") || check.origin.starts_with("literature: ") ||
                check.origin.starts_with("mesh: ") || check.is_recorded())
        << check.key << ": origin = " << check.origin;
}

TEST_P(Cases, GivesTheExpectedNumbers)
{
  const fs::path file = folder() / "expected.toml";
  const nlohmann::json results = summary();
  if (const char* update = std::getenv("BRINELL_UPDATE"); update && std::string(update) == "1")
  {
    const std::string text = updated(file_text(file), results); // read before the file is opened for writing
    std::ofstream(file) << text;
  }
  const auto checks = read_checks(file);
  EXPECT_FALSE(checks.empty());
  for (const Check& check : checks)
  {
    const double expected = check.same_as.empty() ? check.value : number(results, check.same_as);
    const double found = number(results, check.key);
    const double tolerance = check.absolute_tolerance + check.relative_tolerance * std::abs(expected);
    EXPECT_LE(std::abs(found - expected), tolerance) << check.key << " = " << found << ", expected " << expected
                                                     << " +- " << tolerance << " (" << check.origin << ")";
    std::printf("%-36s %13.6g, %5.1f %% of the tolerance\n", check.key.c_str(), found,
                100.0 * std::abs(found - expected) / tolerance);
  }
}

INSTANTIATE_TEST_SUITE_P(All, Cases, testing::ValuesIn(case_names()),
                         [](const auto& parameter)
                         {
                           std::string name = parameter.param;
                           std::replace_if(
                               name.begin(), name.end(), [](unsigned char c) { return !std::isalnum(c); }, '_');
                           return name;
                         });

} // namespace

} // namespace brinell::regression::cases_test
