// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/grid.hpp"
#include "brinell/simulation/scenario.hpp"

#include <optional>
#include <span>

/// How rough heights are.
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

/// Cells in the shortest wave that the textures of flats over a period have, or can have (two points of a height map). Such
/// bodies touch in many patches of any size: a contact radius says nothing of them, this does.
/// @returns nothing of other bodies
[[nodiscard]] std::optional<double> cells_per_wave(const ShapedBody& lower, const ShapedBody& upper,
                                                   const Domain& domain, double dx, double dy);

} // namespace brinell::simulation
