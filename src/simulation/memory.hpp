// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/constitutive/material.hpp"
#include "brinell/simulation/scenario.hpp"

namespace brinell::simulation
{

/// What a run takes at its peak, the program itself included [bytes].
/// @param lower, upper  materials of the bodies
/// @param shears        components of the shear that acts on both bodies
/// @param has_heat      whether the heat of friction is kept, in bodies that have thermal constants
[[nodiscard]] double memory_bytes(const Plan& plan, const constitutive::Material& lower,
                                  const constitutive::Material& upper, int anderson_depth, int shears, bool has_heat);

} // namespace brinell::simulation
