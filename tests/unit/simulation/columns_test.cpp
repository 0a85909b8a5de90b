// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/foundation/error.hpp"
#include "brinell/simulation/columns.hpp"

#include <concepts>
#include <fstream>
#include <gtest/gtest.h>
#include <limits>
#include <regex>
#include <set>
#include <string>

namespace brinell::simulation
{

namespace
{

struct Anything
{
  template <typename T>
  operator T() const; // NOLINT(google-explicit-constructor)
};

/// How many values T{...} takes: one for each of its members, and one for its base.
template <typename T, typename... Values>
consteval std::size_t arity()
{
  if constexpr (requires { T{Values{}..., Anything{}}; })
    return arity<T, Values..., Anything>();
  else
    return sizeof...(Values);
}

/// Members of what a row derives from: those of the totals without the coverage, and its own beside this base.
constexpr std::size_t members_of_all_rows = (arity<RunningTotals>() - 1) + (arity<StepRecord>() - 1);

/// Some rows derive from those of sliding surfaces.
template <typename Row>
constexpr std::size_t members_of_row = members_of_all_rows +
                                       (std::derived_from<Row, SlidingRecord> ? arity<SlidingRecord>() - 1 : 0) +
                                       (arity<Row>() - 1);

template <typename Record>
class ColumnsOf : public testing::Test
{
};
using Records = testing::Types<TuggingRecord, IndentationRecord, RollingRecord, Indent, RollingPass>;
TYPED_TEST_SUITE(ColumnsOf, Records);

/// Each column has its own number.
template <typename Record>
Record numbered()
{
  Record record;
  int number = 0;
  for (const auto& column : columns<Record>)
    std::visit([&](auto member) { record.*member = static_cast<std::decay_t<decltype(record.*member)>>(++number); },
               column.member);
  return record;
}

// A member that is added to a record without a column of its own fails here.
TEST(Columns, EveryMemberHasOne)
{
  constexpr std::size_t only_in_checkpoints = 4; // F_X_lower, F_X_upper, F_X_friction, F_Z_friction
  EXPECT_EQ(columns<TuggingRecord>.size(), members_of_row<TuggingRecord> - only_in_checkpoints);
  EXPECT_EQ(columns<IndentationRecord>.size(), members_of_row<IndentationRecord>);
  EXPECT_EQ(columns<RollingRecord>.size(), members_of_row<RollingRecord>);
  EXPECT_EQ(columns<Indent>.size(), arity<Indent>());
  EXPECT_EQ(columns<RollingPass>.size(), arity<RollingPass>());
}

// The name and the pointer to the member stand side by side in the tables, but only a reader could compare them.
TEST(Columns, AreNamedAsTheirMembers)
{
  std::ifstream header(BRINELL_SOURCE_DIR "/include/brinell/simulation/columns.hpp");
  const std::string text{std::istreambuf_iterator<char>(header), {}};
  const std::regex line(R"re(\{\s*"(\w+)",\s*"[^"]+",\s*&\w+::(\w+))re");
  std::size_t lines = 0;
  for (std::sregex_iterator found(text.begin(), text.end(), line); found != std::sregex_iterator(); ++found, ++lines)
    EXPECT_EQ((*found)[1], (*found)[2]);
  constexpr std::size_t shared = common::ending.size() + 5; // in all rows
  constexpr std::size_t of_sliding = 2;                     // in tugging and rolling
  EXPECT_EQ(lines + 2 * shared + of_sliding, columns<TuggingRecord>.size() + columns<IndentationRecord>.size() +
                                                 columns<RollingRecord>.size() + columns<Indent>.size() +
                                                 columns<RollingPass>.size());
}

TYPED_TEST(ColumnsOf, NoTwoAreOfTheSameMember)
{
  const TypeParam record = numbered<TypeParam>();
  std::set<std::string_view> names;
  int number = 0;
  for (const auto& column : columns<TypeParam>)
  {
    std::visit([&](auto value) { EXPECT_EQ(value, number + 1) << column.name; }, column.value(record));
    EXPECT_TRUE(names.insert(column.name).second) << column.name;
    EXPECT_FALSE(column.unit.empty()) << column.name;
    ++number;
  }
}

TYPED_TEST(ColumnsOf, ComeBackFromACheckpoint)
{
  TypeParam record = numbered<TypeParam>();
  Archive written;
  record.exchange(written);
  TypeParam again;
  Archive stored(written.fields());
  again.exchange(stored);
  for (const auto& column : columns<TypeParam>)
  {
    EXPECT_EQ(column.value(again), column.value(record)) << column.name;
    EXPECT_TRUE(written.fields().contains(std::string(column.name))) << column.name;
  }
}

TEST(Columns, CountsOfACheckpointCanBeCountedOnFrom)
{
  Indent indent;
  Archive written;
  indent.exchange(written);
  for (const double count : {-1.0, 0.5, double{std::numeric_limits<int>::max()}})
  {
    Archive::Fields fields = written.fields();
    fields.at("cycle") = {count};
    Archive stored(fields);
    EXPECT_THROW(indent.exchange(stored), InputError) << count;
  }
}

} // namespace

} // namespace brinell::simulation
