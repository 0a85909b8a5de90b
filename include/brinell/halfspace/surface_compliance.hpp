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
/// Without periodic axes a convolution with the rectangle's closed form (DC-FFT; Love 1929); with one, with a row of copies of
/// the rectangle; with two, the waves' 2 / (E' k), for pressures that are trigonometric polynomials. A uniform pressure then
/// moves the surface without end: its displacement is counted as zero, so displacements are those from the mean plane.
class SurfaceCompliance
{
public:
  /// @param contact_modulus  E' of the pair [Pa]: u = 1/(pi E') * integral of p / r.
  /// @param reference        with one periodic axis: the distance from a line load at which its displacement is counted as
  ///                         zero [m]; it has a logarithm without end. The operator is positive definite on surfaces well
  ///                         within that distance: those less than four times as wide, if they are strips.
  /// @throws InputError for one cell that is periodic along both axes, which nothing displaces
  SurfaceCompliance(const SurfaceGrid& grid, double contact_modulus, double reference = 0.0);

  /// Buffers of one application; make one per concurrent caller, once.
  struct Buffers;
  using Scratch = Hidden<Buffers>;
  [[nodiscard]] Scratch make_scratch() const;

  [[nodiscard]] const SurfaceGrid& grid() const;
  /// Of the same bodies on another grid.
  [[nodiscard]] SurfaceCompliance on(const SurfaceGrid& grid) const;
  /// Displacement [m] of the load: symmetric and positive definite, but for a uniform pressure on a periodic surface.
  void apply(const SurfaceLoad& load, const SurfaceDisplacement& displacement, Scratch& scratch) const;
  /// Pressure that causes about this displacement [Pa]: the inverse of the nearest operator that is periodic on the grid (T.
  /// Chan 1988), symmetric and positive definite; a uniform displacement of a periodic surface gives one, too. A
  /// preconditioner, at a quarter of the cost of `apply` without periodic axes. Both may be the same field.
  void apply_inverse(std::span<const double> displacement, std::span<double> pressure, Scratch& scratch) const;
  /// Largest response of a wave [m/Pa].
  [[nodiscard]] double largest() const;

private:
  struct Operator; ///< transform and spectrum
  Hidden<Operator> operator_;
};

} // namespace brinell::halfspace
