// SPDX-License-Identifier: BSD-3-Clause
#include "elastoplastic/body/surface_means.hpp"

#include "random_field.hpp"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

namespace brinell::elastoplastic::surface_means_test
{
namespace
{

/// Sum over the box around a cell, cell by cell.
double direct_mean(const VolumeGrid& grid, const std::vector<double>& xz, int i, int j, int layer)
{
  const SurfaceGrid& s = grid.surface;
  double sum = 0.0;
  for (int dj = -SurfaceMeans::half_y; dj <= SurfaceMeans::half_y; ++dj)
    for (int di = -SurfaceMeans::half_x; di <= SurfaceMeans::half_x; ++di)
    {
      int ii = i + di, jj = j + dj;
      if (s.is_periodic_x())
        ii = ((ii % s.nx) + s.nx) % s.nx;
      if (s.is_periodic_y())
        jj = ((jj % s.ny) + s.ny) % s.ny;
      if (ii >= 0 && ii < s.nx && jj >= 0 && jj < s.ny)
        sum += xz[grid.index(ii, jj, layer)];
    }
  return sum / ((2 * SurfaceMeans::half_x + 1) * (2 * SurfaceMeans::half_y + 1));
}

TEST(SurfaceMeansTest, AreThoseOfTheCellsAround)
{
  for (const Boundary boundary : {Boundary::open, Boundary::periodic})
    for (const auto& [nx, ny] : {std::pair{23, 12}, std::pair{7, 3}, std::pair{17, 9}})
    {
      const VolumeGrid grid{{nx, ny, 1.0, 1.0, boundary, boundary}, 6, 1.0};
      std::vector<double> xz = test::random_field(grid.size(), 3), yz = test::random_field(grid.size(), 4);
      SurfaceMeans means(grid);
      for (std::size_t cell = 0; cell < grid.size(); ++cell)
      {
        ASSERT_EQ(means.contains(cell), cell < SurfaceMeans::layers * grid.surface.size());
        if (means.contains(cell))
          means.set(cell, {{9.0, 9.0, yz[cell], xz[cell], 9.0}});
      }
      means.average();
      const Deviator with{{5.0, 5.0, 0.25, 2.0, 5.0}};
      for (int layer = 0; layer < SurfaceMeans::layers; ++layer)
        for (int j = 0; j < ny; ++j)
          for (int i = 0; i < nx; ++i)
            EXPECT_NEAR(means.contracted(grid.index(i, j, layer), with),
                        2.0 * (2.0 * direct_mean(grid, xz, i, j, layer) + 0.25 * direct_mean(grid, yz, i, j, layer)),
                        1e-13)
                << i << ", " << j << ", " << layer;
    }
}

TEST(SurfaceMeansTest, TakeAsMuchOneWayAsTheOther)
{
  // Goals precondition conjugate gradients: what they make of a residual must be symmetric.
  const VolumeGrid grid{{20, 11, 1.0, 1.0}, 3, 1.0};
  const auto response = [&](std::size_t from, std::size_t to)
  {
    SurfaceMeans means(grid);
    means.set(from, {{0.0, 0.0, 0.3, 1.0, 0.0}});
    means.average();
    return means.contracted(to, {{0.0, 0.0, 0.3, 1.0, 0.0}});
  };
  const std::size_t corner = grid.index(0, 0, 1), inner = grid.index(5, 3, 1);
  EXPECT_GT(response(corner, inner), 0.0);
  EXPECT_DOUBLE_EQ(response(corner, inner), response(inner, corner));
  EXPECT_EQ(response(corner, grid.index(5, 3, 2)), 0.0); // each layer by itself
}

} // namespace
} // namespace brinell::elastoplastic::surface_means_test
