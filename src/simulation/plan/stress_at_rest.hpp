// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/simulation/inclusion_shape.hpp"

#include <vector>

namespace brinell::simulation
{

/// Largest ratio of the von Mises stress to the yield stress that the own strain of inclusions causes in a body before any load, in and around them.
/// NaN: it would take too long to find in a plan.
/// @param inclusions    of the body, in cells of its grid
[[nodiscard]] double ratio_at_rest(const std::vector<elastoplastic::Inclusion>& inclusions, const VolumeGrid& grid,
                                   const constitutive::Material& material);

} // namespace brinell::simulation
