// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/simulation/scenario.hpp"

#include <string>

namespace brinell::simulation
{

/// Checks that wear is possible: the surfaces must slip on each other.
/// @param reason  why they do not slip; empty if they do
/// @throws PlanError
void require_wear(const Numerics& numerics, const std::string& reason);

} // namespace brinell::simulation
