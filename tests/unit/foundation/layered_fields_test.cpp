// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/foundation/layered_fields.hpp"

#include "ranks_as_threads.hpp"

#include <gtest/gtest.h>
#include <numeric>

namespace brinell::layered_fields_test
{
namespace
{

constexpr VolumeGrid grid{{5, 4, 1.0, 1.0}, 9, 1.0};

std::vector<double> numbers(double first)
{
  std::vector<double> values(grid.size());
  std::iota(values.begin(), values.end(), first);
  return values;
}

/// The layers of a rank.
std::vector<double> own(const std::vector<double>& field, const Share& share)
{
  std::vector<double> values;
  const auto plane = static_cast<std::ptrdiff_t>(grid.surface.size());
  for (int layer = 0; layer < grid.nz; ++layer)
    if (share.has(layer))
      values.insert(values.end(), field.begin() + layer * plane, field.begin() + (layer + 1) * plane);
  return values;
}

TEST(LayeredFields, PartsAreThoseOfTheWholeField)
{
  const LayeredFields fields(grid, {numbers(0.0), numbers(1000.0)});
  EXPECT_EQ(fields.whole(1), numbers(1000.0));
  EXPECT_EQ(fields.part(0, {2, 1, 1, 1}), (std::vector<double>{45, 46, 47, 48, 49}));
  const LayeredFields some = LayeredFields(fields).selected({1, 2, 3}, {3, 1, 1}, {0, 3, 2});
  EXPECT_EQ(some.shape(), (std::array<std::size_t, 3>{2, 1, 3}));
  EXPECT_EQ(some.whole(0), (std::vector<double>{35, 37, 39, 95, 97, 99}));
  EXPECT_EQ(some.combined([&](std::size_t cell) { return fields.own(1)[cell] - fields.own(0)[cell]; }).whole(),
            std::vector<double>(6, 1000.0));
}

TEST(LayeredFields, TheFirstOfManyRanksReceivesWhatOneHas)
{
  const Spaced layers{1, 4, 2}, rows{0, 2, 3}, columns{1, 2, 2};
  const auto parts = [&](LayeredFields fields)
  {
    const auto some = std::move(fields).selected(layers, rows, columns);
    return std::vector{some.whole(0), some.whole(1), some.part(1, {1, 2, 1, 1}), some.part(0, {3, 1, 0, 2})};
  };
  const auto expected = parts(LayeredFields(grid, {numbers(0.0), numbers(1000.0)}));
  for (const int count : {1, 2, 3, 7}) // of seven ranks two have no layers
    test::RanksAsThreads::run(
        count,
        [&](const std::shared_ptr<const Communicator>& ranks)
        {
          const Share share(ranks->rank(), count);
          const auto found =
              parts(LayeredFields(grid, ranks, share, {own(numbers(0.0), share), own(numbers(1000.0), share)}));
          for (std::size_t i = 0; i < found.size(); ++i)
            EXPECT_EQ(found[i], ranks->rank() == 0 ? expected[i] : std::vector<double>{}) << count << " " << i;
        });
}

} // namespace
} // namespace brinell::layered_fields_test
