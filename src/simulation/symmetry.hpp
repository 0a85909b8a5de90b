// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/simulation/scenario.hpp"

namespace brinell::simulation
{

/// Whether a shape, or a texture, is the same on both sides of the plane y = 0. Of a texture what can be told from its parts: of
/// a random surface never.
[[nodiscard]] bool is_symmetric_in_y(const Shape& shape);
[[nodiscard]] bool is_symmetric_in_y(const Texture& texture);

/// What the fields of two bodies have in common on both sides of y = 0 in scenarios that move them along x.
/// @param one_sided  the scenario says so: bodies pass beside each other, or may hold each other, which is not solved by halves
[[nodiscard]] Symmetry symmetry_of(const ShapedBody& lower, const ShapedBody& upper, const Numerics& numerics,
                                   const SurfaceGrid& contact, bool one_sided = false);

} // namespace brinell::simulation
