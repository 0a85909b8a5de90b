// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/simulation/scenario.hpp"
#include "brinell/simulation/texture.hpp"

#include <vector>

/// How far two surfaces are from each other, cell by cell, before anything deforms.
namespace brinell::simulation
{

/// Where the cells of a grid lie on two bodies that touch [m].
struct CellPlaces
{
  double x = 0.0, y = 0.0;         ///< of cell (0, 0), from the middle of both shapes
  double lower = 0.0, upper = 0.0; ///< place along x of each texture under that middle
};

/// Where the cells of a run are with a place of the lower body under the middle of the shapes: rows around y = 0, and columns
/// on those of the lower body, that of its middle next to the place. An even number of columns has one more to the right.
[[nodiscard]] CellPlaces places_in_run(const SurfaceGrid& grid, double place = 0.0);

/// What a grid reads of a texture: `depths` in the centres of its cells, or `cell_depths`, means over those that are coarser.
using ReadTexture = decltype(depths);

/// Of both textures, without the shapes [m].
[[nodiscard]] std::vector<double> texture_distance(const ShapedBody& lower, const ShapedBody& upper,
                                                   const SurfaceGrid& grid, const CellPlaces& at, ReadTexture* read);

/// Of the textured surfaces, where their shapes touch without load [m].
[[nodiscard]] std::vector<double> surface_distance(const ShapedBody& lower, const ShapedBody& upper,
                                                   const SurfaceGrid& grid, const CellPlaces& at, ReadTexture* read);

} // namespace brinell::simulation
