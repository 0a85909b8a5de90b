// SPDX-License-Identifier: BSD-3-Clause
#include "watched_cells.hpp"

#include <algorithm>

namespace brinell::elastoplastic
{

namespace
{

/// The cell of the independent rows that has the same trace as a cell.
std::size_t independent_cell(const SurfaceGrid& surface, std::size_t cell)
{
  const auto nx = static_cast<std::size_t>(surface.nx), row = cell / nx;
  if (static_cast<int>(row) < surface.independent_rows())
    return cell;
  return (static_cast<std::size_t>(surface.ny) - 1 - row) * nx + cell % nx;
}

} // namespace

bool WatchedCells::watch(std::span<const std::size_t> cells)
{
  const auto is_watched = [&](std::size_t cell) { return std::ranges::binary_search(cells_, cell); };
  if (std::ranges::all_of(cells, is_watched))
    return knows_traces_;
  cells_.insert(cells_.end(), cells.begin(), cells.end());
  std::ranges::sort(cells_);
  cells_.erase(std::unique(cells_.begin(), cells_.end()), cells_.end());
  knows_traces_ = false;
  return false;
}

void WatchedCells::find_traces(const halfspace::HalfSpace::Loaded& strain, const halfspace::SurfaceLoad& load)
{
  const std::size_t plane = grid_.surface.size();
  std::vector<double> layer(plane);
  std::size_t known = grid_.size();
  trace_.resize(cells_.size());
  for (std::size_t n = 0; n < cells_.size(); ++n) // in the order of the layers
  {
    if (const std::size_t wanted = cells_[n] / plane; wanted != known)
    {
      strain.trace(load, static_cast<int>(wanted), layer);
      known = wanted;
    }
    trace_[n] = layer[independent_cell(grid_.surface, cells_[n] % plane)];
  }
  knows_traces_ = true;
}

double WatchedCells::trace(std::size_t cell) const
{
  const auto place = std::ranges::lower_bound(cells_, cell) - cells_.begin();
  return trace_[static_cast<std::size_t>(place)];
}

} // namespace brinell::elastoplastic
