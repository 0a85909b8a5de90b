// SPDX-License-Identifier: BSD-3-Clause
// Regions that inclusions fill, in cells.
#include "brinell/simulation/inclusion_shape.hpp"

#include "brinell/foundation/error.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

namespace brinell::simulation::inclusion_shape_test
{
namespace
{

const VolumeGrid grid{{60, 50, 0.1, 0.12}, 50, 0.11};
constexpr double x0 = -2.95, y0 = -2.94; // the middle of the grid is at x = y = 0

double volume(const std::vector<std::size_t>& cells)
{
  return static_cast<double>(cells.size()) * grid.cell_volume();
}

// Cells of some fifteenth of an axis: the volume errs by what cells at the surface, each in or out as a whole, do not cancel.
TEST(InclusionShape, CellsHaveTheVolumeOfTheShape)
{
  using Kind = InclusionShape::Kind;
  for (const Kind kind : {Kind::ellipsoid, Kind::cuboid, Kind::cylinder})
    for (const int axis : {0, 1, 2})
    {
      const InclusionShape shape{kind, {0.313, -0.271, 2.45}, {1.97, 1.43, 1.62}, axis};
      EXPECT_NEAR(volume(cells_of(shape, grid, x0, y0)), shape.volume(), 0.05 * shape.volume());
    }
}

TEST(InclusionShape, CylinderLiesAlongItsAxis)
{
  const InclusionShape rod{InclusionShape::Kind::cylinder, {0.0, 0.0, 2.0}, {2.0, 0.5, 0.5}, 0};
  EXPECT_TRUE(rod.contains(1.9, 0.3, 2.3));    // beside the axis, near the end: not in an ellipsoid
  EXPECT_FALSE(rod.contains(1.9, 0.45, 2.45)); // in the corner of the box
  EXPECT_FALSE(rod.contains(2.1, 0.0, 2.0));
}

// Cells whose centre is on a face count once, wherever the grid begins: a cuboid of the period fills the layer.
TEST(InclusionShape, ACuboidOfThePeriodFillsIt)
{
  for (const int n : {15, 16})
    for (const double shift : {0.0, 0.5, 1.0})
    {
      const VolumeGrid layer{{n, n, 0.1, 0.1, Boundary::periodic, Boundary::periodic}, 4, 0.1};
      const double half = 0.05 * n, first = (shift - (n - 1) / 2) * 0.1;
      const InclusionShape whole{InclusionShape::Kind::cuboid, {0.0, 0.0, 0.2}, {half, half, 0.05}};
      EXPECT_EQ(cells_of(whole, layer, first, first).size(), static_cast<std::size_t>(n * n));
      InclusionVoxels voxels{{n, n, 1}, {-half, -half, 0.15}, 0.1, {}};
      voxels.is_filled.assign(static_cast<std::size_t>(n * n), 1);
      EXPECT_EQ(cells_of(voxels, layer, first, first).size(), static_cast<std::size_t>(n * n));
    }
}

TEST(InclusionShape, CuboidsThatTouchShareNoCellAndLeaveNone)
{
  for (const int n : {15, 16})
  {
    const VolumeGrid layer{{n, n, 0.1, 0.1, Boundary::periodic, Boundary::periodic}, 4, 0.1};
    const double half = 0.05 * n, first = -((n - 1) / 2) * 0.1;
    std::set<std::size_t> cells;
    for (const double side : {-1.0, 1.0})
      for (const std::size_t cell :
           cells_of({InclusionShape::Kind::cuboid, {0.5 * side * half, 0.0, 0.2}, {0.5 * half, half, 0.2}}, layer,
                    first, first))
        EXPECT_TRUE(cells.insert(cell).second);
    EXPECT_EQ(cells.size(), layer.size());
  }
}

// A row without cells along y is a section of something that does not vary along y.
TEST(InclusionShape, InPlaneStrainThePlaceAlongYDoesNotMatter)
{
  const VolumeGrid plane{{16, 1, 0.1, 1.0, Boundary::open, Boundary::periodic}, 4, 0.1};
  const InclusionShape bar{InclusionShape::Kind::cylinder, {0.0, 0.2, 0.2}, {0.15, 0.05, 0.15}, 1};
  EXPECT_FALSE(cells_of(bar, plane, -0.7, 0.0).empty());
}

// A ball whose middle lies in the surface is half a ball; one beyond the grid has no cells.
TEST(InclusionShape, EndsAtTheSurfaceAndAtTheGrid)
{
  InclusionShape ball{InclusionShape::Kind::ellipsoid, {0.0, 0.0, 0.0}, {1.5, 1.5, 1.5}};
  EXPECT_NEAR(volume(cells_of(ball, grid, x0, y0)), 0.5 * ball.volume(), 0.05 * ball.volume());
  ball.centre = {9.0, 0.0, 2.0};
  EXPECT_TRUE(cells_of(ball, grid, x0, y0).empty());
  EXPECT_NEAR(cells_per_axis(ball, grid), 12.5, 1e-12);
}

TEST(InclusionShape, ClusterIsTheSameForASeedAndDoesNotOverlap)
{
  const InclusionCluster cluster{{0.5, 0.0, 2.5}, {2.0, 2.0, 1.5}, 0.2, 0.4, 30, 0.05, 7};
  const std::vector<InclusionShape> balls = shapes_of(cluster), again = shapes_of(cluster);
  ASSERT_EQ(balls.size(), 30U);
  InclusionCluster other = cluster;
  other.seed = 8;
  EXPECT_NE(shapes_of(other).front().centre, balls.front().centre);
  std::set<std::size_t> cells;
  for (std::size_t a = 0; a < balls.size(); ++a)
  {
    EXPECT_EQ(balls[a].centre, again[a].centre);
    const double r = balls[a].semi_axes[0];
    for (std::size_t i = 0; i < 3; ++i)
      EXPECT_LE(std::abs(balls[a].centre[i] - cluster.centre[i]) + r, cluster.half_sides[i] + 1e-12);
    for (std::size_t b = 0; b < a; ++b)
      EXPECT_GE(std::hypot(balls[a].centre[0] - balls[b].centre[0], balls[a].centre[1] - balls[b].centre[1],
                           balls[a].centre[2] - balls[b].centre[2]),
                r + balls[b].semi_axes[0] + cluster.gap);
    for (const std::size_t cell : cells_of(balls[a], grid, x0, y0))
      EXPECT_TRUE(cells.insert(cell).second);
  }
}

// Each ball asks only its neighbours: with the distances of all pairs this would take minutes.
TEST(InclusionShape, AClusterMayHaveManyBalls)
{
  const InclusionCluster cluster{{0.0, 0.0, 1.0}, {1.0, 1.0, 1.0}, 0.004, 0.006, 100000, 0.0, 3};
  EXPECT_EQ(shapes_of(cluster).size(), 100000U);
}

TEST(InclusionShape, VoxelsFillTheCellsInThem)
{
  // Voxels of three cells along x, two filled ones with an empty one between.
  InclusionVoxels voxels{{3, 1, 1}, {0.0, 0.0, 0.55}, 0.3, {1, 0, 1}};
  const std::vector<std::size_t> cells = cells_of(voxels, grid, x0, y0);
  std::set<int> columns;
  for (const std::size_t cell : cells)
    columns.insert(static_cast<int>(cell % 60));
  EXPECT_EQ(columns, (std::set<int>{30, 31, 32, 36, 37, 38}));
  voxels.is_filled.pop_back();
  EXPECT_THROW((void)cells_of(voxels, grid, x0, y0), InputError);
}

TEST(InclusionShape, RefusesWhatHasNoPlace)
{
  EXPECT_THROW((void)cells_of(InclusionShape{InclusionShape::Kind::cuboid, {}, {1.0, 0.0, 1.0}}, grid, x0, y0),
               InputError);
  EXPECT_THROW((void)shapes_of({{}, {1.0, 1.0, 1.0}, 0.4, 0.5, 100, 0.0, 1}), InputError);
  EXPECT_THROW((void)shapes_of({{}, {1.0, 1.0, 1.0}, 2.0, 2.0, 1, 0.0, 1}), InputError);
  EXPECT_THROW((void)shapes_of({{}, {1.0, 1.0, 1.0}, 0.5, 0.4, 1, 0.0, 1}), InputError);
}

} // namespace
} // namespace brinell::simulation::inclusion_shape_test
