// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/foundation/archive.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <span>
#include <utility>
#include <vector>

namespace brinell::archive_test
{
namespace
{

struct Inner
{
  int count = 0;
  double size = 0.0;
  void exchange(Archive& archive)
  {
    archive("count", count);
    archive("size", size);
  }
  bool operator==(const Inner&) const = default;
};

struct Outer
{
  Inner inner;
  std::vector<double> field{0.0, 0.0};
  std::vector<double> curve;
  std::vector<Inner> list;
  bool flag = false;
  void exchange(Archive& archive)
  {
    archive("inner", inner);
    archive("field", field);
    archive.list("curve", curve);
    archive.list("list", list);
    archive("flag", flag);
  }
  bool operator==(const Outer&) const = default;
};

Outer sample()
{
  return {{3, 0.1}, {1.0 / 3.0, -2.0}, {5.0, 6.0, 7.0}, {{1, 0.5}, {2, 0.25}, {-7, 1e-300}}, true};
}

TEST(ArchiveTest, GivesBackWhatItTookIn)
{
  for (Outer original : {sample(), Outer{}})
  {
    Archive taking;
    original.exchange(taking);
    Archive giving(taking.fields());
    Outer copy;
    copy.list.resize(1); // lists take the length of the stored one
    copy.exchange(giving);
    EXPECT_EQ(copy, original);
  }
}

TEST(ArchiveTest, HandsOnWhatItWouldKeep)
{
  for (Outer original : {sample(), Outer{}})
  {
    Archive keeping;
    original.exchange(keeping);
    Archive::Fields taken;
    Archive handing([&](const std::string& name, std::span<const double> values)
                    { EXPECT_TRUE(taken.emplace(name, std::vector(values.begin(), values.end())).second) << name; });
    original.exchange(handing);
    EXPECT_EQ(taken, keeping.fields());
    EXPECT_TRUE(handing.fields().empty());
  }
}

// A field that no process has whole in memory.
TEST(ArchiveTest, PassesAFieldInParts)
{
  std::vector<double> field{1, 2, 3, 4, 5, 6};
  const auto save = [&](std::size_t first, std::span<double> values)
  { std::copy_n(field.begin() + static_cast<std::ptrdiff_t>(first), values.size(), values.begin()); };
  std::vector<std::pair<std::size_t, std::vector<double>>> taken;
  Archive handing([](const std::string&, std::span<const double>) { FAIL(); },
                  [&](const std::string& name, std::size_t size, std::size_t first, std::span<const double> values)
                  {
                    EXPECT_EQ(name, "field");
                    EXPECT_EQ(size, 6u);
                    taken.emplace_back(first, std::vector(values.begin(), values.end()));
                  });
  handing.parts("field", 6, 2, save);
  ASSERT_EQ(taken.size(), 3u);
  EXPECT_EQ(taken[2], (std::pair<std::size_t, std::vector<double>>{4, {5, 6}}));
  Archive keeping;
  keeping.parts("field", 6, 3, save);
  EXPECT_EQ(keeping.fields().at("field"), field) << "put together for whoever does not ask for parts";
  std::vector<double> restored(6);
  const auto restore = [&](std::size_t first, std::span<double> values)
  { std::copy(values.begin(), values.end(), restored.begin() + static_cast<std::ptrdiff_t>(first)); };
  Archive(keeping.fields()).parts("field", 6, 2, restore);
  EXPECT_EQ(restored, field);
  EXPECT_THROW(Archive(keeping.fields()).parts("field", 8, 2, restore), InputError);
  EXPECT_THROW(Archive(keeping.fields()).parts("other", 6, 2, restore), InputError);
}

TEST(ArchiveTest, ReadsWhatHasBeenLeftWhereItIsStored)
{
  const std::vector<double> stored{1, 2, 3, 4, 5, 6};
  Archive::Fields fields{{"count", {2.0}}};
  fields.left["field"] = stored.size();
  fields.left["list"] = stored.size();
  fields["list.size"] = {6.0};
  fields.read = [&](const std::string&, std::size_t first, std::span<double> values)
  { std::copy_n(stored.begin() + static_cast<std::ptrdiff_t>(first), values.size(), values.begin()); };
  std::vector<double> whole(6), list, parts(6), longer(7);
  Archive archive(fields);
  archive("field", whole);
  archive.list("list", list);
  archive.parts("field", 6, 2,
                [&](std::size_t first, std::span<double> values)
                { std::copy(values.begin(), values.end(), parts.begin() + static_cast<std::ptrdiff_t>(first)); });
  EXPECT_EQ(whole, stored);
  EXPECT_EQ(list, stored);
  EXPECT_EQ(parts, stored);
  EXPECT_THROW(archive("field", longer), InputError);
}

TEST(ArchiveTest, ListsOfPartsAreColumns)
{
  Outer original = sample();
  Archive taking;
  original.exchange(taking);
  EXPECT_EQ(taking.fields().at("list.member.count"), (std::vector{1.0, 2.0, -7.0}));
}

TEST(ArchiveTest, SaysWhatDoesNotFit)
{
  Outer original = sample();
  Archive taking;
  original.exchange(taking);
  Archive::Fields fields = taking.fields();
  fields["field"].push_back(1.0);
  Outer copy;
  Archive longer(fields);
  EXPECT_THROW(copy.exchange(longer), InputError);
  fields.erase("field");
  Archive without(fields);
  EXPECT_THROW(copy.exchange(without), InputError);
}

// A stored state may come from somebody else, or from a disk that fails.
TEST(ArchiveTest, RefusesNumbersThatTheTypeCannotHold)
{
  const double infinite = std::numeric_limits<double>::infinity();
  for (const double wrong : {std::nan(""), infinite, -infinite, 1e18, -1e18, 0.5, 2147483648.0})
  {
    int value = 7;
    Archive archive({{"count", {wrong}}});
    EXPECT_THROW(archive("count", value), InputError) << wrong;
    EXPECT_EQ(value, 7);
  }
  std::size_t size = 0;
  EXPECT_THROW(Archive({{"size", {-1.0}}})("size", size), InputError);
  EXPECT_THROW(Archive({{"size", {18446744073709551616.0}}})("size", size), InputError);
  bool flag = false;
  EXPECT_THROW(Archive({{"flag", {2.0}}})("flag", flag), InputError);
  double any = 0.0;
  Archive({{"any", {infinite}}})("any", any);
  EXPECT_EQ(any, infinite);
}

TEST(ArchiveTest, KeepsToBounds)
{
  const auto taken = [](double stored)
  {
    int value = 0;
    Archive({{"layers", {stored}}})("layers", value, 1, 20);
    return value;
  };
  EXPECT_EQ(taken(1.0), 1);
  EXPECT_EQ(taken(20.0), 20);
  for (const double wrong : {0.0, 21.0, std::nan("")})
    try
    {
      taken(wrong);
      ADD_FAILURE() << wrong;
    }
    catch (const InputError& error)
    {
      EXPECT_NE(std::string(error.what()).find("layers"), std::string::npos) << error.what();
    }
  double share = 0.0;
  EXPECT_THROW(Archive({{"share", {1.5}}})("share", share, 0.0, 1.0), InputError);
}

TEST(ArchiveTest, ListsAreAsLongAsWhatIsStored)
{
  Outer original = sample();
  Archive taking;
  original.exchange(taking);
  for (const char* list : {"curve.size", "list.size"})
  {
    Archive::Fields fields = taking.fields();
    fields[list] = {1e15}; // more than there is memory for
    Outer copy;
    Archive giving(fields);
    EXPECT_THROW(copy.exchange(giving), InputError) << list;
  }
}

} // namespace
} // namespace brinell::archive_test
