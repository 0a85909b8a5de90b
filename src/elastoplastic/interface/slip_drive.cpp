// SPDX-License-Identifier: BSD-3-Clause
#include "slip_drive.hpp"

#include "contact/carried_field.hpp"

#include <cmath>

namespace brinell::elastoplastic
{

using contact::TangentialDrive;

std::array<double, 2> direction_to(const TangentialDrive& along, const std::array<double, 2>& force,
                                   const std::array<double, 2>& shift)
{
  std::array<double, 2> way{};
  for (std::size_t axis = 0; axis < 2; ++axis)
  {
    const double value = axis_of(along, axis).value;
    way[axis] = value - (is_forced(along, axis) ? force : shift)[axis];
    // A force of zero is reached only to rounding, and rounding must not define a direction.
    if (is_forced(along, axis) && std::abs(way[axis]) <= 1e-9 * (std::abs(value) + std::abs(force[axis])))
      way[axis] = 0.0;
  }
  const double size = std::hypot(way[0], way[1]);
  return size > 0.0 ? std::array{way[0] / size, way[1] / size} : std::array{0.0, 0.0};
}

TangentialDrive remaining_drive(const TangentialDrive& end, const std::array<double, 2>& shift, double turned)
{
  TangentialDrive remaining = end;
  remaining.spin -= turned;
  if (!is_forced(end, 0))
    remaining.x.value -= shift[0];
  if (!is_forced(end, 1))
    remaining.y.value -= shift[1];
  return remaining;
}

double imposed_motion(const SurfaceGrid& grid, const SlipDrive& drive, std::size_t axis, int column, int row)
{
  const double shift = is_forced(drive.along, axis) ? 0.0 : axis_of(drive.along, axis).value;
  const contact::Along turned = contact::turned(grid, drive.carried, drive.along.spin, column, row);
  return shift + (axis == 0 ? turned.x : turned.y);
}

double driven_motion(const SurfaceGrid& grid, const TangentialDrive& along, const std::array<double, 2>& force,
                     double carried, double displaced)
{
  double squares = std::pow(along.spin * std::hypot(grid.x(grid.nx - 1), grid.y(grid.ny - 1)), 2);
  for (std::size_t axis = 0; axis < 2; ++axis)
  {
    const double value = axis_of(along, axis).value;
    constexpr double rounding = 1e-12; // of a sum of shears: a force of zero is reached to this accuracy
    const double share = carried > 0.0 ? std::abs(value - force[axis]) / carried : 0.0;
    squares += std::pow(is_forced(along, axis) ? (share > rounding ? share * displaced : 0.0) : value, 2);
  }
  return std::sqrt(squares);
}

bool can_carry(double carried, const TangentialDrive& along)
{
  double squares = 0.0;
  for (std::size_t axis = 0; axis < 2; ++axis)
    squares += is_forced(along, axis) ? std::pow(axis_of(along, axis).value, 2) : 0.0;
  constexpr double margin = 1e-8; // larger than the margin of TangentialContact, which rejects the remaining cases
  return squares == 0.0 || std::sqrt(squares) < (1.0 - margin) * carried;
}

} // namespace brinell::elastoplastic
