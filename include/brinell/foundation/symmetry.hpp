// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/deviator.hpp"
#include "brinell/foundation/grid.hpp"

#include <vector>

namespace brinell
{

/// What is known of all fields of a body beforehand.
enum class Symmetry
{
  none,
  /// The two sides of the plane y = 0 in the middle of the grid, rows j and ny - 1 - j, are mirror images of each other. Then the
  /// rows up to the middle one tell all: docs/theory/half-space.md (symmetry).
  in_y
};

/// Whether a component of a symmetric field changes its sign from one side to the other.
[[nodiscard]] constexpr bool is_odd_in_y(int component)
{
  return component == Deviator::yz || component == Deviator::xy;
}

/// Rows that tell all: those of one side, and with an odd number of rows the middle one.
[[nodiscard]] inline int independent_rows(const SurfaceGrid& grid, Symmetry symmetry)
{
  return symmetry == Symmetry::none ? grid.ny : (grid.ny + 1) / 2;
}

/// How many rows are like one of those that tell all, itself among them.
[[nodiscard]] inline int copies_of_row(const SurfaceGrid& grid, Symmetry symmetry, int row)
{
  return symmetry == Symmetry::none || 2 * row + 1 == grid.ny ? 1 : 2;
}

/// The cell of the same layer and column on the other side.
[[nodiscard]] inline std::size_t mirrored_cell(const SurfaceGrid& grid, std::size_t cell)
{
  const auto nx = static_cast<std::size_t>(grid.nx), ny = static_cast<std::size_t>(grid.ny);
  const std::size_t row = cell / nx % ny;
  return cell + (ny - 1 - 2 * row) * nx; // wraps where the difference is negative
}

/// The same place of a tensor on the other side.
[[nodiscard]] inline Deviator mirrored_in_y(Deviator d)
{
  for (const int c : {Deviator::yz, Deviator::xy})
    d[c] = -d[c];
  return d;
}

/// Copies the independent rows of a scalar field on a surface or in a volume, even or odd, to the other side.
/// @param factor  1 of an even field, -1 of an odd one
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

/// The same for a field of deviators.
inline void complete_in_y(const VolumeGrid& grid, std::vector<double>& deviators)
{
  for (int c = 0; c < Deviator::size; ++c)
    complete_in_y(grid.surface, is_odd_in_y(c) ? -1.0 : 1.0,
                  deviators.data() + static_cast<std::size_t>(c) * grid.size(), grid.size());
}

} // namespace brinell
