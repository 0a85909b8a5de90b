// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/simulation/forces.hpp"
#include "simulation/plan/friction.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace brinell::simulation::forces_test
{
namespace
{

constexpr double rounding = 1e-14;

/// A contact of a few cells in the middle of a grid, between surfaces that are planes.
class ForcesTest : public testing::Test
{
protected:
  ForcesTest() : pressure(grid.size(), 0.0), lower(grid.size(), 0.0), upper(grid.size(), 0.0)
  {
    for (const int j : {1, 2, 3})
      for (const int i : {2, 3, 4})
        at(pressure, i, j) = 1e9;
    load = 9.0 * 1e9 * grid.cell_area();
  }
  double& at(std::vector<double>& field, int i, int j) const { return field[grid.index(i, j)]; }
  void tilt(std::vector<double>& field, double slope_x, double slope_y) const
  {
    for (int j = 0; j < grid.ny; ++j)
      for (int i = 0; i < grid.nx; ++i)
        at(field, i, j) = 1e-4 + slope_x * i * grid.dx + slope_y * j * grid.dy;
  }
  [[nodiscard]] Forces forces(double theta, double share = 0.5) const
  {
    return project_forces(grid, {.pressure = pressure}, theta, {lower, share}, {upper, 1.0 - share});
  }

  const SurfaceGrid grid{7, 5, 2e-3, 3e-3};
  std::vector<double> pressure, lower, upper;
  double load = 0.0;
};

TEST_F(ForcesTest, MacroProjection)
{
  const double theta = -0.03;
  const Forces f = forces(theta);
  EXPECT_NEAR(f.F_n, load, rounding * load); // each cell once: no factor n
  EXPECT_NEAR(f.F_X_macro, load * std::sin(0.03), rounding * load);
  EXPECT_NEAR(f.F_Z_macro, load * std::cos(0.03), rounding * load);
  EXPECT_NEAR(f.F_X, f.F_X_macro, rounding * load); // no residual displacement
  EXPECT_NEAR(f.F_Z, f.F_Z_macro, rounding * load);
  EXPECT_EQ(f.F_Y, 0.0);
}

TEST_F(ForcesTest, ResistsBeforeAlignmentAndDrivesAfterIt)
{
  EXPECT_GT(forces(-0.02).F_X, 0.0);
  EXPECT_EQ(forces(0.0).F_X, 0.0);
  EXPECT_LT(forces(0.02).F_X, 0.0);
  EXPECT_EQ(forces(-0.02).F_X, -forces(0.02).F_X);
}

TEST_F(ForcesTest, PileUpInFrontResists)
{
  // The upper body moves towards +x. Ahead of the contact (larger x) material of the lower body has been pushed up: its
  // displacement, positive into the body, falls along x.
  tilt(lower, -0.01, 0.0);
  EXPECT_GT(forces(0.0).F_X, 0.0);
  EXPECT_GT(forces(0.0).F_X_lower, 0.0);
  EXPECT_EQ(forces(0.0).F_X_upper, 0.0);
  // On the upper body the contact moves towards -x', and the pile-up lies there: its displacement grows along x'.
  tilt(lower, 0.0, 0.0);
  tilt(upper, 0.01, 0.0);
  EXPECT_GT(forces(0.0).F_X, 0.0);
  EXPECT_GT(forces(0.0).F_X_upper, 0.0);
  EXPECT_EQ(forces(0.0).F_X_lower, 0.0);
}

TEST_F(ForcesTest, MeanPlaneWeighsTheSlopesWithTheArcs)
{
  const double theta = 0.02, s1 = -0.013, s2 = 0.007;
  tilt(lower, s1, 0.0);
  tilt(upper, s2, 0.0);
  for (const double share : {0.5, 0.3, 1.0})
  {
    const Forces f = forces(theta, share);
    const double plane = theta + std::atan(share * s1 - (1.0 - share) * s2);
    EXPECT_NEAR(f.F_X, -load * std::sin(plane), rounding * load);
    EXPECT_NEAR(f.F_Z, load * std::cos(plane), rounding * load);
    EXPECT_NEAR(f.F_X_lower, -load * std::sin(theta + std::atan(s1)), rounding * load); // Eq. 18, read on one body
    EXPECT_NEAR(f.F_X_upper, -load * std::sin(theta - std::atan(s2)), rounding * load);
    EXPECT_NEAR(f.F_X_macro, -load * std::sin(theta), rounding * load);
  }
}

TEST_F(ForcesTest, EqualAndOppositeSlopesLeaveTheMacroPlane)
{
  // Two surfaces that fit into each other: the same wavy plane on both, seen from either side.
  tilt(lower, 0.01, 0.0);
  tilt(upper, 0.01, 0.0);
  EXPECT_NEAR(forces(0.02).F_X, forces(0.02).F_X_macro, rounding * load);
}

TEST_F(ForcesTest, SidewaysForceFollowsTheSlopeInYAndVanishesBySymmetry)
{
  tilt(lower, 0.0, 0.01);
  EXPECT_NEAR(forces(0.0).F_Y, -load * std::sin(std::atan(0.005)), rounding * load);
  EXPECT_NEAR(forces(0.0).F_Z, load * std::cos(std::atan(0.005)), rounding * load);
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i)
      at(lower, i, j) = 1e-6 * (i + 1) * (j - 2) * (j - 2);
  EXPECT_NEAR(forces(0.01).F_Y, 0.0, 1e-17 * load);
}

TEST_F(ForcesTest, OnlyTheSlopeUnderThePressureCounts)
{
  for (const int j : {0, 1, 2, 3, 4})
    at(lower, 0, j) = 1e-3; // a step outside the contact, not next to it
  EXPECT_NEAR(forces(0.0).F_X, 0.0, rounding * load);
}

TEST_F(ForcesTest, SlopeAtTheEdgeOfTheGridIsOneSided)
{
  std::fill(pressure.begin(), pressure.end(), 1e9);
  load = 1e9 * grid.cell_area() * static_cast<double>(grid.size());
  tilt(lower, -0.02, 0.0);
  EXPECT_NEAR(forces(0.0, 1.0).F_X, load * std::sin(std::atan(0.02)), rounding * load);
}

// A body that has been lifted off may keep a force of some ulp, and with it a ratio of any size.
TEST(ForceRatioTest, OfForcesThatRoundingLeavesIsZero)
{
  Plan plan;
  plan.contact = {.nx = 3, .ny = 3, .dx = 1e-6, .dy = 1e-6};
  plan.peak_pressure = 1e9;
  EXPECT_DOUBLE_EQ(force_ratio(1e-4, 1e-3, plan), 0.1) << "one cell";
  EXPECT_DOUBLE_EQ(force_ratio(1e-8, 1e-9, plan), 10.0);
  EXPECT_EQ(force_ratio(1e-10, 1e-13, plan), 0.0);
  EXPECT_EQ(force_ratio(0.0, 0.0, plan), 0.0);
}

} // namespace
} // namespace brinell::simulation::forces_test
