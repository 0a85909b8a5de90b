// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "footprint.hpp"

/// What textures add to the footprint of smooth bodies.
namespace brinell::simulation
{

/// Widens the footprint of the smooth bodies to what their textures touch. Where the smooth bodies would stay elastic it need
/// only be as deep as the stress of the texture goes: a wavelength, over which exp(-kz) (1 + kz) falls to 1.4 %.
/// @param modulus  E' of the pair [Pa]
void add_textures(const ShapedBody& lower, const ShapedBody& upper, const contact::Drive& drive, double modulus,
                  const Domain& domain, Footprint& footprint);

/// Textures of bodies that have no shape, in a period: what the wave that stands for them needs.
/// @param modulus  E' of the pair [Pa]
/// @param yield_pressure  peak pressure at which a point contact first yields [Pa]
/// @throws KeyError of textures that leave the distance of the bodies the same everywhere
[[nodiscard]] Footprint of_flats(const ShapedBody& lower, const ShapedBody& upper, double modulus,
                                 double yield_pressure, const contact::Drive& drive, const Domain& domain);

} // namespace brinell::simulation
