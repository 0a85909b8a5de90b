// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/deviator.hpp"
#include "brinell/foundation/grid.hpp"

#include <array>
#include <cstddef>
#include <vector>

namespace brinell::elastoplastic
{

/// Local means of the components xz and yz of a deviator field, over boxes of cells within each layer next to the surface. A
/// plastic strain that is uniform along such a layer causes hardly any stress, so that its residual may be extrapolated
/// (Body::go_further).
class SurfaceMeans
{
public:
  static constexpr int layers = 4, half_x = 8, half_y = 4; ///< bench/notebook/2026-11-25-friction.md

  explicit SurfaceMeans(const VolumeGrid& grid);

  [[nodiscard]] bool contains(std::size_t cell) const { return cell < fields_[0].size(); }
  /// Sets the value of a cell in these layers, before `average`; cells that are not set are 0.
  void set(std::size_t cell, const Deviator& value);
  /// Replaces the values by means. All boxes have the same number of cells, and beyond the ends of an open grid values are 0, so
  /// that the average is a symmetric operator.
  void average();
  /// Contraction of a deviator with the mean of xz and yz around a cell, after `average`.
  [[nodiscard]] double contracted(std::size_t cell, const Deviator& with) const;

private:
  void average_along_x(double* row);
  void average_along_y(double* layer);

  SurfaceGrid surface_;
  std::array<std::vector<double>, 2> fields_; ///< xz, yz
  std::vector<char> has_values_;              ///< per row of these layers
  std::vector<double> sums_;
};

} // namespace brinell::elastoplastic
