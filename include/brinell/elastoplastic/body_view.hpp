// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/elastoplastic/body.hpp"

namespace brinell::elastoplastic
{

/// Relation of the upper body to the lower one; other than none, only the lower body is solved.
enum class Twin
{
  none,
  mirror_image, ///< reversed in x: two asperities passing each other
  alike         ///< equal field in the same direction: pure rolling
};

/// One side of a contact as seen by a user: a body that is solved, or the twin of a solved body, which has no fields of its own.
/// Fields are in the axes of this side; those of a mirror image are copied in reverse order.
class BodyView
{
public:
  /// @param texture  depth of the surface of this side before the first load, positive into the body [m]; empty: smooth
  BodyView(const Body& solved, Twin twin, const std::vector<double>& texture)
      : solved_(&solved), twin_(twin), texture_(&texture)
  {
  }

  [[nodiscard]] const VolumeGrid& grid() const { return solved_->grid(); }
  [[nodiscard]] const constitutive::Material& material() const { return solved_->material(); }
  [[nodiscard]] const std::vector<double>& texture() const { return *texture_; }
  /// The body that is solved: for quantities that do not depend on directions, such as energies and largest values.
  [[nodiscard]] const Body& solved() const { return *solved_; }

  /// Whether the fields of this side are those of `solved` in reverse order.
  [[nodiscard]] bool is_mirrored() const { return twin_ == Twin::mirror_image; }

  /// Turns fields of the solved body into those of this side: a deviator field of 5 values per cell, and a scalar one.
  void turn(std::vector<double>& deviators, std::vector<double>& scalars) const;

  /// The cell of the solved body that a cell of this side is.
  [[nodiscard]] std::size_t solved_cell(std::size_t cell) const;
  /// A deviator of the solved body in the axes of this side.
  [[nodiscard]] Deviator turned(const Deviator& of_solved) const;

  /// A copy of a surface field, converted from the solved body to this side or back.
  /// @param parity  factor, +1 or -1, of the field's value in the mirror image
  [[nodiscard]] std::vector<double> turned(std::span<const double> surface, double parity) const;

  /// A copy of the history.
  [[nodiscard]] BodyState state() const;
  /// A copy of one field of the history, such as &BodyState::plastic_strain; of a body that ranks share in the own layers.
  [[nodiscard]] std::vector<double> field(std::vector<double> BodyState::*member) const;
  /// Residual displacement of the surface in the present trial along z (0), x (1) or y (2): Body::residual_displacement.
  [[nodiscard]] std::vector<double> residual_displacement(std::size_t axis = 0) const;
  /// See Body::shear_strength.
  [[nodiscard]] std::vector<double> shear_strength(double along_x, double along_y = 0.0) const;

private:
  void turn_field(InMirror in_mirror, std::vector<double>& field) const;

  const Body* solved_;
  Twin twin_;
  const std::vector<double>* texture_;
};

} // namespace brinell::elastoplastic
