// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/simulation/tugging.hpp"

namespace brinell::simulation
{

/// Cells by which the bodies move against each other per step; between whole numbers the surfaces are interpolated.
[[nodiscard]] double relative_cells(const TuggingCase& tugging, double dx);

/// Interference at which one of the bodies first yields [m]; the full interference if none does before.
[[nodiscard]] double yield_interference(const TuggingCase& tugging);

} // namespace brinell::simulation
