// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/grid.hpp"

#include <array>
#include <functional>
#include <vector>

namespace brinell::halfspace
{

/// Which pairs of cells stand at the places of a kernel along both axes.
struct KernelPlaces
{
  /// Along one axis: the offset of the cell whose response stands at a place, and how much of it.
  struct Share
  {
    int offset;
    double weight;
  };
  /// The shares of one place; the second one may weigh nothing.
  using Shares = std::array<Share, 2>;
  std::vector<Shares> x, y;

  /// Of a kernel so long that it is the linear convolution on the grid.
  [[nodiscard]] static KernelPlaces padded(const SurfaceGrid& grid);
  /// Of the nearest operator that is periodic on the grid: the mean over the pairs of cells that a period takes for the same
  /// (T. Chan 1988).
  [[nodiscard]] static KernelPlaces periodic(const SurfaceGrid& grid);
};

/// Spectrum of a kernel, row by row, [ny / 2 + 1][nx / 2 + 1] of the numbers of places: its real part, which is all of one that
/// is even in both axes, or odd in both.
/// @param response  of the cell at an offset
[[nodiscard]] std::vector<double> spectrum_of(const SurfaceGrid& grid, const KernelPlaces& places,
                                              const std::function<double(int, int)>& response);

/// The grid with open axes made longer for fast transforms of their own length.
[[nodiscard]] SurfaceGrid with_fast_lengths(SurfaceGrid grid);

} // namespace brinell::halfspace
