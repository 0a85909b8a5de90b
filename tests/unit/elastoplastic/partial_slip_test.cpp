// SPDX-License-Identifier: BSD-3-Clause
// Stick and slip in an increment.
#include "sphere_press.hpp"
#include "state_comparison.hpp"

#include "brinell/contact/frictional_contact.hpp"
#include "brinell/foundation/error.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace brinell::elastoplastic::partial_slip_test
{
namespace
{

using contact::TangentialDrive;

PressOptions sticking(double coefficient)
{
  PressOptions options;
  options.settings = tight_settings();
  options.friction.coefficient = coefficient;
  options.sticks = true;
  return options;
}

Strategy accelerated(const PressOptions& options, Integration integration = Integration::path)
{
  Strategy strategy;
  strategy.integration = integration;
  strategy.max_evaluations = options.settings.max_evaluations;
  return strategy;
}

TangentialDrive shift(double x, double y = 0.0)
{
  return {{TangentialDrive::Kind::shift, x}, {TangentialDrive::Kind::shift, y}, 0.0};
}

TangentialDrive force(double x, double y = 0.0)
{
  return {{TangentialDrive::Kind::force, x}, {TangentialDrive::Kind::force, y}, 0.0};
}

const PartialSlip& interface_of(const SpherePress& press)
{
  return *press.contact().partial_slip();
}

double force_x(const SpherePress& press)
{
  return interface_of(press).forces()[0];
}

/// What takes both spheres to full sliding, in units of which the shifts are [m].
constexpr double sliding_shift = 0.5 * SpherePress::alpha_c;

TEST(PartialSlipTest, ElasticBodiesAreThoseOfTheFrictionalContact)
{
  // Stick and slip of elastic bodies has a solver of its own one floor below, with its own history of shifts and pressures: the
  // same to the tolerances of both.
  for (const double stiffness : {1.0, 4.0})
  {
    PressOptions options = sticking(0.4);
    options.lower_plastic = options.upper_plastic = false;
    options.upper_stiffness = stiffness;
    SpherePress press(options);
    const Elastic lower = press.contact().lower().material().elastic,
                  upper = press.contact().upper().material().elastic;
    const SurfaceGrid& grid = press.contact().grid();
    const halfspace::SurfaceCompliance compliance(grid, lower, upper);
    contact::FrictionalContact reference(compliance);
    contact::FrictionState state(grid.size());
    std::vector<double> gap(grid.size()), slip_x(grid.size()), slip_y(grid.size());
    const contact::FrictionTolerances tolerances{1e-15, 1e-15};
    double before_x = 0.0, before_y = 0.0;
    for (const auto& [depth, x, y] :
         {std::array{3.0, 0.0, 0.0}, {6.0, 0.2, 0.1}, {6.0, 0.5, 0.1}, {5.0, -0.3, 0.4}, {5.0, 0.2, 0.4}})
    {
      const double sx = x * sliding_shift, sy = y * sliding_shift, before = interface_of(press).state().total_heat;
      ASSERT_TRUE(press.press(depth, accelerated(options), 0, shift(sx, sy)).converged);
      const contact::FrictionReport report =
          reference.step(press.rigid_gap(depth), {}, shift(sx - before_x, sy - before_y), 0.4, tolerances, state, gap,
                         {slip_x, slip_y});
      EXPECT_TRUE(report.converged);
      // The heat is the same where the bound stays: there both count it with the same shear.
      const bool bound_stays = stiffness == 1.0 && (x == 0.5 || sx - before_x == 0.5 * sliding_shift);
      if (bound_stays)
      {
        EXPECT_NEAR(interface_of(press).state().total_heat - before, report.tangential.dissipated,
                    1e-6 * report.tangential.dissipated);
      }
      before_x = sx;
      before_y = sy;
    }
    const auto [shear_x, shear_y] = interface_of(press).shears();
    expect_near(copy(shear_x), state.shear_x, 1e-6, "shear along x");
    expect_near(copy(shear_y), state.shear_y, 1e-6, "shear along y");
    expect_near(copy(press.contact().pressure()), state.pressure, 1e-6, "pressure");
    EXPECT_GT(interface_of(press).state().sticking, 0);
    EXPECT_LT(interface_of(press).state().sticking, interface_of(press).state().pressed);
    EXPECT_GT(interface_of(press).state().total_heat, 0.0);
  }
}

TEST(PartialSlipTest, EqualBodiesThatAreOnlyPressedHaveNoShear)
{
  // They are displaced alike, to the last digit: what friction adds is nothing at all.
  PressOptions options = sticking(0.3);
  SpherePress press(options), smooth({.settings = options.settings});
  for (const double depth : {3.0, 6.0, 2.0})
  {
    ASSERT_TRUE(press.press(depth).converged);
    ASSERT_TRUE(smooth.press(depth).converged);
  }
  EXPECT_EQ(copy(press.contact().pressure()), copy(smooth.contact().pressure()));
  EXPECT_EQ(press.contact().lower().state().plastic_strain, smooth.contact().lower().state().plastic_strain);
  EXPECT_EQ(force_x(press), 0.0);
  EXPECT_EQ(interface_of(press).state().total_heat, 0.0);
  EXPECT_EQ(interface_of(press).state().sticking, interface_of(press).state().pressed);
}

TEST(PartialSlipTest, FarShiftsAreFullSliding)
{
  // Where all slips, the shear is friction times pressure along the shift, but for the angle by which the displacements along y
  // turn the slip: their size over that of the shift, 1e-3 here.
  for (const double stiffness : {1.0, 2.0})
  {
    PressOptions options = sticking(0.25);
    options.hardening_modulus = 20e9;
    options.upper_stiffness = stiffness;
    SpherePress press(options);
    options.sticks = false;
    SpherePress sliding(options);
    // The same increments; friction of unlike bodies acts while they are pressed, too, so that they begin together here.
    const double first = 1e-3;
    ASSERT_TRUE(press.press(first, accelerated(options)).converged);
    ASSERT_TRUE(sliding.press(first, accelerated(options), 0, {}, false).converged);
    double way = 0.0;
    for (const double depth : {2.0, 4.0, 6.0})
    {
      way += 500.0 * sliding_shift;
      ASSERT_TRUE(press.press(depth, accelerated(options), 0, shift(way)).converged);
      ASSERT_TRUE(sliding.press(depth, accelerated(options)).converged);
    }
    EXPECT_EQ(interface_of(press).state().sticking, 0);
    EXPECT_NEAR(force_x(press) / sliding.contact().sliding()->forces()[0], 1.0, 1e-5);
    EXPECT_NEAR(press.load() / sliding.load(), 1.0, 1e-5);
    expect_near(copy(interface_of(press).shears()[0]), copy(sliding.contact().sliding()->shears()[0]), 1e-3, "shear");
    expect_near(press.contact().lower().state().plastic_strain, sliding.contact().lower().state().plastic_strain, 2e-3,
                "plastic strain");
    expect_near(press.contact().upper().state().plastic_strain, sliding.contact().upper().state().plastic_strain, 2e-3,
                "plastic strain of the upper body");
    const auto& stress = press.contact().lower().state().stress;
    expect_near(stress, sliding.contact().lower().state().stress, 2e-3, "stress");
    EXPECT_NEAR(interface_of(press).limited_share(), sliding.contact().sliding()->limited_share(), 1e-12);
  }
}

TEST(PartialSlipTest, WithoutLimitOfFrictionAllSticks)
{
  PressOptions options = sticking(1e3);
  options.friction.shear_limit = 1e3 * SpherePress::yield_stress;
  options.upper_plastic = false;
  options.hardening_modulus = 50e9;
  SpherePress press(options);
  for (const auto& [depth, x] : {std::array{3.0, 0.0}, {5.0, 0.2}, {5.0, -0.2}})
    ASSERT_TRUE(press.press(depth, accelerated(options), 0, shift(x * sliding_shift)).converged);
  EXPECT_EQ(interface_of(press).state().sticking, interface_of(press).state().pressed);
  EXPECT_EQ(interface_of(press).state().total_heat, 0.0);
  EXPECT_EQ(largest(copy(interface_of(press).state().path)), 0.0);
  EXPECT_LT(force_x(press), 0.0);
}

TEST(PartialSlipTest, SwappedBodiesAndTheOtherWayAreTheSameContact)
{
  // Seen from the upper body the lower one is shifted the other way, and carries the opposite shear.
  PressOptions options = sticking(0.4);
  options.hardening_modulus = 20e9;
  options.upper_plastic = false;
  PressOptions other = options;
  std::swap(other.lower_plastic, other.upper_plastic);
  SpherePress press(options), swapped(other);
  for (const auto& [depth, x, y] : {std::array{3.0, 0.0, 0.0}, {6.0, 0.4, 0.2}, {6.0, -0.2, 0.3}})
  {
    ASSERT_TRUE(press.press(depth, accelerated(options), 0, shift(x * sliding_shift, y * sliding_shift)).converged);
    ASSERT_TRUE(swapped.press(depth, accelerated(options), 0, shift(-x * sliding_shift, -y * sliding_shift)).converged);
  }
  for (std::size_t axis = 0; axis < 2; ++axis)
  {
    std::vector<double> opposite = copy(interface_of(swapped).shears()[axis]);
    for (double& q : opposite)
      q = -q;
    expect_near(copy(interface_of(press).shears()[axis]), opposite, 1e-5, "shear");
  }
  EXPECT_NEAR(interface_of(press).state().total_heat / interface_of(swapped).state().total_heat, 1.0, 1e-5);
  expect_near(press.contact().lower().state().plastic_strain, swapped.contact().upper().state().plastic_strain, 1e-5,
              "plastic strain");
}

TEST(PartialSlipTest, DescentUnderAHeldBoundFindsTheSameSolution)
{
  // The bound is held while the energy is watched, and renewed after that; both take the strength of the surfaces from before the
  // increment. For unlike bodies shear and gap are coupled.
  for (const bool by_force : {false, true})
    for (const double stiffness : {1.0, 3.0})
    {
      PressOptions options = sticking(0.3);
      options.settings.yield_tolerance = 1e-6;
      options.settings.displacement_tolerance = 1e-7;
      options.hardening_modulus = 20e9;
      options.upper_stiffness = stiffness;
      SpherePress fast(options), watched(options);
      ASSERT_TRUE(fast.press(4.0, accelerated(options, Integration::backward_euler)).converged);
      ASSERT_TRUE(watched.press(4.0, accelerated(options, Integration::backward_euler)).converged);
      const TangentialDrive along = by_force ? force(0.2 * fast.load()) : shift(0.5 * sliding_shift);
      Strategy descent = accelerated(options, Integration::backward_euler);
      descent.anderson_depth = 0;
      descent.max_evaluations = 3000;
      descent.watch_energy = true;
      descent.stiffness_share = 1.0;
      Strategy keeping = accelerated(options, Integration::backward_euler);
      keeping.keeps_shear_limit = true;
      ASSERT_TRUE(fast.press(6.0, keeping, 0, along).converged);
      const IncrementReport report = watched.press(6.0, descent, 0, along);
      ASSERT_TRUE(report.converged) << report.yield_error << " " << report.energy_rose << " " << report.evaluations;
      EXPECT_FALSE(report.energy_rose);
      expect_near(copy(interface_of(watched).shears()[0]), copy(interface_of(fast).shears()[0]), 1e-4, "shear");
      expect_near(watched.contact().lower().state().plastic_strain, fast.contact().lower().state().plastic_strain, 1e-3,
                  "plastic strain");
      // Of the cells that slip none is missing.
      expect_near(copy(interface_of(watched).state().path), copy(interface_of(fast).state().path), 1e-3, "way slipped");
      EXPECT_NEAR(interface_of(watched).state().total_heat / interface_of(fast).state().total_heat, 1.0, 1e-3);
      EXPECT_EQ(interface_of(watched).state().sticking, interface_of(fast).state().sticking);
    }
}

TEST(PartialSlipTest, AFailedIncrementLeavesEverythingAsItWas)
{
  PressOptions options = sticking(0.3);
  options.hardening_modulus = 20e9;
  options.upper_stiffness = 2.0;
  SpherePress press(options);
  ASSERT_TRUE(press.press(5.0, accelerated(options), 0, shift(0.2 * sliding_shift)).converged);
  Archive before;
  press.contact().exchange(before);
  Strategy hasty = accelerated(options);
  hasty.max_evaluations = 2;
  EXPECT_FALSE(press.press(6.0, hasty, 0, shift(-0.4 * sliding_shift)).converged);
  int asked = 0;
  Strategy stopped = accelerated(options);
  stopped.wants_stop = [&] { return ++asked > 6; };
  EXPECT_THROW((void)press.press(6.0, stopped, 0, shift(-0.4 * sliding_shift)), Interrupted);
  // A force that friction cannot carry has no solution.
  const IncrementReport overloaded = press.press(5.0, accelerated(options), 0, force(0.31 * press.load()));
  EXPECT_FALSE(overloaded.converged);
  EXPECT_TRUE(overloaded.overloaded);
  Archive after;
  press.contact().exchange(after);
  EXPECT_EQ(before.fields(), after.fields());
  // And the way on is the same.
  SpherePress taken_up(options);
  Archive stored(before.fields());
  taken_up.contact().exchange(stored);
  ASSERT_TRUE(press.press(6.0, accelerated(options), 0, shift(-0.4 * sliding_shift)).converged);
  ASSERT_TRUE(taken_up.press(6.0, accelerated(options), 0, shift(-0.4 * sliding_shift)).converged);
  Archive one, other;
  press.contact().exchange(one);
  taken_up.contact().exchange(other);
  EXPECT_EQ(one.fields(), other.fields());
}

TEST(PartialSlipTest, ForceAndShiftAreTheSameContact)
{
  // What a shift makes of force, that force makes of shift.
  PressOptions options = sticking(0.3);
  options.hardening_modulus = 20e9;
  SpherePress shifted(options), forced(options);
  ASSERT_TRUE(shifted.press(5.0).converged);
  ASSERT_TRUE(forced.press(5.0).converged);
  for (const double x : {0.3, -0.1, 0.4})
  {
    ASSERT_TRUE(shifted.press(5.0, accelerated(options), 0, shift(x * sliding_shift)).converged);
    const auto [fx, fy] = interface_of(shifted).forces();
    ASSERT_TRUE(forced.press(5.0, accelerated(options), 0, force(fx, fy)).converged);
    EXPECT_NEAR(interface_of(forced).state().shift[0], x * sliding_shift, 1e-5 * sliding_shift);
  }
  EXPECT_NEAR(interface_of(forced).state().work / interface_of(shifted).state().work, 1.0, 1e-4);
}

} // namespace
} // namespace brinell::elastoplastic::partial_slip_test
