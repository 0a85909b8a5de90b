// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/grid.hpp"

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

namespace brinell::elastoplastic
{

/// The cells of a body that have flowed plastically. Most cells never flow; loops over the zone skip them.
class PlasticZone
{
public:
  PlasticZone() = default;
  /// @param equivalent  plastic strain, accumulated, one value per cell of the grid
  PlasticZone(const VolumeGrid& grid, std::span<const double> equivalent);

  /// Adds a cell that has flowed.
  /// @param equivalent  accumulated equivalent plastic strain of the cell, not below earlier values
  void add(std::size_t cell, double equivalent);

  /// Range of columns in one row of a layer: from the first cell that has flowed to one past the last.
  struct Columns
  {
    std::size_t first, end;
  };
  /// @param row  counted through all layers
  [[nodiscard]] Columns columns(std::size_t row) const { return rows_[row]; }

  /// Calls use(first, last) for the cells among [first, last) of the grid that lie in the zone, row by row.
  template <typename Use>
  void for_cells(std::size_t first, std::size_t last, const Use& use) const
  {
    for (std::size_t begin = first; begin < last;)
    {
      const std::size_t row = begin / nx_, start = row * nx_, end = std::min(last, start + nx_);
      const std::size_t from = std::max(begin, start + rows_[row].first), to = std::min(end, start + rows_[row].end);
      if (from < to)
        use(from, to);
      begin = end;
    }
  }

  /// Largest accumulated equivalent plastic strain of each layer, and of all layers.
  [[nodiscard]] std::span<const double> largest_of_layers() const { return largest_; }
  [[nodiscard]] double largest() const;

private:
  std::size_t nx_ = 0, ny_ = 0;
  std::vector<Columns> rows_;
  std::vector<double> largest_;
};

} // namespace brinell::elastoplastic
