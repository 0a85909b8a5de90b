// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/halfspace/surface_compliance.hpp"

#include <span>

namespace brinell::contact
{

/// Elastic stiffness of a contact, dP/d approach [N/m]: load per approach of a flat punch of its shape
/// (docs/theory/contact.md, contact-stiffness). Infinite where all cells of bodies that are periodic along both axes are
/// pressed; 0 without contact; NaN if it could not be computed.
/// @param pressure  of a solved contact, one value per cell: only where it is above zero counts
[[nodiscard]] double stiffness(const halfspace::SurfaceCompliance& compliance, std::span<const double> pressure);

} // namespace brinell::contact
