// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "judgement.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// Groups of rules for warnings; each function appends to `warnings`.
namespace brinell::quality
{

// Limits on cells and steps; with them an error is some percent in the tables of docs/verification/accuracy.md.
inline constexpr double fewest_cells = 6.0; ///< per contact radius
inline constexpr double fewest_cells_across =
    3.0; ///< across the motion, where cells twice as long cost only half a percent of the net energy
inline constexpr double longest_share_of_radius = 0.25; ///< step over contact radius

/// Cells per radius to compare with the tables, whose cells are up to twice as long across the motion as along it.
[[nodiscard]] double deciding_cells(const Facts& facts, const Resolution& resolution);

/// Relative error of quantities with Documented::of_steps = 1, which are energies. A shift of one cell is part of the
/// tables of cells.
[[nodiscard]] double error_of_steps(const Facts& facts);

/// Resolution with the errors to expect.
/// @param cells_x, cells_y  per half-width of the contact
/// @param seen  by the run; null before it
[[nodiscard]] Resolution resolution_of(const Facts& facts, double cells_x, double cells_y,
                                       const simulation::RunTotals* seen);

/// "1.23 nm"
[[nodiscard]] std::string length_text(double metres);

/// Warns of textures that the cells do not resolve.
/// @return whether one of them is lost, so that nothing can be said about errors
bool warn_of_textures(const Facts& facts, std::vector<Warning>& warnings);

/// Takes out of the resolution what is so uncertain on textured bodies that a number would mislead, and warns of it.
/// @param warnings  of textures only; the last one is extended
void withhold_errors(const Facts& facts, const simulation::RunTotals* seen, Resolution& resolution,
                     std::vector<Warning>& warnings);

/// Warns of coats of bodies that can yield that few layers of cells resolve.
/// @returns whether there are any: the expected errors do not hold then, docs/verification/accuracy.md (coats)
bool warn_of_coats(const Facts& facts, std::vector<Warning>& warnings);

/// Warns of coats that have worn so much thinner that the body would give way otherwise than it is computed, or worn through.
void warn_of_worn_coats(const Facts& facts, const simulation::RunTotals& totals, std::vector<Warning>& warnings);

/// Whether a body has inclusions: the expected errors do not hold then, docs/howto/accuracy.md (inclusions).
[[nodiscard]] bool has_inclusions(const Facts& facts);
/// Warns of inclusions that few cells resolve, of those that the grid cuts or leaves out, and of misfits that make the body yield.
void warn_of_inclusions(const Facts& facts, std::vector<Warning>& warnings);

/// Estimate before a run of the share of the contact that is at the shear limit of a surface: of a pressure that is
/// that of Hertz up to the hardness. 0 where the shear has no such limit, where surfaces may stick, and without an
/// estimate of the pressure.
[[nodiscard]] double estimated_share_at_limit(const Facts& facts);

/// Warns, before a run, of surfaces that will flow under the shear by this estimate.
/// @return whether it warns
bool warn_of_expected_flow(const Facts& facts, std::vector<Warning>& warnings);

/// Whether so much of the contact was at the shear limit of a surface that the flow of that surface decides about the results.
[[nodiscard]] bool flows_at_surface(const Facts& facts, const simulation::RunTotals& totals);

/// Warns of expected yield that did not occur, of strains that are not small or depend on the cell size, of errors of the energy
/// balance and of split increments.
void warn_of_course(const Facts& facts, const simulation::RunTotals& totals, std::vector<Warning>& warnings);

/// Warns of temperatures beyond the range of the softening law or of the thermal constants.
void warn_of_heat(const Facts& facts, const simulation::RunTotals& totals, std::vector<Warning>& warnings);

/// The error of an effect, from the tables; none for an effect without one.
[[nodiscard]] std::optional<Documented> documented_of_effect(std::string_view effect, const Facts& facts);

/// Warns of what the effects do that an increment, or their laws, do not follow.
void warn_of_effects(const Facts& facts, const simulation::RunTotals& totals, std::vector<Warning>& warnings);

} // namespace brinell::quality
