// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/grid.hpp"

#include <array>
#include <cstddef>
#include <vector>

namespace brinell::halfspace
{

/// Means over cells, to third order in the cells, of a field with values at their middles: the stencil (1, 22, 1)/24 along x and y. Beside the
/// edge of the grid the value at the edge counts once more. The matrix of the means of all cells is symmetric, so that the same weights spread values of
/// cells over their neighbours. On a mirrored grid only the independent rows of fields are read and written, and fields are even (parity 1) or
/// odd (-1).
class CellMeans
{
public:
  CellMeans() = default; ///< of no cells
  /// @param cells  of a volume with this surface, on a mirrored grid in independent rows
  CellMeans(const SurfaceGrid& grid, const std::vector<std::size_t>& cells);

  /// Mean over cell number `i`.
  [[nodiscard]] double mean(const double* field, double parity, std::size_t i) const;
  /// Adds to a field what the means over all cells have of a value in cell number `i`, and of its mirror image.
  void spread(double value, double parity, std::size_t i, double* field) const;
  /// Makes a field zero wherever `spread` may have written.
  void clear(double* field) const;

private:
  static constexpr std::size_t each = 9; ///< neighbours of a cell, itself included
  struct Neighbour
  {
    std::size_t cell = 0;
    double read = 0.0, read_image = 0.0;       ///< weights of the cell and of its mirror image in the mean
    double written = 0.0, written_image = 0.0; ///< of the value and of its mirror image in the neighbour
  };
  std::vector<std::array<Neighbour, each>> neighbours_;
};

} // namespace brinell::halfspace
