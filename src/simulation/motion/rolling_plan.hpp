// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/simulation/rolling.hpp"

namespace brinell::simulation
{

/// Distance that the contact rolls in the time of a step of pressing on or lifting off [m]. With creepage both take at least as
/// long as the contact rolls over its own length, whatever the cells: what the shear has stored becomes heat in this time.
[[nodiscard]] double way_of_load_step(const RollingCase& rolling, const RollingPlan& plan);

/// Distance that the contact rolls in the time of a pass with its way back [m].
[[nodiscard]] double way_of_pass(const RollingCase& rolling, const RollingPlan& plan);

} // namespace brinell::simulation
