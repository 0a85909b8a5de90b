// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/simulation/scenario.hpp"

/// Inclusions of the bodies in plans.
namespace brinell::simulation
{

/// Depth that the grids have to reach for the inclusions: down to the deepest one, but at most three times `depth`, that of the
/// stress beneath the contact, beneath which inclusions have no effect [m].
[[nodiscard]] double depth_with_inclusions(const ShapedBody& lower, const ShapedBody& upper, double depth);

/// Counts the cells of the inclusions of both bodies on the grids of a plan.
/// @param beside  y of the contact's centre on each body [m]
/// @throws PlanError where they do not fit, or do not go with other members of the case
[[nodiscard]] std::array<EmbeddedCells, 2> embedded_cells(const PairCase& c, const Plan& plan,
                                                          const std::array<double, 2>& beside);

} // namespace brinell::simulation
