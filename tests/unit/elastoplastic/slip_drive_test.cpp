// SPDX-License-Identifier: BSD-3-Clause
#include "elastoplastic/interface/slip_drive.hpp"

#include <gtest/gtest.h>

#include <array>

namespace brinell::elastoplastic::slip_drive_test
{
namespace
{

using contact::TangentialDrive;
using Kind = TangentialDrive::Kind;
using Vector = std::array<double, 2>;

constexpr SurfaceGrid grid{.nx = 5, .ny = 3, .dx = 0.5, .dy = 0.25};
constexpr TangentialDrive of_both{{Kind::force, 7.0}, {Kind::shift, 5.0}, 2.0};

TEST(SlipDriveTest, DirectionLeadsFromWhereTheSurfacesAre)
{
  EXPECT_EQ(direction_to(of_both, {4.0, 100.0}, {100.0, 1.0}), (Vector{0.6, 0.8}));
  EXPECT_EQ(direction_to(of_both, {7.0, 0.0}, {0.0, 5.0}), (Vector{0.0, 0.0}));
  // A force that is reached but for rounding has no direction.
  EXPECT_EQ(direction_to(of_both, {7.0 * (1.0 + 1e-13), 0.0}, {0.0, 4.0}), (Vector{0.0, 1.0}));
}

TEST(SlipDriveTest, AForceIsImposedAtTheEndAShiftInTheIncrement)
{
  const TangentialDrive remaining = remaining_drive(of_both, {3.0, 1.0}, 0.5);
  EXPECT_EQ(remaining, (TangentialDrive{{Kind::force, 7.0}, {Kind::shift, 4.0}, 1.5}));
}

TEST(SlipDriveTest, ACellMovesByTheShiftAndTheSpin)
{
  const SlipDrive drive{of_both, of_both, {2, 0}}; // rolls by two columns
  const int column = 4, row = 2;
  // The spin turns a point about the middle from halfway between its places before and after: one column further back.
  EXPECT_EQ(imposed_motion(grid, drive, 0, column, row), -2.0 * grid.y(row));
  EXPECT_EQ(imposed_motion(grid, drive, 1, column, row), 5.0 + 2.0 * grid.x(column - 1));
}

TEST(SlipDriveTest, MotionOfAForceIsItsShareOfWhatTheContactCarries)
{
  const TangentialDrive force{{Kind::force, 7.0}, {Kind::shift, 0.0}, 0.0};
  EXPECT_DOUBLE_EQ(driven_motion(grid, force, {4.0, 0.0}, 30.0, 1e-6), 1e-7);
  EXPECT_EQ(driven_motion(grid, force, {7.0, 0.0}, 30.0, 1e-6), 0.0);
  EXPECT_EQ(driven_motion(grid, force, {4.0, 0.0}, 0.0, 1e-6), 0.0); // without contact
  const TangentialDrive shift{{Kind::shift, 3.0}, {Kind::shift, -4.0}, 0.0};
  EXPECT_EQ(driven_motion(grid, shift, {1.0, 1.0}, 30.0, 1e-6), 5.0);
}

TEST(SlipDriveTest, OnlyImposedForcesMustBeCarried)
{
  const TangentialDrive forces{{Kind::force, 3.0}, {Kind::force, -4.0}, 0.0};
  EXPECT_TRUE(can_carry(5.001, forces));
  EXPECT_FALSE(can_carry(5.0, forces)); // all of it would slide
  EXPECT_FALSE(can_carry(4.5, forces));
  EXPECT_TRUE(can_carry(0.0, {{Kind::shift, 3.0}, {Kind::shift, 4.0}, 1.0}));
  EXPECT_TRUE(can_carry(0.0, {{Kind::force, 0.0}, {Kind::shift, 4.0}, 1.0}));
}

} // namespace
} // namespace brinell::elastoplastic::slip_drive_test
