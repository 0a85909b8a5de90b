// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/grid.hpp"

#include <array>
#include <functional>
#include <vector>

namespace brinell::halfspace
{

/// Offsets between cells that the entries of a discrete kernel represent, along both axes.
struct KernelPlaces
{
  /// Along one axis: an offset whose response contributes to an entry of the kernel, and its weight.
  struct Share
  {
    int offset;
    double weight;
  };
  /// The contributions to one entry; the weight of the second one may be zero.
  using Shares = std::array<Share, 2>;
  std::vector<Shares> x, y;

  /// For a kernel padded such that the product of spectra is the linear convolution on the grid.
  [[nodiscard]] static KernelPlaces padded(const SurfaceGrid& grid);
  /// For the nearest operator that is periodic on the grid: each entry is the mean over the pairs of cells that are equivalent
  /// under the period (T. Chan 1988).
  [[nodiscard]] static KernelPlaces periodic(const SurfaceGrid& grid);
};

/// Real part of the spectrum of a kernel, row by row, [ny / 2 + 1][nx / 2 + 1] with nx, ny the numbers of its entries. It is the
/// whole spectrum of a kernel that is even along both axes, or odd along both.
/// @param response  response at an offset (i, j)
[[nodiscard]] std::vector<double> spectrum_of(const SurfaceGrid& grid, const KernelPlaces& places,
                                              const std::function<double(int, int)>& response);

/// The grid with its open axes extended to fast transform lengths, without padding for a linear convolution.
[[nodiscard]] SurfaceGrid with_fast_lengths(SurfaceGrid grid);

} // namespace brinell::halfspace
