// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/foundation/archive.hpp"

#include <gtest/gtest.h>

namespace brinell
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

} // namespace
} // namespace brinell
