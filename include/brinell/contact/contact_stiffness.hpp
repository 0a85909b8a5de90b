// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/halfspace/surface_compliance.hpp"

#include <span>

namespace brinell::contact
{

/// Elastic stiffness of a contact, dP/d approach [N/m]: load per approach of a flat punch with the shape of the contact area
/// (docs/theory/contact.md, contact-stiffness). Infinite if all cells of a grid that is periodic along both axes are under
/// pressure; 0 without contact; NaN if the stiffness could not be computed.
/// @param pressure  of a solved contact, one value per cell; only whether it is above zero matters
[[nodiscard]] double stiffness(const halfspace::SurfaceCompliance& compliance, std::span<const double> pressure);

} // namespace brinell::contact
