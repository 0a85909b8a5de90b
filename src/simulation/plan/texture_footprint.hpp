// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "footprint.hpp"

/// Effect of textures on the footprint of smooth bodies.
namespace brinell::simulation
{

/// Extends the footprint of the smooth bodies to the contact of their textures. If the smooth bodies would stay elastic, it need
/// only be as deep as the stress due to the texture: one wavelength, at which exp(-kz) (1 + kz) has fallen to 1.4 %.
/// @param modulus  E' of the pair [Pa]
void add_textures(const ShapedBody& lower, const ShapedBody& upper, const contact::Drive& drive, double modulus,
                  const Domain& domain, Footprint& footprint);

/// Footprint of textures on flats, over a period, by an equivalent single wave.
/// @param modulus  E' of the pair [Pa]
/// @param yield_pressure  peak pressure at which a point contact first yields [Pa]
/// @throws PlanError if the textures leave the distance of the bodies the same everywhere
[[nodiscard]] Footprint of_flats(const ShapedBody& lower, const ShapedBody& upper, double modulus,
                                 double yield_pressure, const contact::Drive& drive, const Domain& domain);

} // namespace brinell::simulation
