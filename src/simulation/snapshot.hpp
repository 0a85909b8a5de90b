// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/elastoplastic/increment.hpp"
#include "brinell/simulation/scenario.hpp"

namespace brinell::simulation
{

/// All fields of a body in its present state.
/// @param place   of the contact grid on the body's grid.
/// @param origin  surface coordinate of its column 0 [m].
[[nodiscard]] BodySnapshot body_snapshot(const elastoplastic::CoupledContact& pair, const elastoplastic::Body& body,
                                         const elastoplastic::Place& place, double origin, double contact_x);

} // namespace brinell::simulation
