// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/grid.hpp"
#include "brinell/foundation/hidden.hpp"
#include "brinell/halfspace/surface_load.hpp"

#include <span>

namespace brinell::halfspace
{

/// Surface load -> sum of the elastic displacements of two half spaces on one surface grid: docs/theory/half-space.md
/// (surface-displacement).
///
/// Without periodic axes, the operator is a convolution with the closed form for a rectangle (DC-FFT; Love 1929); with one
/// periodic axis, with that for a row of copies of the rectangle; with two, the factor 2 / (E' k) on each wave, for pressures
/// that are trigonometric polynomials. In the last case the displacement by a uniform pressure is infinite and is taken as zero,
/// so displacements are relative to the mean plane.
class SurfaceCompliance
{
public:
  /// @param contact_modulus  E' of the pair [Pa]: u = 1/(pi E') * integral of p / r.
  /// @param reference        with one periodic axis: the distance from a line load at which its displacement, which is
  ///                         logarithmic and unbounded, is taken as zero [m]. The operator is positive definite on surfaces well
  ///                         within that distance: for strips, those less than four times as wide.
  /// @throws InputError for a grid of one cell that is periodic along both axes, where every displacement is zero
  SurfaceCompliance(const SurfaceGrid& grid, double contact_modulus, double reference = 0.0);

  /// Buffers of one application; make one per concurrent caller, once.
  struct Buffers;
  using Scratch = Hidden<Buffers>;
  [[nodiscard]] Scratch make_scratch() const;

  [[nodiscard]] const SurfaceGrid& grid() const;
  /// The compliance of the same bodies on another grid.
  [[nodiscard]] SurfaceCompliance on(const SurfaceGrid& grid) const;
  /// Displacement [m] by the load; on a mirrored grid only the independent rows are read and written. The operator is symmetric,
  /// and positive definite except for a uniform pressure on a surface that is periodic along both axes.
  void apply(const SurfaceLoad& load, const SurfaceDisplacement& displacement, Scratch& scratch) const;
  /// Pressure [Pa] that causes approximately this displacement: the inverse of the nearest operator that is periodic on the grid
  /// (T. Chan 1988), symmetric and positive definite; it also maps a uniform displacement of a periodic surface to a uniform
  /// pressure. A preconditioner, at a quarter of the cost of `apply` without periodic axes. Both spans may be the same field.
  void apply_inverse(std::span<const double> displacement, std::span<double> pressure, Scratch& scratch) const;
  /// Largest displacement by a wave of unit pressure [m/Pa].
  [[nodiscard]] double largest() const;

private:
  struct Operator; ///< transform and spectrum
  Hidden<Operator> operator_;
};

} // namespace brinell::halfspace
