// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "judgement.hpp"

#include <string>
#include <vector>

/// Parts of the judgement: what each has to tell is added to the warnings.
namespace brinell::simulation
{

/// "1.23 nm"
[[nodiscard]] std::string length_text(double metres);

/// Textures that the cells do not resolve.
void warn_of_textures(const Facts& facts, std::vector<Warning>& warnings);

/// Yield that is missing, strains that are no longer small or those of the cells, energies that do not balance, increments that were
/// split.
void warn_of_course(const Facts& facts, const RunTotals& totals, std::vector<Warning>& warnings);

/// A body that has become hotter than its softening is known for, or than its constants are.
void warn_of_heat(const Facts& facts, const RunTotals& totals, std::vector<Warning>& warnings);

/// Wear is found with the pressure at the end of an increment, and moves no plastic strain.
void warn_of_wear(const Facts& facts, const RunTotals& totals, std::vector<Warning>& warnings);

} // namespace brinell::simulation
