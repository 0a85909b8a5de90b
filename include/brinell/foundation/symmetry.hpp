// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/deviator.hpp"
#include "brinell/foundation/grid.hpp"

#include <vector>

/// Fields on grids whose two sides of the plane y = 0 are mirror images of each other: `SurfaceGrid::is_mirrored_y`.
namespace brinell
{

/// Index of the mirror image of a cell: the cell of the same layer and column on the other side.
[[nodiscard]] inline std::size_t mirrored_cell(const SurfaceGrid& grid, std::size_t cell)
{
  const auto nx = static_cast<std::size_t>(grid.nx), ny = static_cast<std::size_t>(grid.ny);
  const std::size_t row = cell / nx % ny;
  return cell + (ny - 1 - 2 * row) * nx; // wraps where the difference is negative
}

/// Copies the independent rows of a scalar field on a surface or in a volume, even or odd, to the other side.
/// @param factor  1 for an even field, -1 for an odd field
inline void complete_in_y(const SurfaceGrid& grid, double factor, double* field, std::size_t cells)
{
  const auto nx = static_cast<std::size_t>(grid.nx);
  for (double* layer = field; layer != field + cells; layer += grid.size())
    for (int j = 0; 2 * j + 1 < grid.ny; ++j)
    {
      const double* from = layer + grid.index(0, j);
      double* to = layer + grid.index(0, grid.ny - 1 - j);
      for (std::size_t i = 0; i < nx; ++i)
        to[i] = factor * from[i];
    }
}

/// Copies the independent rows of a field of deviators to the other side.
inline void complete_in_y(const VolumeGrid& grid, std::vector<double>& deviators)
{
  for (int c = 0; c < Deviator::size; ++c)
    complete_in_y(grid.surface, is_odd_in_y(c) ? -1.0 : 1.0,
                  deviators.data() + static_cast<std::size_t>(c) * grid.size(), grid.size());
}

} // namespace brinell
