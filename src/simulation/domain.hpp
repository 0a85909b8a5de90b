// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/simulation/scenario.hpp"

namespace brinell::simulation
{

/// Whether bodies touch along y all through a period, so that their shapes leave a plane problem.
[[nodiscard]] bool touch_all_along_y(const Shape& lower, const Shape& upper, const Domain& domain);

/// One period of bodies that are periodic along both axes, in cells fine enough for estimates: at most those of the grid.
[[nodiscard]] SurfaceGrid sampled_period(const Domain& domain);
/// What the cells of that grid have of a texture [m], where the cells of a run are: a column at x = 0, rows around y = 0.
[[nodiscard]] std::vector<double> sampled_depths(const Texture& texture, const SurfaceGrid& grid);

/// Flats over a period are apart by what their cells have of the textures; waves that fit a whole number of times into a cell
/// leave nothing there.
/// @throws KeyError
void require_heights_on_cells(const ShapedBody& lower, const ShapedBody& upper, const Domain& domain,
                              const SurfaceGrid& grid);

/// One row, or one column, of a period shows no more than what is uniform along it.
/// @param grid  of the contact.
/// @throws KeyError if the bodies, or their textures, are not; if there is one cell only, which nothing displaces; and of cells
///         that have nothing of the textures of flats
void require_cells_in_periods(const ShapedBody& lower, const ShapedBody& upper, const Domain& domain,
                              const SurfaceGrid& grid);

/// Why bodies that are periodic along both axes cannot approach so far [m]; empty if they can. Approaches are counted from the
/// mean planes then, and at the mean distance of the surfaces all of them touches.
/// @param scenario  whose keys the text names
[[nodiscard]] std::optional<std::string> reason_against_approach(const ShapedBody& lower, const ShapedBody& upper,
                                                                 double approach, const Domain& domain,
                                                                 std::string_view scenario);

/// A mean pressure on bodies that are periodic along both axes is there at any depth. Held in its plane, material under it
/// carries a von Mises stress of p (1 - 2 nu)/(1 - nu): what yields under that yields without end, and no grid is deep enough.
/// @throws InputError
void require_finite_depth(const ShapedBody& lower, const ShapedBody& upper, double load, const Domain& domain);

} // namespace brinell::simulation
