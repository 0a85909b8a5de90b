// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/simulation/scenario.hpp"
#include "brinell/simulation/texture.hpp"

#include <vector>

/// Distance of two undeformed surfaces, cell by cell.
namespace brinell::simulation
{

/// Position of the cells of a grid on two bodies [m].
struct CellPlaces
{
  double x = 0.0, y = 0.0;         ///< of cell (0, 0) relative to the middle of both shapes
  double lower = 0.0, upper = 0.0; ///< x on each body, and its texture, at that middle
};

/// Positions of the cells of a run when a given place of the lower body is under the middle of the shapes: rows are centred at y
/// = 0, and columns coincide with those of the lower body, the middle one being next to the place. An even number of columns has
/// one more to the right of the middle one.
[[nodiscard]] CellPlaces places_in_run(const SurfaceGrid& grid, double place = 0.0);

/// Function that gives the depths of a texture on a grid: `depths`, at the centres of the cells, or `cell_depths`, with means
/// over coarse cells.
using ReadTexture = decltype(depths);

/// Distance due to both textures, without the shapes [m].
[[nodiscard]] std::vector<double> texture_distance(const ShapedBody& lower, const ShapedBody& upper,
                                                   const SurfaceGrid& grid, const CellPlaces& at, ReadTexture* read);

/// Distance of the textured surfaces when their shapes just touch [m].
[[nodiscard]] std::vector<double> surface_distance(const ShapedBody& lower, const ShapedBody& upper,
                                                   const SurfaceGrid& grid, const CellPlaces& at, ReadTexture* read);

} // namespace brinell::simulation
