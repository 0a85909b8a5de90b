// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/grid.hpp"

#include <span>
#include <vector>

/// The area of a contact and of each of its patches, with subcell resolution.
namespace brinell::contact
{

/// Position of the contact edge between the centre of the outermost cell under pressure (0) and that of its neighbour without
/// pressure (1): docs/theory/contact.md (contact-edge).
/// @param gap_over_pressure  3/4 E' gap of the neighbour / (pressure * distance of the centres), not negative; infinite where a
///                           body ends between the two cells: then the contact edge is the edge of the cells, 1/2.
[[nodiscard]] double edge_position(double gap_over_pressure);

/// Area of the contact [m^2], enclosed by the line that runs through the edge between each cell under pressure and its
/// neighbours without: docs/theory/contact.md (contact-area). A contact that reaches the end of the grid ends there with its
/// cells.
/// @param pressure, gap    of a solved contact, one value per cell [Pa], [m]
/// @param contact_modulus  E' of the pair [Pa]
[[nodiscard]] double contact_area(const SurfaceGrid& grid, std::span<const double> pressure,
                                  std::span<const double> gap, double contact_modulus);

/// Patches of a contact: cells under pressure that are connected by their sides.
struct Patches
{
  std::vector<int>
      label; ///< of each cell: index of its patch, in the order of the patches' first cells; -1 without pressure
  std::vector<double> area; ///< of each patch [m^2]; their sum is contact_area
};

/// The patches of a contact; along a periodic axis they continue across the end of the grid: docs/theory/contact.md
/// (contact-area). Parameters as for contact_area.
[[nodiscard]] Patches patches(const SurfaceGrid& grid, std::span<const double> pressure, std::span<const double> gap,
                              double contact_modulus);

} // namespace brinell::contact
