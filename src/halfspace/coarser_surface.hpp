// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/grid.hpp"

#include <array>
#include <span>
#include <vector>

namespace brinell::halfspace
{

/// A surface on cells twice as long along the axes that are open, with the same middle: what is smooth is interpolated from them by
/// cubics, and loads come to them by the transpose, which keeps all moments up to the third. Loads on the fine cells reach
/// `margin` coarse cells beyond the ends of the fine grid. The cells lie alike on both sides of the middle, so that what is
/// even or odd about it stays so.
class CoarserSurface
{
public:
  static constexpr int margin = 4;

  CoarserSurface(const SurfaceGrid& finer, int finer_margin)
      : CoarserSurface(finer, {finer_margin, finer_margin}, {true, true})
  {
  }
  /// @param margins  cells that the fine grid itself has beyond the ends of what it stands for, along x and y: 0 or `margin`
  /// @param coarser  along which axes the cells become twice as long; of a periodic one they never do
  CoarserSurface(const SurfaceGrid& finer, const std::array<int, 2>& margins, const std::array<bool, 2>& coarser);

  [[nodiscard]] const SurfaceGrid& grid() const { return coarse_; }
  /// That of this grid, to go on from.
  [[nodiscard]] std::array<int, 2> margins() const { return margins_; }
  [[nodiscard]] std::vector<double> from_finer(std::span<const double> load) const; ///< mean over the coarse cells
  [[nodiscard]] std::vector<double> to_finer(std::span<const double> field) const;
  /// The same, without new memory.
  /// @param room  for what is in between
  void to_finer(std::span<const double> field, std::vector<double>& room, std::vector<double>& result) const;

private:
  /// Where the fine cells of one axis are among the coarse ones: each between the second and the third of four.
  struct Between
  {
    int first;
    std::array<double, 4> weights;
  };
  using Axis = std::vector<Between>; ///< empty: its cells stay as they are
  [[nodiscard]] static Axis axis(int fine, int coarse);

  SurfaceGrid fine_, coarse_;
  std::array<int, 2> margins_;
  Axis x_, y_;
};

/// Cells of an open axis with its padding: a number that holds all loads on coarser and coarser cells in half of them.
/// @param begins_coarser  in a quarter, on cells that are twice as coarse from the first ones on: a multiple of four
[[nodiscard]] int memory_length(int cells, bool begins_coarser = false);
/// Whether that takes no more than twice the cells: their quarter holds the ends of cells that are four times as long.
[[nodiscard]] bool is_long(int cells);

} // namespace brinell::halfspace
