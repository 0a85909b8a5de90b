// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "judgement.hpp"

#include <string>
#include <vector>

/// Groups of rules for warnings; each function appends to `warnings`.
namespace brinell::simulation
{

/// "1.23 nm"
[[nodiscard]] std::string length_text(double metres);

/// Warns of textures that the cells do not resolve.
void warn_of_textures(const Facts& facts, std::vector<Warning>& warnings);

/// Estimate before a run of the share of the contact that is at the shear limit of a surface: of a pressure that is that of Hertz up
/// to the hardness. 0 where the shear has no such limit, where surfaces may stick, and without an estimate of the pressure.
[[nodiscard]] double estimated_share_at_limit(const Facts& facts);

/// Warns, before a run, of surfaces that will flow under the shear by this estimate.
/// @return whether it warns
bool warn_of_expected_flow(const Facts& facts, std::vector<Warning>& warnings);

/// Whether so much of the contact was at the shear limit of a surface that the flow of that surface decides about the results.
[[nodiscard]] bool flows_at_surface(const Facts& facts, const RunTotals& totals);

/// Warns of expected yield that did not occur, of strains that are not small or depend on the cell size, of errors of the energy
/// balance and of split increments.
void warn_of_course(const Facts& facts, const RunTotals& totals, std::vector<Warning>& warnings);

/// Warns of temperatures beyond the range of the softening law or of the thermal constants.
void warn_of_heat(const Facts& facts, const RunTotals& totals, std::vector<Warning>& warnings);

/// Warns of wear that is too large: in one increment, because it is computed with the pressure at the end, or in total, because
/// plastic strain does not move with the worn surface.
void warn_of_wear(const Facts& facts, const RunTotals& totals, std::vector<Warning>& warnings);

} // namespace brinell::simulation
