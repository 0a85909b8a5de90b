// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "foundation/aligned.hpp"

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace brinell::halfspace
{

/// A matrix that is multiplied with many columns: four rows side by side.
class RowsOfFour
{
public:
  static constexpr std::size_t together = 4;
  RowsOfFour(std::size_t rows, std::size_t columns);
  [[nodiscard]] double& at(std::size_t row, std::size_t column);
  /// Lanes of columns: [row][lane] from [column][lane], of the columns first <= column < last alone.
  void multiply(const double* in, std::size_t first, std::size_t last, double* out) const;
  [[nodiscard]] std::size_t rows() const { return rows_; }

private:
  std::size_t rows_, columns_;
  AlignedVector<double> values_; ///< [rows/4][column][4]
};

/// Conduction along the depth of a body whose surface is insulated, between layers with a mean temperature each (finite volumes),
/// and the modes in which these decay: all that arises in the layers is in the modes, and nothing gets lost.
///
/// Layers of one thickness h, in which heat may arise, lie on others whose thickness grows by sqrt(2) from one to the next:
/// that of every second one is twice as large.
class LayeredConduction
{
public:
  /// @param deepest  where heat does not come to in all the time [m]
  LayeredConduction(int heated, double thickness, double deepest);

  [[nodiscard]] std::size_t size() const { return ends_.size() - 1; }
  [[nodiscard]] std::size_t heated() const { return heated_; } ///< layers of one thickness
  [[nodiscard]] double thickness() const { return thickness_; }
  [[nodiscard]] double top(std::size_t layer) const { return ends_[layer]; }
  [[nodiscard]] double bottom(std::size_t layer) const { return ends_[layer + 1]; }
  [[nodiscard]] double middle(std::size_t layer) const { return 0.5 * (ends_[layer] + ends_[layer + 1]); }
  [[nodiscard]] std::size_t layer_at(double depth) const;

  /// A mode decays as e^{-kappa s^2 t} [1/m^2].
  [[nodiscard]] const std::vector<double>& squared_numbers() const { return squared_numbers_; }
  /// Temperatures of all layers from the modes, and the modes from them.
  [[nodiscard]] const RowsOfFour& to_layers() const { return to_layers_; }
  [[nodiscard]] const RowsOfFour& to_modes() const { return to_modes_; }

private:
  void find_modes();

  std::size_t heated_;
  double thickness_;
  std::vector<double> ends_; ///< between the layers, from the surface down [m]
  std::vector<double> squared_numbers_;
  RowsOfFour to_layers_, to_modes_;
};

/// For images at that distance [m]: layers of twice, four times, ... the thickness, at most a sixteenth of it. What heat does so far
/// away depends on its amount and mean depth; on how it is spread in depth, to the second order in thickness/distance.
[[nodiscard]] std::shared_ptr<const LayeredConduction>
layers_for_images(const std::shared_ptr<const LayeredConduction>& layers, double distance);
/// What warms some layers, as it warms thicker ones in their place, with the same heat and the same mean depth; empty: cold.
[[nodiscard]] std::vector<std::vector<double>>
on_layers(const LayeredConduction& from, const std::vector<std::vector<double>>& rise, const LayeredConduction& to);

} // namespace brinell::halfspace
