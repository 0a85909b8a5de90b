// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/contact/tangential_contact.hpp"
#include "brinell/foundation/grid.hpp"
#include "friction_discs.hpp"

#include <algorithm>
#include <array>
#include <span>

namespace brinell::contact
{

/// Shifts a field by whole cells, as the moving surfaces carry it along. Along a periodic axis the values wrap around; along an
/// open axis values that leave the grid are lost, and zeros enter.
inline void carry(const SurfaceGrid& grid, const std::array<int, 2>& cells, std::span<const double> from,
                  std::span<double> to)
{
  std::fill(to.begin(), to.end(), 0.0);
  const auto place = [](int i, int count, bool is_periodic) { return is_periodic ? (i % count + count) % count : i; };
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i)
    {
      const int column = place(i + cells[0], grid.nx, grid.is_periodic_x());
      const int row = place(j + cells[1], grid.ny, grid.is_periodic_y());
      if (column >= 0 && column < grid.nx && row >= 0 && row < grid.ny)
        to[grid.index(column, row)] = from[grid.index(i, j)];
    }
}

/// Displacement by a spin of the point that lies in a cell after a step, as it moves there through the contact [m].
inline Along turned(const SurfaceGrid& grid, const std::array<int, 2>& carried, double spin, int column, int row)
{
  return {-spin * (grid.y(row) - 0.5 * carried[1] * grid.dy), spin * (grid.x(column) - 0.5 * carried[0] * grid.dx)};
}

} // namespace brinell::contact
