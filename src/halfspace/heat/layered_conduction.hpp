// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "foundation/aligned.hpp"
#include "foundation/lanes.hpp"

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace brinell::halfspace
{

/// A matrix that is multiplied by many columns; four rows are interleaved in memory.
class RowsOfFour
{
public:
  static constexpr std::size_t together = 4;
  RowsOfFour(std::size_t rows, std::size_t columns);
  [[nodiscard]] double& at(std::size_t row, std::size_t column);
  /// Multiplies `lane_count` vectors at once: [row] from [column]; only the columns first <= column < last are used.
  void multiply(const ComplexLanes* in, std::size_t first, std::size_t last, ComplexLanes* out) const;
  [[nodiscard]] std::size_t rows() const { return rows_; }

private:
  std::size_t rows_, columns_;
  AlignedVector<double> values_; ///< [rows/4][column][4]
};

/// Heat conduction along the depth of a body with an insulated surface, by finite volumes: layers with one mean temperature each,
/// and the decaying modes of their temperatures. The modes are complete, and the heat is conserved exactly.
///
/// Beneath the layers of uniform thickness h, in which heat may be generated, the thickness grows by sqrt(2) from one layer to
/// the next, so that it doubles with every second layer.
class LayeredConduction
{
public:
  /// @param heated     number of layers in which heat may be generated
  /// @param thickness  of each of them [m]
  /// @param deepest    depth that the heat does not reach in the whole duration [m]
  LayeredConduction(int heated, double thickness, double deepest);

  [[nodiscard]] std::size_t size() const { return ends_.size() - 1; }
  [[nodiscard]] std::size_t heated() const { return heated_; } ///< number of layers of uniform thickness
  [[nodiscard]] double thickness() const { return thickness_; }
  [[nodiscard]] double top(std::size_t layer) const { return ends_[layer]; }
  [[nodiscard]] double bottom(std::size_t layer) const { return ends_[layer + 1]; }
  [[nodiscard]] double middle(std::size_t layer) const { return 0.5 * (ends_[layer] + ends_[layer + 1]); }
  [[nodiscard]] std::size_t layer_at(double depth) const;

  /// s^2 of each mode [1/m^2], which decays as e^{-kappa s^2 t}.
  [[nodiscard]] const std::vector<double>& squared_numbers() const { return squared_numbers_; }
  /// Matrices from the amplitudes of the modes to the temperatures of all layers, and back.
  [[nodiscard]] const RowsOfFour& to_layers() const { return to_layers_; }
  [[nodiscard]] const RowsOfFour& to_modes() const { return to_modes_; }

private:
  void find_modes();

  std::size_t heated_;
  double thickness_;
  std::vector<double> ends_; ///< depths of the interfaces between the layers, from the surface down [m]
  std::vector<double> squared_numbers_;
  RowsOfFour to_layers_, to_modes_;
};

/// Number of the layers of a `LayeredConduction`.
[[nodiscard]] std::size_t count_of_layers(int heated, double thickness, double deepest);

/// Number of layers that are one where images at a distance are removed: see `layers_for_images`.
[[nodiscard]] int layers_together(double thickness, double distance);

/// Layers for images at the distance `distance` [m]: two, four, ... times as thick as `layers`, at most a sixteenth of the
/// distance. At such a distance the effect of heat depends on its amount and mean depth, and on its distribution in depth only to
/// the second order in thickness/distance.
[[nodiscard]] std::shared_ptr<const LayeredConduction>
layers_for_images(const std::shared_ptr<const LayeredConduction>& layers, double distance);
/// Converts the temperature rise of layers into that of thicker layers, conserving the heat and its mean depth; empty fields are
/// zero.
[[nodiscard]] std::vector<std::vector<double>>
on_layers(const LayeredConduction& from, const std::vector<std::vector<double>>& rise, const LayeredConduction& to);

} // namespace brinell::halfspace
