// SPDX-License-Identifier: BSD-3-Clause
#include "surface_distance.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

namespace brinell::simulation
{

CellPlaces places_in_run(const SurfaceGrid& grid, double place)
{
  const int before = (grid.nx - 1) / 2; // columns before the middle one
  const double middle = std::round(place / grid.dx) * grid.dx;
  return {.x = -before * grid.dx + (middle - place), .y = grid.y(0), .lower = place, .upper = 0.0};
}

std::vector<double> texture_distance(const ShapedBody& lower, const ShapedBody& upper, const SurfaceGrid& grid,
                                     const CellPlaces& at, ReadTexture* read)
{
  std::vector<double> distance = read(lower.texture, grid, at.lower + at.x, at.y);
  const std::vector<double> of_upper = read(upper.texture, grid, at.upper + at.x, at.y);
  std::transform(distance.begin(), distance.end(), of_upper.begin(), distance.begin(), std::plus<>());
  return distance;
}

std::vector<double> surface_distance(const ShapedBody& lower, const ShapedBody& upper, const SurfaceGrid& grid,
                                     const CellPlaces& at, ReadTexture* read)
{
  std::vector<double> distance = texture_distance(lower, upper, grid, at, read);
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i)
    {
      const double x = at.x + i * grid.dx, y = at.y + j * grid.dy;
      distance[grid.index(i, j)] += height(lower.shape, x, y) + height(upper.shape, x, y);
    }
  return distance;
}

} // namespace brinell::simulation
