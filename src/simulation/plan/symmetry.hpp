// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/simulation/scenario.hpp"

namespace brinell::simulation
{

/// Whether a shape or a texture is symmetric about the plane y = 0. For a texture only its parts are examined; a random surface
/// never counts as symmetric.
[[nodiscard]] bool is_symmetric_in_y(const Shape& shape);
[[nodiscard]] bool is_symmetric_in_y(const Texture& texture);

/// Whether both sides of the plane y = 0 are mirror images and half of each body is solved, in scenarios that move them along x.
/// @param one_sided  the scenario excludes it: bodies pass beside each other, or may stick, which is not solved by halves
[[nodiscard]] bool is_solved_by_halves(const PairCase& c, const SurfaceGrid& contact, bool one_sided = false);

/// Mirrors the grids of a plan, or not.
inline void mirror_grids(bool is_mirrored, Plan& plan)
{
  plan.contact.is_mirrored_y = plan.lower.surface.is_mirrored_y = plan.upper.surface.is_mirrored_y = is_mirrored;
}

} // namespace brinell::simulation
