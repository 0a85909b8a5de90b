// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

/// Points of a measured map that were not measured.
namespace brinell::simulation
{

/// Replaces heights that are not finite by a smooth, harmonic surface: each is the mean of its four neighbours, or of
/// those within the map. The residual of these equations is 1e-9 of that of a flat surface at the mean height.
/// @param heights  row by row, in any unit
/// @throws InputError if no height is finite
[[nodiscard]] std::vector<double> filled(std::vector<double> heights, std::size_t columns);

} // namespace brinell::simulation
