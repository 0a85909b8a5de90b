// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/grid.hpp"
#include "brinell/simulation/scenario.hpp"

#include <optional>
#include <span>

/// Roughness of heights.
namespace brinell::simulation
{

/// Root mean squares of heights on a grid.
struct Roughness
{
  double height = 0.0; ///< about the mean [m]
  double slope = 0.0;  ///< of the gradient's magnitude

  /// Wavelength of an equivalent single wave, 2 pi over the rms wavenumber [m]. For waves A cos(k x) it is 2 pi/k, because height
  /// and slope are A/sqrt(2) and k A/sqrt(2); for an isotropic surface it follows from the mean square magnitude of the
  /// wavevector, which determines how fast the stress decays with depth. 0 for a surface without slope.
  [[nodiscard]] double wavelength() const;
};

/// @param heights   on the points of the grid; slopes are differences of neighbours, around the period where it has one.
[[nodiscard]] Roughness roughness_of(std::span<const double> heights, const SurfaceGrid& grid);

/// Cells per shortest wave of the textures; of a dent the wave is that of its profile, four edge radii. Empty for smooth bodies.
[[nodiscard]] std::optional<double> cells_per_shortest_wave(const ShapedBody& lower, const ShapedBody& upper, double dx,
                                                            double dy);

/// Cells per shortest wave that the textures of flats over a period have, or can have (for a height map, two of its points). Such
/// bodies touch in many patches of various sizes, for which this number replaces the cells per contact radius as a measure of
/// resolution.
/// @returns empty for other bodies
[[nodiscard]] std::optional<double> cells_per_wave(const ShapedBody& lower, const ShapedBody& upper,
                                                   const Domain& domain, double dx, double dy);

} // namespace brinell::simulation
