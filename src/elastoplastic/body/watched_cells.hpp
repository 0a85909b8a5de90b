// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/grid.hpp"
#include "brinell/halfspace/half_space.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace brinell::elastoplastic
{

/// Single cells that are asked for their stress, and its trace there, which plasticity does not need: it is computed along with the
/// evaluations of all cells, in the layers of cells that have been asked for before. Without the initial stress.
class WatchedCells
{
public:
  explicit WatchedCells(const VolumeGrid& grid) : grid_(grid) {}

  [[nodiscard]] bool empty() const { return cells_.empty(); }
  /// Watches cells from the next increment on.
  /// @returns whether their traces are known
  [[nodiscard]] bool watch(std::span<const std::size_t> cells);
  /// Computes the traces; to be called after the stress of an evaluation of all cells.
  void find_traces(const halfspace::HalfSpace::Loaded& strain, const halfspace::SurfaceLoad& load);
  void forget_traces() { knows_traces_ = false; }
  /// Of a watched cell whose trace is known [Pa].
  [[nodiscard]] double trace(std::size_t cell) const;

private:
  VolumeGrid grid_;
  std::vector<std::size_t> cells_; ///< in the order of the grid
  std::vector<double> trace_;
  bool knows_traces_ = false; ///< whether it is that of the present trial
};

} // namespace brinell::elastoplastic
