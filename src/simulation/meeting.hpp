// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "footprint.hpp"
#include "surface_distance.hpp"

/// Peaks that lie apart and come to each other while one surface slides over the other.
namespace brinell::simulation
{

/// Places of the lower body that come under the middle of the contact, from the first to the last [m].
struct Way
{
  double from = 0.0, to = 0.0;
};

/// What the undeformed surfaces do on their way under one approach.
struct Meeting
{
  double touch = 0.0;                  ///< approach at which they first touch, wherever on the way that is [m]
  double mean = 0.0;                   ///< distance over the grid, at the beginning [m]
  double area = 0.0;                   ///< on which they overlap where they overlap most [m^2]
  double reach_x = 0.0, reach_y = 0.0; ///< of all overlaps from the middle of the contact [m]
};

/// By the distances in the cells of a grid, at places of the lower body that are whole cells apart.
/// @param grid  around the middle of the contact; along a periodic axis that of the period.
/// @param read  what the cells have of a texture.
[[nodiscard]] Meeting meeting(const ShapedBody& lower, const ShapedBody& upper, const SurfaceGrid& grid, const Way& way,
                              double approach, ReadTexture* read = cell_depths);

/// The same of bodies whose grids are not laid out yet, on cells for an estimate.
[[nodiscard]] Meeting estimated_meeting(const ShapedBody& lower, const ShapedBody& upper, const Numerics& numerics,
                                        const Way& way, double approach);

/// Of bodies that slide under one approach. Where their peaks stand out more than the shapes overlap, the peaks make the
/// contact: a ball on a flat, with the area of the largest overlap, then stands for them. The extent holds every overlap.
[[nodiscard]] Footprint footprint_on_the_way(const ShapedBody& lower, const ShapedBody& upper, const Numerics& numerics,
                                             const Meeting& met, double approach);

} // namespace brinell::simulation
