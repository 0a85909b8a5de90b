// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/elastoplastic/increment.hpp"
#include "brinell/simulation/scenario.hpp"

#include <span>
#include <vector>

namespace brinell::simulation
{

/// The grid of a body and the fields of its surface; a rigid body has no fields.
/// @param origin  surface coordinate of column 0 of its grid [m].
[[nodiscard]] BodySnapshot surface_snapshot(const elastoplastic::BodyView& body, double origin, double contact_x);
/// The fields within a body, computed on demand.
/// @param stress, temperature  functions that compute these fields; `temperature` is empty without heat
/// @param states               function that returns the states of some cells
using StatesOfCells =
    std::function<std::vector<elastoplastic::CoupledContact::CellState>(std::span<const std::size_t> cells)>;
[[nodiscard]] StepFields::Within fields_within(const elastoplastic::BodyView& body,
                                               const std::function<elastoplastic::CoupledContact::Stress()>& stress,
                                               std::function<std::vector<double>()> temperature, StatesOfCells states);
/// Fills shear and slip of the contact.
void set_shear(const elastoplastic::CoupledContact& pair, Snapshot& snapshot);
/// Fills temperatures and heat fluxes, if there is heat.
void set_heat(const elastoplastic::CoupledContact& pair, Snapshot& snapshot);
/// Current height of a surface from texture, residual displacement and depths of effects, positive out of the body [m].
[[nodiscard]] std::vector<double> surface_height(const elastoplastic::CoupledContact& pair, std::size_t side);
/// Fills the fields of effects, and the heights of textured surfaces.
void set_effects(const elastoplastic::CoupledContact& pair, Snapshot& snapshot);

} // namespace brinell::simulation
