// SPDX-License-Identifier: BSD-3-Clause
#include "creeping_cylinder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

/// Wear of surfaces that roll with creepage: stick in places and slip in others.
namespace brinell::verification::creepage_wear_test
{
namespace
{

using simulation::BodySnapshot;
using simulation::RollingCase;

/// A cylinder that rolls with so much creepage that 0.4 of its contact slips, and wears both surfaces.
RollingCase worn_cylinder(double cells, double lower, double upper)
{
  constexpr double friction = 0.3, share = 0.4;
  RollingCase c = Cylinder::rolling(cells, friction, share * friction * Cylinder::a / Cylinder::R);
  c.wear = {.lower = lower, .upper = upper};
  return c;
}

// In steady rolling each point of the track loses k times the pressure on its slip, which is the work of the creep force over friction:
// k xi F/f per width, with Carter's (1926) force F. The force is of first order, and so is the depth.
TEST(CreepageWear, IsTheWorkOfCartersForce)
{
  const RollingCase first = worn_cylinder(8.0, 0.0, 0.0);
  const double friction = first.friction.coefficient, creepage = first.creepage->longitudinal;
  const double share = creepage * Cylinder::R / (friction * Cylinder::a);
  const double force = friction * Cylinder::load_per_length() * (1.0 - std::pow(1.0 - share, 2));
  const double per_coefficient = creepage * force / friction;
  const double depth = 1e-7 * Cylinder::a; // too little to change the contact
  for (const double cells : {8.0, 16.0, 32.0})
  {
    RollingCase c = worn_cylinder(cells, depth / per_coefficient, 0.5 * depth / per_coefficient);
    const RollingRun run = computed(c);
    const auto at = [&](const BodySnapshot& body)
    {
      const SurfaceGrid& g = body.grid.surface;
      return body.effect(
          "worn_depth")[static_cast<std::size_t>(std::lround(0.5 * (g.nx - 1) + 6.0 * Cylinder::a / g.dx))];
    };
    const simulation::Snapshot& end = run.summary.final_state;
    std::printf("worn depth of the track, %g cells: %.5f of that of Carter's force, upper surface %.5f\n", cells,
                at(end.lower) / depth, 2.0 * at(end.upper) / depth);
    EXPECT_NEAR(at(end.lower) / depth, 1.0, 0.5 / cells);
    EXPECT_NEAR(at(end.upper) / at(end.lower), 0.5, 1e-9);
  }
}

// The volume is the coefficient times the heat of friction, also while the force grows, and where points part; by Archard's law divided
// by friction. The trapezoidal rule of both is the same.
TEST(CreepageWear, GoesWithTheHeat)
{
  RollingCase c = worn_cylinder(slow_build ? 6.0 : 12.0, 1e-16, 0.0);
  c.distance = 8.0 * Cylinder::a;
  c.passes = 2;
  for (const auto kind : {elastoplastic::WearLaw::Kind::archard, elastoplastic::WearLaw::Kind::energy})
  {
    c.wear.kind = kind;
    const auto summary = computed(c).summary;
    const double per_heat = kind == elastoplastic::WearLaw::Kind::archard ? 1.0 / c.friction.coefficient : 1.0;
    EXPECT_NEAR(summary.worn_volume_lower / (c.wear.lower * per_heat * summary.dissipation_friction), 1.0, 1e-4);
  }
}

// A ball that rolls with creepages and spin, so that a rut is worn: what the drive does is heat and the work of wear. Wear some thirty
// times as much as an explicit scheme bears, which takes all of the ball off that touches, is solved in the same steps.
TEST(CreepageWear, BalancesAndIsStable)
{
  const constitutive::Material material{{210e9, 0.3}, {}};
  RollingCase c;
  c.lower = {simulation::Plane{}, material};
  c.upper = {ball(10e-3), material};
  c.drive = load(50.0);
  c.friction.coefficient = 0.3;
  c.creepage = {0.004, 0.001, 2.0};
  c.distance = 0.8e-3;
  c.passes = 2;
  c.resolution = slow_build ? 5.0 : 8.0;
  const double modulus = contact_modulus(material.elastic, material.elastic);
  const double explicit_limit = 0.9 / modulus / c.creepage->longitudinal; // k s = 0.9 dx/E', s = xi dx
  for (const double times : {0.02, 30.0})
  {
    c.wear = {.lower = 0.5 * times * explicit_limit, .upper = 0.5 * times * explicit_limit};
    const RollingRun run = computed(c);
    std::printf("wear of a step, %g times the limit of explicit schemes: energy %.2e, depth %.3g of the approach\n",
                times, run.summary.energy_balance_error,
                run.summary.max_worn_depth_lower / simulation::plan(c).scales.gap);
    EXPECT_NEAR(run.summary.energy_balance_error, 0.0, 5e-3);
    EXPECT_EQ(run.summary.split_increments, 0);
    EXPECT_NEAR(run.summary.worn_volume_upper / run.summary.worn_volume_lower, 1.0, 1e-9);
  }
}

} // namespace
} // namespace brinell::verification::creepage_wear_test
