// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/constitutive/material.hpp"
#include "brinell/simulation/scenario.hpp"

namespace brinell::simulation
{

/// What a run takes at its peak, the program itself included [bytes].
/// @param lower, upper  materials of the bodies
/// @param solver        of the increments
/// @param shears        components of the shear that acts on both bodies
/// @param heat          of friction, in bodies that have thermal constants; nullptr: none is kept
[[nodiscard]] double memory_bytes(const Plan& plan, const constitutive::Material& lower,
                                  const constitutive::Material& upper, const elastoplastic::Settings& solver,
                                  int shears, const elastoplastic::HeatSettings* heat);

} // namespace brinell::simulation
