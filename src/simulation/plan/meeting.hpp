// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "footprint.hpp"
#include "surface_distance.hpp"

/// Surfaces that are apart at first, and whose peaks meet while one surface slides over the other.
namespace brinell::simulation
{

/// First and last place on the lower body that comes under the middle of the contact [m].
struct Way
{
  double from = 0.0, to = 0.0;
};

/// Overlap of the undeformed surfaces on their way at a given approach.
struct Meeting
{
  double touch = 0.0;                  ///< smallest approach at which they touch somewhere on the way [m]
  double mean = 0.0;                   ///< mean distance over the grid at the beginning [m]
  double area = 0.0;                   ///< area of overlap at the place of the deepest overlap [m^2]
  double reach_x = 0.0, reach_y = 0.0; ///< largest distance of an overlap from the middle of the contact [m]
};

/// Evaluates the distances in the cells of a grid, at places of the lower body that are whole cells apart.
/// @param grid  around the middle of the contact; along a periodic axis that of the period.
/// @param read  function that gives the depths of a texture on the cells.
[[nodiscard]] Meeting meeting(const ShapedBody& lower, const ShapedBody& upper, const SurfaceGrid& grid, const Way& way,
                              double approach, ReadTexture* read = cell_depths);

/// Evaluates the distances before the grids of the run are known, on a grid for estimates.
[[nodiscard]] Meeting estimated_meeting(const ShapedBody& lower, const ShapedBody& upper, const Numerics& numerics,
                                        const Way& way, double approach);

/// Footprint of bodies that slide under a constant approach. If peaks are higher than the overlap of the shapes, the peaks
/// determine the contact; it is then estimated as a ball on a flat with the deepest overlap and its area. The extent includes
/// every overlap.
[[nodiscard]] Footprint footprint_on_the_way(const ShapedBody& lower, const ShapedBody& upper, const Numerics& numerics,
                                             const Meeting& met, double approach);

} // namespace brinell::simulation
