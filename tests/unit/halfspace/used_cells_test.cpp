// SPDX-License-Identifier: BSD-3-Clause
// Cells without strain, which evaluations leave out.
#include "halfspace/transform/used_cells.hpp"

#include "brinell/foundation/symmetry.hpp"
#include "brinell/halfspace/half_space.hpp"
#include "grid_fields.hpp"
#include "mirrored_grid.hpp"
#include "random_field.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace brinell::halfspace::used_cells_test
{
namespace
{

using Field = std::vector<double>;
using test::largest_difference;

TEST(UsedCells, AreTheSmallestRectangle)
{
  constexpr int nx = 19, ny = 7;
  Field plane(nx * ny, 0.0);
  const auto used = [&] { return used_cells(plane.data(), nx, ny); };
  EXPECT_TRUE(used().is_empty());
  plane[2] = -0.0;
  EXPECT_TRUE(used().is_empty());
  plane[2 * nx + 11] = 1e-300;
  plane[4 * nx + 5] = -1.0;
  plane[4 * nx + 7] = std::numeric_limits<double>::quiet_NaN();
  const CellRectangle some = used();
  EXPECT_EQ(some.first_x, 5);
  EXPECT_EQ(some.end_x, 12);
  EXPECT_EQ(some.first_y, 2);
  EXPECT_EQ(some.end_y, 5);
  plane.front() = plane.back() = 1.0;
  const CellRectangle all = used();
  EXPECT_EQ(all.first_x, 0);
  EXPECT_EQ(all.end_x, nx);
  EXPECT_EQ(all.first_y, 0);
  EXPECT_EQ(all.end_y, ny);
}

/// Random within a rectangle of each component in each layer, some of them empty, some at an edge; mirrored about y = 0.
Field strain_in_few_cells(const VolumeGrid& grid, double elsewhere)
{
  const SurfaceGrid& s = grid.surface;
  Field strain = test::random_field(Deviator::size * grid.size(), 7);
  for (int c = 0; c < Deviator::size; ++c)
    for (int k = 0; k < grid.nz; ++k)
    {
      const int first_x = (5 * c + 3 * k) % s.nx, end_x = first_x + 1 + (k + c) % 9;
      const int first_y = (2 * c + k) % ((s.ny + 1) / 2), end_y = first_y + (k + 2 * c) % 4;
      for (int j = 0; j < s.ny; ++j)
        for (int i = 0; i < s.nx; ++i)
          if (i < first_x || i >= end_x || j < first_y || j >= end_y || k == grid.nz - 1)
            strain[static_cast<std::size_t>(c) * grid.size() + grid.index(i, j, k)] = elsewhere;
          else if (is_odd_in_y(c) && 2 * j == s.ny - 1)
            strain[static_cast<std::size_t>(c) * grid.size() + grid.index(i, j, k)] = 0.0;
    }
  complete_in_y(grid, strain);
  return strain;
}

struct Answer
{
  Field stress, displacement;
};

Answer answer(const HalfSpace& half_space, const Field& strain)
{
  const VolumeGrid& grid = half_space.grid();
  HalfSpace::Work work = half_space.make_work();
  Answer result{Field(Deviator::size * grid.size()), Field(grid.surface.size())};
  const HalfSpace::Loaded loaded = half_space.load(strain, grid.nz, work);
  loaded.displacement({.z = result.displacement});
  loaded.stress({}, result.stress);
  return result;
}

class StrainInFewCellsTest : public testing::TestWithParam<VolumeGrid>
{
};

INSTANTIATE_TEST_SUITE_P(Grids, StrainInFewCellsTest,
                         testing::Values(VolumeGrid{{33, 13, 0.5, 1.0}, 7, 0.25},
                                         VolumeGrid{{20, 12, 0.7, 0.9}, 6, 0.4},
                                         VolumeGrid{{75, 25, 0.7, 0.9}, 5, 0.4},  // long in x
                                         VolumeGrid{{9, 50, 0.7, 0.9}, 5, 0.4})); // long in y

/// A strain that is too small to change any sum, in all other cells: nothing is left out, and nothing else changes.
TEST_P(StrainInFewCellsTest, TheOthersAreLeftOutWithoutAChange)
{
  for (const bool is_mirrored : {false, true})
  {
    const HalfSpace half_space(test::mirrored(GetParam(), is_mirrored), {1.3, 0.28});
    const Answer few = answer(half_space, strain_in_few_cells(GetParam(), 0.0));
    const Answer all = answer(half_space, strain_in_few_cells(GetParam(), 1e-200));
    constexpr double rounding = 1e-14;
    EXPECT_LE(largest_difference(few.stress, all.stress), rounding * test::largest(all.stress));
    EXPECT_LE(largest_difference(few.displacement, all.displacement), rounding * test::largest(all.displacement));
  }
}

/// Buffers that have held more strain before.
TEST(StrainInFewCells, IsNotMixedWithWhatWasLoadedBefore)
{
  const VolumeGrid grid{{33, 13, 0.5, 1.0}, 7, 0.25};
  const Field few = strain_in_few_cells(grid, 0.0), more = strain_in_few_cells(grid, 0.5);
  for (const bool is_mirrored : {false, true})
  {
    const HalfSpace half_space(test::mirrored(grid, is_mirrored), {1.3, 0.28});
    HalfSpace::Work work = half_space.make_work();
    Answer result{Field(few.size()), Field(grid.surface.size())};
    for (const Field* strain : {&more, &few})
    {
      const HalfSpace::Loaded loaded = half_space.load(*strain, grid.nz, work);
      loaded.displacement({.z = result.displacement});
      loaded.stress({}, result.stress);
    }
    const Answer fresh = answer(half_space, few);
    EXPECT_EQ(result.displacement, fresh.displacement);
    EXPECT_EQ(largest_difference(result.stress, fresh.stress), 0.0);
  }
}

} // namespace
} // namespace brinell::halfspace::used_cells_test
