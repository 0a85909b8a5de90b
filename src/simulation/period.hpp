// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/simulation/indentation.hpp"
#include "roughness.hpp"

#include <optional>
#include <string>

/// Surfaces that go on without end: what they are over their period before anything deforms.
namespace brinell::simulation
{

/// Mean less smallest distance of the undeformed surfaces on the cells of the contact grid, as they lie at the first place of
/// the indentation [m]: their mean gap when they first touch.
[[nodiscard]] double touching_gap(const IndentationCase& c, const SurfaceGrid& grid);

/// Of what both textures make together of the distance at the first place, in the centres of the cells; with the slope of the
/// textures themselves, not of differences between cells.
[[nodiscard]] Roughness roughness(const IndentationCase& c, const SurfaceGrid& grid);

/// What is to be said of mean gaps that leave the surfaces apart, but for the last one, which lifts off; empty if there are none.
[[nodiscard]] std::optional<std::string> gaps_without_contact(const IndentationCase& c, double touching_gap);

/// The entry of the sequence that presses most, as load or approach; a mean gap as the approach from first touch that leaves
/// it, were the bodies elastic.
/// @throws InputError if none presses the bodies together
[[nodiscard]] contact::Drive largest_drive(const IndentationCase& c);

} // namespace brinell::simulation
