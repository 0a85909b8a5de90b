// SPDX-License-Identifier: BSD-3-Clause
#include "elastoplastic/body/lane_cells.hpp"

#include "random_field.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <vector>

namespace brinell::elastoplastic::lane_cells_test
{
namespace
{

constexpr std::size_t components = Deviator::size;

TEST(LaneCellsTest, PackedDeviatorsAreTakenApartAndPutTogether)
{
  constexpr std::size_t cells = 20;
  const std::vector<double> packed = test::random_field(components * cells, 1);
  for (std::size_t count = 1; count <= lane_count; ++count)
    for (const std::size_t first : {std::size_t{0}, std::size_t{3}, cells - count})
    {
      const LaneCells at{first, 0, count};
      const LaneDeviators d = load_packed(packed.data(), at);
      for (std::size_t lane = 0; lane < lane_count; ++lane)
        for (std::size_t c = 0; c < components; ++c)
          EXPECT_EQ(d[c][lane], lane < count ? packed[(first + lane) * components + c] : 0.0) << count;
      std::vector<double> back(packed.size(), 7.0), expected = back;
      std::copy_n(packed.begin() + static_cast<std::ptrdiff_t>(first * components), count * components,
                  expected.begin() + static_cast<std::ptrdiff_t>(first * components));
      store_packed(d, back.data(), at);
      EXPECT_EQ(back, expected) << count;
    }
}

TEST(LaneCellsTest, FieldsAreReadAndWrittenInTheirCellsAlone)
{
  constexpr std::size_t stride = 20;
  const std::vector<double> field = test::random_field(components * stride, 2);
  for (std::size_t count = 1; count <= lane_count; ++count)
  {
    const LaneCells at{0, stride - count, count};
    const LaneDeviators d = load_deviators(field.data(), stride, at);
    std::vector<double> back(field.size(), 7.0);
    store_deviators(d, back.data(), stride, at);
    for (std::size_t c = 0; c < components; ++c)
      for (std::size_t cell = 0; cell < stride; ++cell)
        EXPECT_EQ(back[c * stride + cell], cell < at.cell ? 7.0 : field[c * stride + cell]) << count;
  }
}

TEST(LaneCellsTest, NeighboursOfALayerAreTogetherAndEachCellIsOnce)
{
  constexpr std::size_t layer = 30;
  std::vector<std::size_t> cells(40); // 11 to 50: the layer ends at 29
  std::iota(cells.begin(), cells.end(), 11);
  cells.insert(cells.end(), {70, 71, 5, 6, 7, 9});
  std::vector<std::size_t> counts;
  std::size_t next = 2;
  for_lane_cells(cells, 2, cells.size() - 1, layer,
                 [&](const LaneCells& at)
                 {
                   EXPECT_EQ(at.a, next);
                   for (std::size_t i = 0; i < at.count; ++i)
                     EXPECT_EQ(cells[at.a + i], at.cell + i);
                   EXPECT_EQ(at.cell / layer, (at.cell + at.count - 1) / layer);
                   counts.push_back(at.count);
                   next += at.count;
                 });
  EXPECT_EQ(next, cells.size() - 1);
  std::vector<std::size_t> expected;
  for (std::size_t left : {17, 21, 2, 3}) // neighbours of a layer
    for (; left > 0; left -= expected.back())
      expected.push_back(std::min<std::size_t>(left, lane_count));
  EXPECT_EQ(counts, expected);
}

} // namespace
} // namespace brinell::elastoplastic::lane_cells_test
