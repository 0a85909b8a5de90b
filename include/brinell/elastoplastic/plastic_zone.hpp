// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/grid.hpp"

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

namespace brinell::elastoplastic
{

/// Where a body has flowed: most of its cells never do, and need not be looked at for it.
class PlasticZone
{
public:
  PlasticZone() = default;
  /// @param equivalent  plastic strain, accumulated, one value per cell of the grid
  PlasticZone(const VolumeGrid& grid, std::span<const double> equivalent);

  /// A cell has flowed. @param equivalent  its plastic strain now, accumulated; it never falls
  void add(std::size_t cell, double equivalent);

  /// Columns of one row of a layer, from the first cell that has flowed to the one behind the last.
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

  /// Accumulated equivalent plastic strain: the largest of each layer, and of all.
  [[nodiscard]] std::span<const double> largest_of_layers() const { return largest_; }
  [[nodiscard]] double largest() const;

private:
  std::size_t nx_ = 0, ny_ = 0;
  std::vector<Columns> rows_;
  std::vector<double> largest_;
};

} // namespace brinell::elastoplastic
