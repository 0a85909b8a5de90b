// SPDX-License-Identifier: BSD-3-Clause
#include "roughness.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace brinell::simulation
{

double Roughness::wavelength() const
{
  return slope > 0.0 ? 2.0 * std::numbers::pi * height / slope : 0.0;
}

Roughness roughness_of(std::span<const double> heights, const SurfaceGrid& grid)
{
  double mean = 0.0;
  for (const double h : heights)
    mean += h / static_cast<double>(heights.size());
  // Points that have a next one, around the period if there is one.
  const int last_x = grid.is_periodic_x() ? grid.nx : grid.nx - 1;
  const int last_y = grid.is_periodic_y() ? grid.ny : grid.ny - 1;
  double squares = 0.0;
  double slopes_x = 0.0;
  double slopes_y = 0.0;
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i)
    {
      const double here = heights[grid.index(i, j)];
      squares += std::pow(here - mean, 2);
      slopes_x += i < last_x ? std::pow((heights[grid.index((i + 1) % grid.nx, j)] - here) / grid.dx, 2) : 0.0;
      slopes_y += j < last_y ? std::pow((heights[grid.index(i, (j + 1) % grid.ny)] - here) / grid.dy, 2) : 0.0;
    }
  const double count_x = std::max(1.0, static_cast<double>(last_x) * grid.ny);
  const double count_y = std::max(1.0, static_cast<double>(last_y) * grid.nx);
  return {std::sqrt(squares / static_cast<double>(heights.size())), std::sqrt(slopes_x / count_x + slopes_y / count_y)};
}

} // namespace brinell::simulation
