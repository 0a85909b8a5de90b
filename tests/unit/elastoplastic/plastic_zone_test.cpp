// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/elastoplastic/plastic_zone.hpp"

#include <algorithm>
#include <gtest/gtest.h>
#include <iterator>
#include <random>
#include <vector>

namespace brinell::elastoplastic::plastic_zone_test
{
namespace
{

const VolumeGrid grid{{7, 5, 1.0, 1.0}, 3, 1.0};

/// Cells of the grid that have flowed, each with its strain.
std::vector<double> some_strain(unsigned seed)
{
  std::vector<double> strain(grid.size(), 0.0);
  std::mt19937 random(seed);
  for (double& value : strain)
    value = random() % 8 == 0 ? 1e-3 * static_cast<double>(1 + random() % 9) : 0.0;
  return strain;
}

TEST(PlasticZone, HoldsAllThatHasFlowedAndNoMoreThanItsRows)
{
  for (unsigned seed = 0; seed < 20; ++seed)
  {
    const std::vector<double> strain = some_strain(seed);
    const PlasticZone zone(grid, strain);
    for (std::size_t row = 0; row < grid.size() / 7; ++row)
    {
      const auto begin = strain.begin() + static_cast<std::ptrdiff_t>(7 * row), end = begin + 7;
      const auto flows = [](double value) { return value > 0.0; };
      const auto first = std::find_if(begin, end, flows);
      const auto [from, to] = zone.columns(row);
      if (first == end)
      {
        EXPECT_GE(from, to);
        continue;
      }
      EXPECT_EQ(from, static_cast<std::size_t>(first - begin));
      EXPECT_EQ(to, static_cast<std::size_t>(
                        7 - (std::find_if(std::make_reverse_iterator(end), std::make_reverse_iterator(begin), flows) -
                             std::make_reverse_iterator(end))));
    }
    EXPECT_EQ(zone.largest(), *std::max_element(strain.begin(), strain.end()));
    for (std::size_t layer = 0; layer < 3; ++layer)
      EXPECT_EQ(zone.largest_of_layers()[layer],
                *std::max_element(strain.begin() + static_cast<std::ptrdiff_t>(35 * layer),
                                  strain.begin() + static_cast<std::ptrdiff_t>(35 * (layer + 1))));
  }
}

TEST(PlasticZone, PartsOfItMeetEachCellOnce)
{
  const std::vector<double> strain = some_strain(3);
  PlasticZone zone(grid, {});
  EXPECT_EQ(zone.largest(), 0.0);
  for (std::size_t cell = grid.size(); cell-- > 0;) // in any order
    if (strain[cell] > 0.0)
      zone.add(cell, strain[cell]);
  for (const std::size_t piece : {1U, 4U, 7U, 10U, 64U, 105U})
  {
    std::vector<int> met(grid.size(), 0);
    for (std::size_t first = 0; first < grid.size(); first += piece)
      zone.for_cells(first, std::min(first + piece, grid.size()),
                     [&](std::size_t from, std::size_t to)
                     {
                       EXPECT_EQ(from / 7, (to - 1) / 7) << "one row";
                       for (std::size_t cell = from; cell < to; ++cell)
                         ++met[cell];
                     });
    for (std::size_t cell = 0; cell < grid.size(); ++cell)
    {
      const auto [from, to] = zone.columns(cell / 7);
      EXPECT_EQ(met[cell], cell % 7 >= from && cell % 7 < to ? 1 : 0);
      EXPECT_TRUE(strain[cell] == 0.0 || met[cell] == 1);
    }
  }
}

} // namespace
} // namespace brinell::elastoplastic::plastic_zone_test
