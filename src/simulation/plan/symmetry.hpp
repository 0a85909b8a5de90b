// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/simulation/scenario.hpp"

namespace brinell::simulation
{

/// Whether a shape or a texture is symmetric about the plane y = 0. For a texture only its parts are examined; a random surface
/// never counts as symmetric.
[[nodiscard]] bool is_symmetric_in_y(const Shape& shape);
[[nodiscard]] bool is_symmetric_in_y(const Texture& texture);

/// Symmetry of the fields of two bodies about y = 0, in scenarios that move them along x.
/// @param one_sided  the scenario excludes symmetry: bodies pass beside each other, or may stick, which is not solved by halves
[[nodiscard]] Symmetry symmetry_of(const ShapedBody& lower, const ShapedBody& upper, const Numerics& numerics,
                                   const SurfaceGrid& contact, bool one_sided = false);

} // namespace brinell::simulation
