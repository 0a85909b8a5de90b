// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/simulation/scenario.hpp"

#include <string>

namespace brinell::simulation
{

/// Friction needs surfaces that slide, and one of them to deform.
/// @param reason  why nothing slides; empty if something does
/// @throws KeyError
void require_friction(const Numerics& numerics, const ShapedBody& lower, const ShapedBody& upper,
                      const std::string& reason);

} // namespace brinell::simulation
