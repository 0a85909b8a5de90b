// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/simulation/tugging.hpp"

namespace brinell::simulation
{

/// Cells by which the bodies move relative to each other per step; if this is not an integer the surfaces are interpolated.
/// @param shift  mean arc of a step on the bodies [m]
[[nodiscard]] double relative_cells(double shift, double dx);

/// The circles of both bodies in the plane of motion.
/// @throws InputError if one of them has none
[[nodiscard]] Passing passing(const TuggingCase& tugging, double shift, double dx);

/// Factor on the number of steps of a heated pass, for passes that take longer than those of rigid spheres.
inline constexpr double reserve_of_heated_pass = 4.0;

} // namespace brinell::simulation
