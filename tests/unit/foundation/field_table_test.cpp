// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/foundation/field_table.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace brinell::field_table_test
{

namespace
{

struct State
{
  std::array<std::vector<double>, 2> pair;
  std::vector<double> list, none;
  double number = 0.0;
  int count = 0;

  static constexpr auto table()
  {
    return std::tuple{listed(&State::pair, {"pair_x", "pair_y"}), listed(&State::list, {"list"}, {.is_sized = true}),
                      listed(&State::none, {"none"}), listed(&State::number, {"number"}),
                      listed(&State::count, {"count"}, {.range = std::pair{0.0, 9.0}})};
  }
};

/// A table of the wrong length, and one with a member twice.
struct Short
{
  double a = 0.0, b = 0.0;
  static constexpr auto table() { return std::tuple{listed(&Short::a, {"a"})}; }
};
struct Twice
{
  double a = 0.0, b = 0.0;
  static constexpr auto table() { return std::tuple{listed(&Twice::a, {"a"}), listed(&Twice::a, {"b"})}; }
};

TEST(FieldTable, CountsMembersAndLines)
{
  EXPECT_TRUE(detail::lists_each_once<State>());
  EXPECT_FALSE(detail::lists_each_once<Short>());
  EXPECT_FALSE(detail::lists_each_once<Twice>());
}

TEST(FieldTable, StoresEachPartUnderItsName)
{
  State before{.pair = {{{1.0, 2.0}, {3.0, 4.0}}}, .list = {5.0}, .none = {}, .number = 6.0, .count = 7};
  Archive archive;
  exchange_members(archive, before);
  const Archive::Fields& stored = archive.fields();
  std::vector<std::string> names;
  for (const auto& [name, values] : stored)
    names.push_back(name);
  EXPECT_EQ(names, (std::vector<std::string>{"count", "list", "list.size", "number", "pair_x", "pair_y"}));
  State after{.pair = {{{0.0, 0.0}, {0.0, 0.0}}}, .list = {}, .none = {}};
  Archive back(stored);
  exchange_members(back, after);
  std::size_t parts = 0;
  for_parts(
      [&](std::string_view name, const Traits& /*traits*/, const auto& a, const auto& b)
      {
        ++parts;
        EXPECT_EQ(a, b) << name;
      },
      before, after);
  EXPECT_EQ(parts, 6u);
}

TEST(FieldTable, ChecksRanges)
{
  State state;
  Archive stored(Archive::Fields{{"pair_x", {}}, {"list.size", {0.0}}, {"number", {0.0}}, {"count", {10.0}}});
  EXPECT_THROW(exchange_members(stored, state), InputError);
}

} // namespace

} // namespace brinell::field_table_test
