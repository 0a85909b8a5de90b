// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/constitutive/material.hpp"
#include "brinell/simulation/scenario.hpp"

namespace brinell::simulation
{

/// Peak memory of a run, including the program itself [bytes].
/// @param lower, upper  materials of the bodies
/// @param solver        of the increments
/// @param shears        number of components of the shear between the bodies, 0 to 2
/// @param heat          settings of heat, in bodies that have thermal constants; nullptr: heat is not computed
[[nodiscard]] double memory_bytes(const Plan& plan, const constitutive::Material& lower,
                                  const constitutive::Material& upper, const elastoplastic::Settings& solver,
                                  int shears, const elastoplastic::HeatSettings* heat);

} // namespace brinell::simulation
