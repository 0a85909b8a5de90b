// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/elastoplastic/increment.hpp"
#include "brinell/simulation/scenario.hpp"

#include <span>
#include <vector>

namespace brinell::simulation
{

/// The grid of a body and the fields of its surface; of a rigid one no fields.
/// @param origin  surface coordinate of column 0 of its grid [m].
[[nodiscard]] BodySnapshot surface_snapshot(const elastoplastic::BodyView& body, double origin, double contact_x);
/// The fields within a body.
/// @param stress, temperature  compute those of this body; the latter is empty without heat
[[nodiscard]] StepFields::Within fields_within(const elastoplastic::BodyView& body,
                                               std::function<elastoplastic::CoupledContact::Stress()> stress,
                                               std::function<std::vector<double>()> temperature);
/// Shear and slip of the contact.
void set_shear(const elastoplastic::CoupledContact& pair, Snapshot& snapshot);
/// Temperatures and fluxes, where there is heat.
void set_heat(const elastoplastic::CoupledContact& pair, Snapshot& snapshot);
/// What a surface of the pair, 0 the lower one, has lost on its grid [m]; empty without wear.
[[nodiscard]] std::span<const double> worn_depth(const elastoplastic::CoupledContact& pair, std::size_t side);
/// A surface as it is now, texture, residual displacement and what is worn off, out of the body positive [m].
[[nodiscard]] std::vector<double> surface_height(const elastoplastic::BodyView& body, std::span<const double> worn);
/// What the surfaces have lost, where they wear, and how high textured ones are.
void set_surfaces(const elastoplastic::CoupledContact& pair, Snapshot& snapshot);

} // namespace brinell::simulation
