// SPDX-License-Identifier: BSD-3-Clause
// Friction in an increment: the shear that belongs to the pressure, in both bodies and in the gap.
#include "sphere_press.hpp"
#include "state_comparison.hpp"

#include "brinell/foundation/error.hpp"
#include "volume_fields.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>
#include <vector>

namespace brinell::elastoplastic::sliding_test
{
namespace
{

PressOptions sliding(double coefficient)
{
  PressOptions options;
  options.settings = tight_settings();
  options.friction.coefficient = coefficient;
  return options;
}

PressOptions elastic_pair(double coefficient, double upper_stiffness)
{
  PressOptions options = sliding(coefficient);
  options.lower_plastic = options.upper_plastic = false;
  options.upper_stiffness = upper_stiffness;
  return options;
}

std::vector<double> shear_of(const SpherePress& press)
{
  return copy(press.contact().sliding()->shears()[0]);
}

TEST(SlidingTest, GapOfDissimilarBodiesHasTheShearInIt)
{
  // Pressure and shear of the solution, in an operator of their own: no gap under pressure, none closed elsewhere, to the
  // tolerance; pressure and shear were found by turns, each to it.
  for (const double stiffness : {0.2, 5.0, std::numeric_limits<double>::infinity()})
  {
    const PressOptions options = elastic_pair(0.5, stiffness);
    SpherePress press(options);
    ASSERT_TRUE(press.press(6.0).converged);
    const std::vector<double> pressure = copy(press.contact().pressure()), shear = shear_of(press);
    std::vector<double> gap = press.rigid_gap(6.0), u(gap.size());
    const halfspace::SurfaceCompliance compliance(press.contact().grid(), press.contact().lower().material().elastic,
                                                  press.contact().upper().material().elastic);
    compliance.apply({.pressure = pressure, .shear_x = shear}, {.z = u});
    const double tolerance = 3.0 * options.settings.contact_tolerance * 6.0 * SpherePress::alpha_c;
    for (std::size_t i = 0; i < gap.size(); ++i)
    {
      gap[i] += u[i];
      EXPECT_NEAR(shear[i], 0.5 * pressure[i], 1e-9 * SpherePress::yield_stress);
      EXPECT_GE(gap[i], -tolerance);
      EXPECT_TRUE(pressure[i] == 0.0 || std::abs(gap[i]) <= tolerance) << gap[i];
    }
    // It is not that of a contact without friction: the pressure leans to one side.
    SpherePress smooth(elastic_pair(0.0, stiffness));
    ASSERT_TRUE(smooth.press(6.0).converged);
    EXPECT_EQ(smooth.contact().sliding(), nullptr);
    EXPECT_GT(std::abs(press.load() / smooth.load() - 1.0), 1e-5);
  }
}

TEST(SlidingTest, ShearMovesNoGapOfBodiesThatAreAlikeOrWithoutCoupling)
{
  for (const double stiffness : {1.0, 5.0})
  {
    PressOptions options = elastic_pair(0.5, stiffness);
    options.friction.coupling = false;
    SpherePress press(options), smooth(elastic_pair(0.0, stiffness));
    ASSERT_TRUE(press.press(6.0).converged);
    ASSERT_TRUE(smooth.press(6.0).converged);
    // The same products, but for the last digits of transforms, which depend on where the arrays lie.
    expect_near(copy(press.contact().pressure()), copy(smooth.contact().pressure()), 1e-12, "pressure");
  }
}

TEST(SlidingTest, ConvergedStateIsAdmissible)
{
  // The stress anew, from the committed strain, the pressure and the shear: admissible everywhere, to the tolerance. The shear
  // on the upper body is that on the lower one the other way.
  PressOptions options;
  options.hardening_modulus = 10e9;
  options.upper_stiffness = 2.0;
  options.friction.coefficient = 0.3;
  SpherePress press(options);
  for (const double interference : {2.0, 4.0, 6.0, 3.0})
  {
    ASSERT_TRUE(press.press(interference).converged);
    const std::vector<double> pressure = copy(press.contact().pressure());
    std::vector<double> shear = shear_of(press);
    for (const BodyView& body : {press.contact().lower(), press.contact().upper()})
    {
      const BodyState state = body.state();
      const halfspace::HalfSpace half_space(body.grid(), body.material().elastic);
      const auto stress =
          test::StressField::of(half_space, {.pressure = pressure, .shear_x = shear}, state.plastic_strain);
      for (std::size_t cell = 0; cell < body.grid().size(); ++cell)
      {
        const double yield = SpherePress::yield_stress + options.hardening_modulus * state.equivalent[cell];
        ASSERT_LE(von_mises(test::deviator_at(stress.deviator, cell)),
                  yield * (1.0 + options.settings.yield_tolerance));
      }
      for (double& q : shear)
        q = -q;
    }
  }
  EXPECT_GT(largest(press.contact().lower().state().equivalent), 1e-3);
}

TEST(SlidingTest, GuardedAndAcceleratedIterationMeet)
{
  // The guarded one holds the shear, descends to the minimum of the convex problem, and takes the shear that belongs to the
  // pressure then, until it no longer changes. Both keep the shear limit of before the increment. Tolerances as in DescentTest.
  PressOptions options = sliding(0.25);
  options.hardening_modulus = 20e9;
  options.upper_stiffness = 3.0;
  SpherePress accelerated(options), guarded(options);
  Strategy descent;
  descent.integration = Integration::backward_euler;
  descent.max_evaluations = 20000;
  descent.anderson_depth = 0;
  descent.stiffness_share = 1.0;
  descent.watch_energy = true;
  Strategy fast;
  fast.integration = Integration::backward_euler;
  fast.max_evaluations = options.settings.max_evaluations;
  fast.keeps_shear_limit = true;
  ASSERT_TRUE(accelerated.press(3.0, fast).converged);
  const IncrementReport report = guarded.press(3.0, descent);
  ASSERT_FALSE(report.energy_rose);
  ASSERT_TRUE(report.converged);
  EXPECT_GT(largest(guarded.contact().lower().state().equivalent), 1e-4);
  expect_same_state(guarded.contact().lower().state(), accelerated.contact().lower().state(), 1e-6);
  expect_same_state(guarded.contact().upper().state(), accelerated.contact().upper().state(), 1e-6);
  expect_near(copy(guarded.contact().pressure()), copy(accelerated.contact().pressure()), 1e-6, "pressure");
}

TEST(SlidingTest, SolutionDoesNotKnowHowFarTrialsGo)
{
  // The plain iteration never goes further than its residual leads: the same state.
  PressOptions options = sliding(0.4);
  options.hardening_modulus = 20e9;
  Strategy slow;
  slow.max_evaluations = 20000;
  slow.anderson_depth = 0;
  SpherePress plain(options);
  options.settings.yield_tolerance = 1e-5; // to smaller ones trials never go further
  options.settings.displacement_tolerance = 1e-6;
  SpherePress accelerated(options);
  ASSERT_TRUE(plain.press(3.0, slow).converged);
  ASSERT_TRUE(accelerated.press(3.0).converged);
  const BodyState& state = plain.contact().lower().state();
  EXPECT_GT(largest(state.equivalent), 1e-4);
  // 1e-5 of the yield stress, over a tenth of the stiffness of a cell, is some 1e-4 of this strain.
  expect_same_state(state, accelerated.contact().lower().state(), 1e-4);
}

TEST(SlidingTest, FailedIncrementLeavesNothingBehind)
{
  PressOptions options;
  options.friction.coefficient = 0.3;
  options.upper_stiffness = 2.0;
  SpherePress press(options);
  ASSERT_TRUE(press.press(4.0).converged);
  const std::vector<double> shear = shear_of(press);
  const double work = press.contact().sliding()->work();
  const BodyState state = press.contact().lower().state();
  Strategy hasty;
  hasty.max_evaluations = 2;
  ASSERT_FALSE(press.press(6.0, hasty, 1).converged);
  EXPECT_EQ(shear_of(press), shear);
  EXPECT_EQ(press.contact().sliding()->work(), work);
  EXPECT_EQ(press.contact().lower().state().residual_displacement_x, state.residual_displacement_x);
  ASSERT_TRUE(press.press(4.0, Strategy{}, 0, {}, false).converged);
  EXPECT_EQ(press.contact().sliding()->forces()[0], 0.0);
}

/// Expects friction times pressure, or the shear strength of the softer surface where it is smaller.
void expect_shear_at_limit(const SpherePress& press, const PressOptions& options)
{
  const std::vector<double> shear = shear_of(press), pressure = copy(press.contact().pressure());
  const std::vector<double> lower = press.contact().lower().shear_strength(1.0);
  const std::vector<double> upper = press.contact().upper().shear_strength(-1.0);
  EXPECT_GT(press.contact().sliding()->limited_share(), 0.3);
  for (std::size_t i = 0; i < shear.size(); ++i)
    EXPECT_NEAR(shear[i], std::min({options.friction.coefficient * pressure[i], lower[i], upper[i]}), 1e-6); // Pa
}

TEST(SlidingTest, SurfaceCarriesNoMoreThanItsLimit)
{
  // As given; or, if that is less, the shear yield stress of the softer surface, with the hardening of the same increment. Where
  // the shear is at this limit, it is the strength that the softer of both surfaces has at the end.
  PressOptions options;
  options.friction.coefficient = 0.5;
  options.friction.shear_limit = 0.2e9;
  SpherePress given(options);
  ASSERT_TRUE(given.press(3.0).converged);
  const auto highest = [](const SpherePress& press) { return largest(shear_of(press)); };
  EXPECT_EQ(highest(given), 0.2e9);
  EXPECT_GT(given.contact().sliding()->limited_share(), 0.3);

  options.friction.shear_limit.reset();
  options.hardening_modulus = 20e9;
  SpherePress own(options);
  ASSERT_TRUE(own.press(4.0).converged);
  options.friction.shear_limit = 10.0 * SpherePress::yield_stress;
  SpherePress far(options);
  ASSERT_TRUE(far.press(4.0).converged);
  EXPECT_EQ(highest(far), highest(own)) << "a limit beyond the strength is none";
  options.friction.shear_limit.reset();
  EXPECT_GT(highest(own), 1.0001 * SpherePress::yield_stress / std::sqrt(3.0)); // it has hardened
  expect_shear_at_limit(own, options);

  // A back stress along the shear counts as hardening does.
  options.hardening_modulus = 0.0;
  options.kinematic = {{20e9, 5.0}};
  SpherePress kinematic(options);
  ASSERT_TRUE(kinematic.press(4.0).converged);
  EXPECT_GT(highest(kinematic), 1.0001 * SpherePress::yield_stress / std::sqrt(3.0));
  expect_shear_at_limit(kinematic, options);
}

TEST(SlidingTest, TheLimitMayBeThatOfBeforeTheIncrement)
{
  PressOptions options = sliding(0.5);
  options.hardening_modulus = 20e9;
  SpherePress press(options);
  Strategy strategy;
  strategy.max_evaluations = 240;
  strategy.keeps_shear_limit = true;
  ASSERT_TRUE(press.press(4.0, strategy).converged);
  EXPECT_NEAR(largest(shear_of(press)), SpherePress::yield_stress / std::sqrt(3.0), 1.0); // Pa
}

TEST(SlidingTest, WorkOfTheShearIsStoredOrDissipated)
{
  // Elastic bodies of two materials begin to slide: what the energy grows by is the work of the pressure on the displacement of
  // the surfaces along z, here from an operator of its own, and that of the shear; exactly, as both are linear. Without change
  // after that nothing more is taken up.
  SpherePress press(elastic_pair(0.4, 3.0));
  ASSERT_TRUE(press.press(5.0, Strategy{}, 0, {}, false).converged);
  const halfspace::SurfaceCompliance compliance(press.contact().grid(), press.contact().lower().material().elastic,
                                                press.contact().upper().material().elastic);
  const auto depth = [&]
  {
    std::vector<double> u(press.contact().grid().size());
    compliance.apply({.pressure = press.contact().pressure(), .shear_x = press.contact().sliding()->shears()[0]},
                     {.z = u});
    return u;
  };
  const double energy = press.contact().elastic_energy();
  const std::vector<double> u = depth(), p = copy(press.contact().pressure());
  EXPECT_EQ(press.contact().sliding()->work(), 0.0);
  ASSERT_TRUE(press.press(5.0).converged);
  const std::vector<double> u_now = depth();
  double of_pressure = 0.0;
  for (std::size_t i = 0; i < u.size(); ++i)
    of_pressure +=
        0.5 * (p[i] + press.contact().pressure()[i]) * (u_now[i] - u[i]) * press.contact().grid().cell_area();
  const double taken = press.contact().sliding()->work();
  EXPECT_GT(taken, 1e-3 * energy);
  EXPECT_NEAR(press.contact().elastic_energy() - energy - of_pressure, taken, 1e-9 * energy);
  ASSERT_TRUE(press.press(5.0).converged);
  EXPECT_NEAR(press.contact().sliding()->work(), taken, 1e-9 * energy);
}

TEST(SlidingTest, BodiesUnderShearAreNotAlike)
{
  const PressOptions options = sliding(0.2);
  const SpherePress press(options);
  const VolumeGrid v = press.volume();
  const constitutive::Material m = press.material();
  EXPECT_THROW(
      CoupledContact(v.surface, v, v, m, m, Scales{1.0, 1.0}, Settings{}, Twin::alike, {}, 0.0, {options.friction, 1}),
      InternalError);
}

} // namespace
} // namespace brinell::elastoplastic::sliding_test
