// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/grid.hpp"
#include "brinell/foundation/hidden.hpp"
#include "brinell/green/conductive_stack.hpp"
#include "brinell/green/elastic.hpp"
#include "brinell/green/stack.hpp"
#include "brinell/halfspace/surface_load.hpp"

#include <array>
#include <span>
#include <utility>
#include <vector>

namespace brinell::halfspace
{

/// Checks that the cells represent the first layer. A layer of a quarter of a cell leaves e^{-14} of the waves shorter than
/// those that are summed. Waves of a surface that is periodic along both axes represent any layer.
/// @throws InputError if the first layer is thinner
void require_resolved(const SurfaceGrid& grid, const ElasticStack& stack);

/// Pressure and shears on one surface grid -> elastic displacement of two half spaces: docs/theory/half-space.md
/// (surface-displacement, traction-displacement).
///
/// z points into each body; the shear is that on body 1, and the shear on body 2 is opposite. The displacement along z is the sum
/// of both bodies, along x and y that of body 1 minus that of body 2. The work of the load is then the product of load and
/// displacement, and the operator is symmetric, and positive definite except for loads that are uniform on a surface periodic
/// along both axes, which cause no displacement.
///
/// Without periodic axes, the operator is a convolution with the closed form for a rectangle (DC-FFT; Love 1929, Cerruti); with
/// one periodic axis, with that for a row of copies of the rectangle; with two, a factor on each wave, for tractions that are
/// trigonometric polynomials. In the last case the displacement by a uniform pressure is infinite and is taken as zero, so
/// displacements are relative to the mean plane. What pressure alone does and what needs shears are set up when they are first
/// needed.
class SurfaceCompliance
{
public:
  /// For pressures and displacements along z, which depend on the contact modulus alone.
  /// @param contact_modulus  E' of the pair [Pa]: u = 1/(pi E') * integral of p / r.
  /// @param reference        with one periodic axis: the distance from a line load at which its displacement, which is
  ///                         logarithmic and unbounded, is taken as zero [m], in all directions. The operator is positive definite
  ///                         on surfaces well within that distance: for strips, those less than four times as wide.
  /// @throws InputError for a grid of one cell that is periodic along both axes, where every displacement is zero
  SurfaceCompliance(const SurfaceGrid& grid, double contact_modulus, double reference = 0.0);
  /// @param body2  rigid for the displacement of body 1 alone.
  SurfaceCompliance(const SurfaceGrid& grid, const Elastic& body1, const Elastic& body2, double reference = 0.0);
  /// Of layered bodies (docs/theory/stacks.md).
  /// @throws InputError if a first layer is thinner than a quarter of a cell, unless the surface is periodic along both axes
  SurfaceCompliance(const SurfaceGrid& grid, const ElasticStack& body1, const ElasticStack& body2,
                    double reference = 0.0);

  /// Density of a current [A/m^2], in place of the pressure -> potential [V], in place of the displacement along z, of two bodies
  /// that conduct (docs/theory/electrical.md, layers): that of body 1 less that of body 2 against points far away in both. It has
  /// no shears. With one periodic axis the potential is zero at the reference distance.
  /// @throws InputError if a first layer is thinner than a quarter of a cell, unless the surface is periodic along both axes
  [[nodiscard]] static SurfaceCompliance of_conductors(const SurfaceGrid& grid, const ConductiveStack& body1,
                                                       const ConductiveStack& body2, double reference = 0.0);

  /// Buffers of one application; make one per concurrent caller, once.
  struct Buffers;
  using Scratch = Hidden<Buffers>;
  [[nodiscard]] Scratch make_scratch() const;

  [[nodiscard]] const SurfaceGrid& grid() const;
  [[nodiscard]] double reference() const; ///< [m]
  /// The compliance of the same bodies on another grid, with the same reference.
  [[nodiscard]] SurfaceCompliance on(const SurfaceGrid& grid) const;
  /// Whether a pressure causes displacements along the surface and a shear causes displacements along z, as it is for elastically
  /// dissimilar bodies (Dundurs).
  [[nodiscard]] bool couples() const;
  /// Displacement across the plane of a plane problem by shear across it, over the displacement in the plane by shear
  /// in it, in the limit of short waves: sum of 1/mu over sum of (1 - nu)/mu of both bodies.
  [[nodiscard]] double along_over_across() const;
  /// The displacement [m]; parts of the load and of the displacement that are empty cost nothing. On a mirrored grid only the
  /// independent rows are read and written.
  void apply(const SurfaceLoad& load, const SurfaceDisplacement& displacement, Scratch& scratch) const;
  /// As above, with a temporary scratch.
  void apply(const SurfaceLoad& load, const SurfaceDisplacement& displacement) const;
  /// Pressure [Pa] that causes approximately this displacement along z: the inverse of the nearest operator that is periodic on
  /// the grid (T. Chan 1988), symmetric and positive definite; it also maps a uniform displacement of a periodic surface to a
  /// uniform pressure. A preconditioner, at a quarter of the cost of `apply` without periodic axes. Both spans may be the same
  /// field.
  void apply_inverse(std::span<const double> displacement, std::span<double> pressure, Scratch& scratch) const;
  /// Two fields, along x and y.
  template <typename Span>
  using Pair = std::array<Span, 2>;
  /// Shears [Pa] that cause approximately this displacement along the surface, likewise. Both arguments may be the same fields.
  /// @param added  additional compliance of each cell to its own shear [m/Pa], >= 0
  void apply_inverse(const Pair<std::span<const double>>& displacement, const Pair<std::span<double>>& shear,
                     Scratch& scratch, double added = 0.0) const;
  /// Real and even spectrum of the factors on waves, rows of px / 2 + 1 values up to the row py / 2.
  struct Spectrum
  {
    int px, py; ///< lengths of the transforms
    std::vector<double> factors;
  };
  /// Spectra of the displacement along z by a pressure [m/Pa], and of `apply_inverse` [Pa/m]: for devices.
  struct NormalSpectra
  {
    Spectrum compliance, stiffness;
  };
  [[nodiscard]] NormalSpectra normal_spectra() const;
  /// Largest displacement along z by a wave of unit pressure [m/Pa].
  [[nodiscard]] double largest() const;
  /// Largest displacement along the surface by a wave of unit shear [m/Pa]: a bound of the norm of the operator from shear to
  /// displacement along the surface.
  [[nodiscard]] double largest_of_shear() const;
  /// Shear on one cell, by `apply_inverse`, per unit displacement of this cell alone [Pa/m]; the mean of x and y.
  [[nodiscard]] double stiffness_of_cell() const;

private:
  struct Operator; ///< transforms and spectra
  explicit SurfaceCompliance(Hidden<Operator> made);
  void require_own(const char* function_name, const Scratch& scratch) const;
  Hidden<Operator> operator_;
};

} // namespace brinell::halfspace
