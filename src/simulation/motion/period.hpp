// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/simulation/indentation.hpp"
#include "simulation/plan/roughness.hpp"

#include <optional>
#include <string>

/// Periodic surfaces before they deform.
namespace brinell::simulation
{

/// Mean gap at which the undeformed surfaces first touch: mean minus smallest distance on the cells of the contact grid, at the
/// first place of the indentation [m].
[[nodiscard]] double touching_gap(const IndentationCase& c, const SurfaceGrid& grid);

/// Combined roughness of both textures at the first place, at the centres of the cells; the slope is that of the textures
/// themselves, not of differences between cells.
[[nodiscard]] Roughness roughness(const IndentationCase& c, const SurfaceGrid& grid);

/// The entry of the sequence with the strongest contact, as load or approach. A mean gap is converted to the approach from first
/// touch that would cause it in elastic bodies.
/// @throws InputError if no entry presses the bodies together
[[nodiscard]] contact::Drive largest_drive(const IndentationCase& c);

} // namespace brinell::simulation
