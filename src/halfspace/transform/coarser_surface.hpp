// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/grid.hpp"

#include <array>
#include <span>
#include <vector>

namespace brinell::halfspace
{

/// A grid with the same middle as a finer one and cells twice as long along open axes. Smooth fields are interpolated from the
/// coarse to the fine cells by cubics; loads are transferred from the fine to the coarse cells by the transpose of the
/// interpolation, which conserves all moments up to the third. Loads on the fine cells reach `margin` coarse cells beyond the
/// ends of the fine grid. The coarse cells are symmetric about the middle, so that even and odd fields stay even and odd.
class CoarserSurface
{
public:
  static constexpr int margin = 4;

  CoarserSurface(const SurfaceGrid& finer, int finer_margin)
      : CoarserSurface(finer, {finer_margin, finer_margin}, {true, true})
  {
  }
  /// @param margins  number of cells that the fine grid itself has beyond the ends of the original grid, along x and y: 0 or
  ///                 `margin`
  /// @param coarser  whether the cells become twice as long, along x and y; along a periodic axis they never do
  CoarserSurface(const SurfaceGrid& finer, const std::array<int, 2>& margins, const std::array<bool, 2>& coarser);

  [[nodiscard]] const SurfaceGrid& grid() const { return coarse_; }
  /// Margins of the coarse grid, to construct the next coarser one.
  [[nodiscard]] std::array<int, 2> margins() const { return margins_; }
  [[nodiscard]] std::vector<double> from_finer(std::span<const double> load) const; ///< mean over the coarse cells
  [[nodiscard]] std::vector<double> to_finer(std::span<const double> field) const;
  /// As above, without allocating memory if the vectors are large enough.
  /// @param room  buffer for intermediate values
  void to_finer(std::span<const double> field, std::vector<double>& room, std::vector<double>& result) const;

private:
  /// Interpolation of one fine cell along one axis: it lies between the second and the third of four coarse cells.
  struct Between
  {
    int first;
    std::array<double, 4> weights;
  };
  using Axis = std::vector<Between>; ///< empty: the cells along this axis are not coarsened
  [[nodiscard]] static Axis axis(int fine, int coarse);

  SurfaceGrid fine_, coarse_;
  std::array<int, 2> margins_;
  Axis x_, y_;
};

/// Padded length in cells of an open axis: large enough that half of it holds the loads at every level of coarsening.
/// @param begins_coarser  if the first coarsening is by four: large enough that a quarter holds them; a multiple of four
[[nodiscard]] int memory_length(int cells, bool begins_coarser = false);
/// Whether a quarter of the padded length holds the loads with their margins on cells four times as long, at no more than twice
/// the cells.
[[nodiscard]] bool is_long(int cells);

} // namespace brinell::halfspace
