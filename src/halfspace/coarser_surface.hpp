// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/grid.hpp"

#include <span>
#include <vector>

namespace brinell::halfspace
{

/// A surface on cells twice as long along the axes that are open: what is smooth is interpolated from them by cubics, and loads
/// come to them by the transpose, which keeps all moments up to the third. Loads on the fine cells reach `margin` coarse
/// cells beyond the ends of the fine grid.
class CoarserSurface
{
public:
  static constexpr int margin = 4;

  /// @param finer_margin  cells that the fine grid itself has beyond the ends of what it stands for: 0 or `margin`
  CoarserSurface(const SurfaceGrid& finer, int finer_margin);

  [[nodiscard]] const SurfaceGrid& grid() const { return coarse_; }
  [[nodiscard]] std::vector<double> from_finer(std::span<const double> load) const; ///< mean over the coarse cells
  [[nodiscard]] std::vector<double> to_finer(std::span<const double> field) const;

private:
  /// Where the cells of one axis are, coarse ones seen from fine ones.
  struct Axis
  {
    int fine = 0, coarse = 0, fine_margin = 0;
    bool is_coarser = false;
    [[nodiscard]] int first_of(int cell) const; ///< of four coarse cells about a fine one
  };

  SurfaceGrid fine_, coarse_;
  Axis x_, y_;
};

/// Cells of an open axis with its padding: an even number that holds all loads on coarser and coarser cells in half of them.
[[nodiscard]] int memory_length(int cells);

} // namespace brinell::halfspace
