// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/contact/tangential_contact.hpp"

#include <cstddef>

namespace brinell::elastoplastic
{

/// Imposed force or shift along x (axis 0) or y (axis 1).
[[nodiscard]] inline const contact::TangentialDrive::Axis& axis_of(const contact::TangentialDrive& drive,
                                                                   std::size_t axis)
{
  return axis == 0 ? drive.x : drive.y;
}

} // namespace brinell::elastoplastic
