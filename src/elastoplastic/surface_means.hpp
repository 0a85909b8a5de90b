// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/deviator.hpp"
#include "brinell/foundation/grid.hpp"

#include <array>
#include <cstddef>
#include <vector>

namespace brinell::elastoplastic
{

/// Means of xz and yz over the cells around a cell in its layer, in the layers next to the surface: what is the same all along
/// these layers, which as a plastic strain makes hardly any stress.
class SurfaceMeans
{
public:
  static constexpr int layers = 4, half_x = 8, half_y = 4; ///< docs/performance.md

  explicit SurfaceMeans(const VolumeGrid& grid);

  [[nodiscard]] bool contains(std::size_t cell) const { return cell < fields_[0].size(); }
  /// Of a cell in these layers; 0 in cells that are not set. Before `take`.
  void set(std::size_t cell, const Deviator& value);
  /// Takes the means, over boxes of as many cells everywhere: beyond the ends of an open grid they are 0, so what is taken from
  /// one cell to another is as much as the other way round.
  void take();
  /// Contraction of a deviator with the mean of xz and yz around a cell, after `take`.
  [[nodiscard]] double contracted(std::size_t cell, const Deviator& with) const;

private:
  void take_along(std::size_t first, std::size_t stride, int count, int half, bool is_periodic);

  SurfaceGrid surface_;
  std::array<std::vector<double>, 2> fields_; ///< xz, yz
  std::vector<double> sums_;
};

} // namespace brinell::elastoplastic
