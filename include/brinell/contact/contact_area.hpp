// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/grid.hpp"

#include <span>

/// The area of a contact, finer than its cells.
namespace brinell::contact
{

/// Share of the way from the centre of the outermost cell under pressure to that of its neighbour at which the contact ends,
/// 0 to 1: docs/theory/contact.md (contact-edge).
/// @param gap_over_pressure  3/4 E' gap of the neighbour / (pressure * distance of the centres), not negative; infinite where a
///                           body ends between the two: then the edge is that of the cells, 1/2.
[[nodiscard]] double edge_position(double gap_over_pressure);

/// Area of the contact [m^2], enclosed by the line that runs through the edge between each cell under pressure and its
/// neighbours without: docs/theory/contact.md (contact-area). Contact that reaches the end of the grid ends with its cells there.
/// @param pressure, gap    of a solved contact, one value per cell [Pa], [m]
/// @param contact_modulus  E' of the pair [Pa]
[[nodiscard]] double contact_area(const SurfaceGrid& grid, std::span<const double> pressure,
                                  std::span<const double> gap, double contact_modulus);

} // namespace brinell::contact
