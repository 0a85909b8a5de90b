// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/simulation/scenario.hpp"

namespace brinell::simulation
{

/// Whether bodies touch along the whole period in y, so that their shapes allow a plane problem.
[[nodiscard]] bool touch_all_along_y(const Shape& lower, const Shape& upper, const Domain& domain);

/// Grid over one period of bodies that are periodic along both axes, fine enough for estimates and no finer than the grid of the
/// run.
[[nodiscard]] SurfaceGrid sampled_period(const Domain& domain);
/// Depths of a texture on the cells of that grid [m], placed like the cells of a run: a column at x = 0, rows around y = 0.
[[nodiscard]] std::vector<double> sampled_depths(const Texture& texture, const SurfaceGrid& grid);

/// Checks that cells resolve the textures of flats over a period at all. Waves that fit a whole number of times into a cell
/// vanish in the mean over the cell, and without heights the distance of the flats is the same everywhere.
/// @throws PlanError
void require_heights_on_cells(const ShapedBody& lower, const ShapedBody& upper, const Domain& domain,
                              const SurfaceGrid& grid);

/// Checks the numbers of cells in periods. A period with a single row or column can represent only what is uniform along it.
/// @param grid  of the contact.
/// @throws PlanError if bodies or textures are not uniform in that way; if there is only one cell, which no pressure displaces; or
/// if the cells do not resolve the textures of flats
void require_cells_in_periods(const PairCase& c, const SurfaceGrid& grid);

/// Why bodies that are periodic along both axes cannot approach by a given distance [m]; empty if they can. For such bodies the
/// approach is counted from the mean planes, and at the mean distance of the surfaces the whole period is in contact.
/// @param scenario_case  class whose members the text names
[[nodiscard]] std::optional<std::string> reason_against_approach(const ShapedBody& lower, const ShapedBody& upper,
                                                                 double approach, const Domain& domain,
                                                                 std::string_view scenario_case);

/// Checks that the plastic zone is finite. The mean pressure p on bodies that are periodic along both axes acts at every depth
/// and, with lateral strain suppressed, causes a von Mises stress of p (1 - 2 nu)/(1 - nu). Material that yields under this
/// stress yields at all depths, and no grid is deep enough.
/// @throws InputError
void require_finite_depth(const ShapedBody& lower, const ShapedBody& upper, double load, const Domain& domain);

} // namespace brinell::simulation
