// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/simulation/scenario.hpp"

#include <string>

namespace brinell::simulation
{

/// Checks that the effects between the surfaces are possible.
/// @param why_no_slip  why the surfaces do not slip on each other; empty if they do
/// @throws PlanError
void require_effects(const PairCase& c, const std::string& why_no_slip);

} // namespace brinell::simulation
