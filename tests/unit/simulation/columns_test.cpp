// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/foundation/error.hpp"
#include "brinell/simulation/fretting.hpp"
#include "brinell/simulation/scenarios.hpp"
#include "brinell/simulation/sliding.hpp"

#include <concepts>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <limits>
#include <regex>
#include <set>
#include <string>

namespace brinell::simulation::columns_test
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

/// Totals of the effects between the surfaces: the bases of EffectTotals. Wear acts where the surfaces slip.
template <typename Row>
constexpr std::size_t members_of_effects = arity<elastoplastic::CurrentTotals>() +
                                           (std::derived_from<Row, FrictionRecord> ? arity<elastoplastic::WearTotals>()
                                                                                   : 0);

/// Members of what a row derives from: those of the totals without their base, the coverage, and the work of expansion, which is
/// nothing where nothing heats; and its own beside this base.
constexpr std::size_t members_of_all_rows = (arity<RunningTotals>() - 3) + (arity<StepRecord>() - 1);

/// Some rows derive from those of sliding surfaces, and of them some from those that friction heats, with the work of expansion.
template <typename Row>
constexpr std::size_t
    members_of_row = members_of_all_rows + (std::derived_from<Row, FrictionRecord> ? arity<FrictionRecord>() - 1 : 0) +
                     (std::derived_from<Row, HeatedRecord> ? arity<HeatedRecord>() : 0) + members_of_effects<Row> +
                     (arity<Row>() - 1);

template <typename Record>
class ColumnsOf : public testing::Test
{
};
template <typename... Case>
using RowsAndEntries = testing::Types<typename Case::Record..., Indent, RollingPass, FrettingCycle, SlidingStroke>;
using Records = Scenarios<RowsAndEntries>;
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
TYPED_TEST(ColumnsOf, EveryMemberHasOne)
{
  // F_X_lower, F_X_upper, F_X_friction, F_Z_friction
  constexpr std::size_t only_in_checkpoints = std::same_as<TypeParam, TuggingRecord> ? 4 : 0;
  if constexpr (std::derived_from<TypeParam, StepRecord>)
    EXPECT_EQ(columns<TypeParam>.size(), members_of_row<TypeParam> - only_in_checkpoints);
  else
    EXPECT_EQ(columns<TypeParam>.size(), arity<TypeParam>());
}

// The name and the pointer to the member stand side by side in the tables, but only a reader could compare them.
TEST(Columns, AreNamedAsTheirMembers)
{
  std::string text;
  for (const auto& file : std::filesystem::directory_iterator(BRINELL_SOURCE_DIR "/include/brinell/simulation"))
  {
    std::ifstream header(file.path());
    text.append(std::istreambuf_iterator<char>(header), {});
  }
  const std::regex line(R"re(\{\s*"(\w+)",\s*"[^"]+",\s*&\w+::(\w+))re"), pointer(R"re(&\w+::\w+)re");
  std::ptrdiff_t lines = 0;
  const std::sregex_iterator end;
  for (std::sregex_iterator found(text.begin(), text.end(), line); found != end; ++found, ++lines)
    EXPECT_EQ((*found)[1], (*found)[2]);
  EXPECT_EQ(lines, std::distance(std::sregex_iterator(text.begin(), text.end(), pointer), end)); // none was missed
  EXPECT_GT(lines, 0);
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

} // namespace brinell::simulation::columns_test
