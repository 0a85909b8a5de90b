// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/simulation/quality.hpp"
#include "brinell/simulation/scenario.hpp"

#include <optional>
#include <string>

namespace brinell::simulation
{

/// Wear needs surfaces that slip on each other.
/// @param reason  why nothing does; empty if something does
/// @throws KeyError
void require_wear(const Numerics& numerics, const std::string& reason);

} // namespace brinell::simulation
