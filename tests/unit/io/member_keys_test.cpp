// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/io/member_keys.hpp"

#include "brinell/io/schema.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <regex>

namespace brinell::io::member_keys_test
{

namespace
{

TEST(MemberKeys, StandInThePlaceOfMembers)
{
  EXPECT_EQ(key_of_member("RollingCase::spin"), "rolling.spin");
  EXPECT_EQ(key_of_member("Friction::coefficient"), "interface.friction");
  EXPECT_EQ(key_of_member("upper.material.temperature"), "upper.material.thermal.temperature");
  EXPECT_EQ(with_keys("`RollingCase::spin` = 3 rad/m with `Friction::coefficient` = 0"),
            "rolling.spin = 3 rad/m with interface.friction = 0");
  EXPECT_EQ(with_keys("`lower.texture[1]`: waves"), "lower.texture[1]: waves");
  EXPECT_EQ(with_keys("run `brinell check`, `Domain::size` is in `it"), "run `brinell check`, grid.size is in `it");
}

// A name that no key fills would reach the user of a case file as it is.
TEST(MemberKeys, ExistForAllMembersThatTheEngineNames)
{
  const std::regex name("`([A-Z]\\w+::\\w+)`");
  int found = 0;
  const std::filesystem::path source(BRINELL_SOURCE_DIR);
  for (const char* floor : {"src/elastoplastic", "src/simulation", "include/brinell/simulation"})
    for (const auto& file : std::filesystem::recursive_directory_iterator(source / floor))
    {
      if (!file.is_regular_file())
        continue;
      std::ifstream stream(file.path());
      for (std::string line; std::getline(stream, line);)
      {
        line.resize(std::min(line.size(), line.find("//")));
        for (std::sregex_iterator at(line.begin(), line.end(), name), end; at != end; ++at, ++found)
        {
          const std::string key = key_of_member((*at)[1].str());
          EXPECT_TRUE(find_entry(key) != nullptr || is_table(key)) << file.path() << ": " << line;
        }
      }
    }
  EXPECT_GT(found, 50);
}

} // namespace
} // namespace brinell::io::member_keys_test
