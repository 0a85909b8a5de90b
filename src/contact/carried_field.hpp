// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/grid.hpp"

#include <algorithm>
#include <array>
#include <span>

namespace brinell::contact
{

/// A field that surfaces carry along by whole cells: what leaves a periodic axis comes in again; over the end of an open one
/// what leaves is lost, and nothing comes in.
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
