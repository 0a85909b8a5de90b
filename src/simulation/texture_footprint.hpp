// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "footprint.hpp"

#include <span>

/// What textures add to the footprint of smooth bodies.
namespace brinell::simulation
{

/// Root mean squares of heights on a grid.
struct Roughness
{
  double height = 0.0; ///< from the mean [m]
  double slope = 0.0;  ///< of the gradient's length

  /// Of the wave that stands for the surface, 2 pi over the root mean square of the wavenumber [m]: of waves A cos(k x) it is
  /// theirs, 2 pi/k, as height and slope are A/sqrt(2) and k A/sqrt(2); of an isotropic surface it is that of the mean square
  /// of the wavevector's length, which says how fast the stress under it fades. 0 of a surface without slope.
  [[nodiscard]] double wavelength() const;
};

/// @param heights   on the points of the grid; slopes are differences of neighbours, around the period where it has one.
[[nodiscard]] Roughness roughness_of(std::span<const double> heights, const SurfaceGrid& grid);

/// Widens the footprint of the smooth bodies to what their textures touch. Where the smooth bodies would stay elastic it need
/// only be as deep as the stress of the texture goes: a wavelength, over which exp(-kz) (1 + kz) falls to 1.4 %.
/// @param modulus  E' of the pair [Pa]
void add_textures(const ShapedBody& lower, const ShapedBody& upper, const contact::Drive& drive, double modulus,
                  const Domain& domain, Footprint& footprint);

/// Textures of bodies that have no shape, in a period: what the wave that stands for them needs.
/// @param modulus  E' of the pair [Pa]
/// @param yield_pressure  peak pressure at which a point contact first yields [Pa]
/// @throws KeyError of textures that leave the distance of the bodies the same everywhere
[[nodiscard]] Footprint of_flats(const ShapedBody& lower, const ShapedBody& upper, double modulus,
                                 double yield_pressure, const Domain& domain);

} // namespace brinell::simulation
