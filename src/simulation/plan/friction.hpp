// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/simulation/scenario.hpp"

#include <string>

namespace brinell::simulation
{

/// Checks that friction is possible: surfaces must slide, and at least one body must deform.
/// @param reason  why the surfaces do not slide; empty if they do
/// @throws PlanError
void require_friction(const PairCase& c, const std::string& reason);

/// F_X over F_n; 0 without contact, and where F_n is what rounding leaves of it.
[[nodiscard]] double force_ratio(double F_X, double F_n, const Plan& plan);

} // namespace brinell::simulation
