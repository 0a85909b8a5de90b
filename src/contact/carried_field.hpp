// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/grid.hpp"

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

} // namespace brinell::contact
