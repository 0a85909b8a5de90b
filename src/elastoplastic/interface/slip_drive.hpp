// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/contact/tangential_contact.hpp"
#include "brinell/foundation/grid.hpp"

#include <array>
#include <cstddef>

/// Shift, force and spin that an increment imposes on two surfaces that may stick, and the columns by which they roll.
namespace brinell::elastoplastic
{

struct SlipDrive
{
  contact::TangentialDrive end;   ///< at the end of the increment; shift and spin since the start
  contact::TangentialDrive along; ///< in the increment; a force is that at its end
  std::array<int, 2> carried{};   ///< cells by which the surfaces move through the contact grid
};

/// Imposed force or shift along x (axis 0) or y (axis 1).
[[nodiscard]] inline const contact::TangentialDrive::Axis& axis_of(const contact::TangentialDrive& drive,
                                                                   std::size_t axis)
{
  return axis == 0 ? drive.x : drive.y;
}

[[nodiscard]] inline bool is_forced(const contact::TangentialDrive& drive, std::size_t axis)
{
  return axis_of(drive, axis).kind == contact::TangentialDrive::Kind::force;
}

/// Unit vector from the present force or shift to the imposed one; zero: no direction.
/// @param force, shift  now [N], [m]
[[nodiscard]] std::array<double, 2> direction_to(const contact::TangentialDrive& along,
                                                 const std::array<double, 2>& force,
                                                 const std::array<double, 2>& shift);

/// Part of a drive that an increment has to add.
/// @param shift, turned  shift and rotation before the increment [m], [rad]
[[nodiscard]] contact::TangentialDrive remaining_drive(const contact::TangentialDrive& end,
                                                       const std::array<double, 2>& shift, double turned);

/// Rigid displacement of the upper body relative to the lower one that is imposed on a cell in the increment, by shift and spin;
/// the shift that follows from an imposed force is not included [m].
[[nodiscard]] double imposed_motion(const SurfaceGrid& grid, const SlipDrive& drive, std::size_t axis, int column,
                                    int row);

/// Estimate of the relative displacement that the drive causes in the increment; for a force, with the compliance of full stick.
/// @param force      before the increment [N]
/// @param carried    largest force that the contact can carry before the increment [N]
/// @param displaced  estimate of the displacement of the surfaces by shears at their bound [m]
/// @returns 0 if nothing is driven [m]
[[nodiscard]] double driven_motion(const SurfaceGrid& grid, const contact::TangentialDrive& along,
                                   const std::array<double, 2>& force, double carried, double displaced);

/// Whether a contact that carries at most the force `carried` [N] can carry the imposed one.
[[nodiscard]] bool can_carry(double carried, const contact::TangentialDrive& along);

} // namespace brinell::elastoplastic
