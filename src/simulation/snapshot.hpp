// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/elastoplastic/increment.hpp"
#include "brinell/simulation/scenario.hpp"

namespace brinell::simulation
{

/// All fields of a body in its present state but for the stress; of a rigid one none.
/// @param origin  surface coordinate of column 0 of its grid [m].
[[nodiscard]] BodySnapshot body_snapshot(const elastoplastic::BodyView& body, double origin, double contact_x);
/// Shear and slip of the contact.
void set_shear(const elastoplastic::CoupledContact& pair, Snapshot& snapshot);
/// Temperatures and fluxes, where there is heat.
void set_heat(const elastoplastic::CoupledContact& pair, Snapshot& snapshot);
/// What the surfaces have lost, where they wear.
void set_wear(const elastoplastic::CoupledContact& pair, Snapshot& snapshot);
/// The stress.
void set_stress(const elastoplastic::CoupledContact::Stress& stress, BodySnapshot& snapshot);

} // namespace brinell::simulation
