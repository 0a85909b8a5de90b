// SPDX-License-Identifier: BSD-3-Clause
// Inclusions under a contact, with plastic flow around and in them.
#include "brinell/foundation/archive.hpp"
#include "brinell/foundation/error.hpp"
#include "order.hpp"
#include "sphere_press.hpp"
#include "state_comparison.hpp"
#include "volume_fields.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>
#include <vector>

namespace brinell::elastoplastic::embedded_test
{
namespace
{

/// A block of 5 x 5 x 3 cells beside the axis, whose upper face lies two layers below the surface: it reaches into the plastic zone.
std::vector<std::size_t> block(const VolumeGrid& grid)
{
  std::vector<std::size_t> cells;
  for (int k = 2; k < 5; ++k)
    for (int j = 4; j < 9; ++j)
      for (int i = 5; i < 10; ++i)
        cells.push_back(grid.index(i, j, k));
  return cells;
}

PressOptions with_block(double ratio, double poisson_ratio = 0.25)
{
  PressOptions options;
  options.hardening_modulus = 20e9;
  options.inclusions = {{{ratio * 200e9, poisson_ratio}, block(SpherePress().volume())}};
  return options;
}

TEST(EmbeddedTest, InclusionOfTheBodysOwnConstantsIsNone)
{
  PressOptions options = with_block(1.0, 0.32), without;
  without.hardening_modulus = options.hardening_modulus;
  options.settings = without.settings = tight_settings();
  SpherePress own(options), plain(without);
  for (const double interference : {3.0, 6.0, 2.0})
  {
    ASSERT_TRUE(own.press(interference).converged);
    ASSERT_TRUE(plain.press(interference).converged);
    EXPECT_NEAR(own.load(), plain.load(), 1e-7 * plain.load());
    expect_near(copy(own.contact().lower().state().plastic_strain),
                copy(plain.contact().lower().state().plastic_strain), 1e-7, "plastic strain");
  }
}

// Weaker or stronger cells of the body's own constants are cells with a factor on the yield stress in a body without inclusions.
TEST(EmbeddedTest, StrengthOfAnInclusionIsThatOfItsCells)
{
  for (const double strength : {0.5, 100.0})
  {
    PressOptions options = with_block(1.0, 0.32), without;
    without.hardening_modulus = options.hardening_modulus;
    options.settings = without.settings = tight_settings();
    options.strength = strength;
    SpherePress own(options), plain(without);
    std::vector<double> factor(own.volume().size(), 1.0);
    for (const std::size_t cell : options.inclusions.front().cells)
      factor[cell] = strength;
    plain.contact().set_softening(factor, {});
    for (const double interference : {3.0, 6.0, 2.0})
    {
      ASSERT_TRUE(own.press(interference).converged);
      ASSERT_TRUE(plain.press(interference).converged);
    }
    EXPECT_NEAR(own.load(), plain.load(), 1e-7 * plain.load());
    expect_near(copy(own.contact().lower().state().plastic_strain),
                copy(plain.contact().lower().state().plastic_strain), 1e-7, "plastic strain");
    EXPECT_THROW(own.contact().set_softening(factor, {}), InputError);
  }
}

// All equations anew, from the committed strain and the pressure, by inclusions that start from nothing: the stress is admissible in every cell, and the
// surfaces with the displacement of plastic and equivalent strain bear the pressure.
TEST(EmbeddedTest, ConvergedStateIsAdmissibleAndBalanced)
{
  for (const double ratio : {0.0, 0.3, 4.0})
  {
    const PressOptions options = with_block(ratio);
    SpherePress press(options);
    for (const double interference : {0.5, 3.0, 6.0, 4.0}) // elastic, plastic, and unloading
    {
      const IncrementReport report = press.press(interference);
      ASSERT_TRUE(report.converged) << ratio << ' ' << interference;
      std::printf("modulus %.1f, interference %.1f: %d evaluations\n", ratio, interference, report.evaluations);
      const std::vector<double> pressure = copy(press.contact().pressure());
      const BodyView lower = press.contact().lower();
      const BodyState state = lower.state();
      const halfspace::HalfSpace body(lower.grid(), lower.material().elastic);
      test::StressField stress(body, pressure, state.plastic_strain);
      halfspace::Inclusions inclusions(body, options.inclusions);
      halfspace::InclusionField given = inclusions.make_field(), equivalent = given;
      inclusions.gather(stress.deviator, stress.trace, given);
      (void)inclusions.solve(given, equivalent, 1e-7, 400);
      std::vector<double> u(pressure.size());
      halfspace::HalfSpace::Work work = body.make_work();
      body.load(state.plastic_strain, 0, work).displacement({.z = u});
      inclusions.add(equivalent, lower.grid().nz, {stress.deviator, stress.trace, {u, {}, {}}});
      double beyond = 0.0;
      for (std::size_t cell = 0; cell < lower.grid().size(); ++cell)
      {
        const double yield = SpherePress::yield_stress + options.hardening_modulus * state.equivalent[cell];
        beyond = std::max(beyond, von_mises(test::deviator_at(stress.deviator, cell)) / yield - 1.0);
      }
      EXPECT_LE(beyond, 3.0 * options.settings.yield_tolerance) << ratio << ' ' << interference;
      // To the tolerance of the displacement, of the approach at first yield.
      const double tolerance = 2.0 * options.settings.displacement_tolerance * 6.0 * SpherePress::alpha_c;
      for (std::size_t i = 0; i < u.size(); ++i)
        EXPECT_NEAR(u[i], state.residual_displacement[i], tolerance);
    }
  }
}

// A soft inclusion lets the surface give way, a stiff one holds it.
TEST(EmbeddedTest, LoadFollowsTheModulus)
{
  std::vector<double> load;
  for (const double ratio : {0.0, 0.3, 1.0, 4.0})
  {
    SpherePress press(with_block(ratio));
    ASSERT_TRUE(press.press(0.7).converged);
    load.push_back(press.load());
  }
  EXPECT_TRUE(std::is_sorted(load.begin(), load.end()));
  EXPECT_LT(load.front(), 0.99 * load[2]);
  EXPECT_GT(load.back(), 1.001 * load[2]);
}

// With its own strain an inclusion has a stress before the load, with which the surface is flat: after an elastic load it is that of a body at rest.
TEST(EmbeddedTest, OwnStrainIsAnInitialStress)
{
  PressOptions options = with_block(2.0);
  Deviator stretched;
  stretched[Deviator::xx] = 1e-3;
  options.inclusions.front().own = {stretched, 1e-3};
  SpherePress press(options);
  ASSERT_TRUE(press.press(0.2).converged);
  ASSERT_TRUE(press.press(0.0).converged);
  const BodyState state = press.contact().lower().state();
  EXPECT_EQ(state.dissipation, 0.0);
  const halfspace::HalfSpace body(press.volume(), press.material().elastic);
  halfspace::Inclusions inclusions(body, options.inclusions);
  halfspace::InclusionField given = inclusions.make_field(), strain = given;
  inclusions.stress(inclusions.own_strain(), given);
  (void)inclusions.solve(given, strain, 1e-9);
  for (std::size_t i = 0; i < strain.deviator.size(); ++i)
    strain.deviator[i] += inclusions.own_strain().deviator[i];
  for (std::size_t i = 0; i < strain.volumetric.size(); ++i)
    strain.volumetric[i] += inclusions.own_strain().volumetric[i];
  std::vector<double> deviator(state.stress.size()), trace(press.volume().size());
  inclusions.add(strain, press.volume().nz, {deviator, trace, {}});
  expect_near(copy(state.stress), deviator, 1e-5 * SpherePress::yield_stress, "deviator");
  EXPECT_GT(*std::ranges::max_element(deviator), 0.05 * SpherePress::yield_stress);
  for (const double u : state.residual_displacement)
    EXPECT_NEAR(u, 0.0, 1e-4 * SpherePress::alpha_c);
  const CoupledContact::Stress fields = press.contact().stress(0, {});
  expect_near(fields.trace, trace, 1e-5 * SpherePress::yield_stress, "trace");
}

// Work of the force on the approach is the energy in the bodies, elastic in and around the inclusion, locked in, and dissipated: the trapezoidal
// rule errs at second order in the steps.
TEST(EmbeddedTest, EnergyIsBalanced)
{
  for (const auto& [ratio, own] : {std::pair{0.3, 0.0}, std::pair{4.0, 0.0}, std::pair{2.0, 1e-3}})
  {
    PressOptions options = with_block(ratio);
    options.inclusions.front().own.dilatation = own;
    std::vector<double> errors;
    for (const int steps : {8, 16, 32})
    {
      SpherePress press(options);
      double work = 0.0, load = 0.0;
      const auto advance = [&](double from, double to)
      {
        for (int i = 1; i <= steps; ++i)
        {
          ASSERT_TRUE(press.press(from + (to - from) * i / steps).converged);
          work += 0.5 * (load + press.load()) * (to - from) / steps * SpherePress::alpha_c;
          load = press.load();
        }
      };
      advance(0.0, 6.0);
      errors.push_back(std::abs(press.stored_and_dissipated() - work) / work);
    }
    EXPECT_GT(test::Orders("energy balance with an inclusion", errors).overall, 1.5);
    EXPECT_LT(errors.back(), 2e-3);
  }
}

// To the tolerance of the displacement, 1e-9 of the approach: the evaluations are accelerated, which magnifies rounding up to it.
TEST(EmbeddedTest, OneSideOfAMirroredContactGivesBoth)
{
  PressOptions options = with_block(0.3);
  options.settings = tight_settings();
  SpherePress whole(options);
  options.is_mirrored = true;
  SpherePress half(options);
  double largest = 0.0;
  for (const double interference : {3.0, 5.0, 0.0})
  {
    ASSERT_TRUE(whole.press(interference).converged);
    ASSERT_TRUE(half.press(interference).converged);
    largest = std::max(largest, whole.load());
    EXPECT_NEAR(half.load(), whole.load(), 1e-7 * largest);
    expect_near(copy(half.contact().lower().state().plastic_strain),
                copy(whole.contact().lower().state().plastic_strain), 1e-8, "plastic strain");
    expect_near(copy(half.contact().lower().state().residual_displacement),
                copy(whole.contact().lower().state().residual_displacement), 1e-8, "residual displacement");
  }
}

// An increment that fails leaves everything as it was, and a stored contact goes on as the one that was not stored, digit by digit: the
// equivalent strain is where the next increment starts from.
TEST(EmbeddedTest, AFailedIncrementLeavesEverythingAsItWas)
{
  const PressOptions options = with_block(4.0);
  SpherePress press(options), taken_up(options);
  ASSERT_TRUE(press.press(3.0).converged);
  Archive before, after, one, other;
  press.contact().exchange(before);
  Strategy hasty;
  hasty.max_evaluations = 3;
  EXPECT_FALSE(press.press(5.0, hasty).converged);
  press.contact().exchange(after);
  EXPECT_EQ(before.fields(), after.fields());
  Archive stored(before.fields());
  taken_up.contact().exchange(stored);
  ASSERT_TRUE(press.press(5.0).converged);
  ASSERT_TRUE(taken_up.press(5.0).converged);
  press.contact().exchange(one);
  taken_up.contact().exchange(other);
  EXPECT_EQ(one.fields(), other.fields());
}

// The fields of the whole body have the stress that the increment found, and the state of a cell is that of the fields.
TEST(EmbeddedTest, FieldsAreThoseOfTheIncrement)
{
  SpherePress press(with_block(4.0));
  ASSERT_TRUE(press.press(4.0).converged);
  const CoupledContact::Stress stress = press.contact().stress(0, {});
  const BodyState state = press.contact().lower().state();
  expect_near(stress.deviator, state.stress, 1e-3 * SpherePress::yield_stress, "deviator");
  const std::vector<std::size_t> cells{block(press.volume()).front(), press.volume().index(3, 2, 1)};
  const auto found = press.contact().cells(0, {}, cells);
  for (std::size_t i = 0; i < cells.size(); ++i)
    EXPECT_NEAR(found[i].stress.trace, stress.trace[cells[i]], 1e-9 * SpherePress::yield_stress);
}

// Sliding with friction, the contact beside and over the inclusion in a longer body.
TEST(EmbeddedTest, InclusionIsPassedUnderFriction)
{
  for (const double ratio : {0.3, 2.0})
  {
    PressOptions options = with_block(ratio);
    options.spare_columns = 6;
    options.inclusions.front().cells.clear();
    options.friction.coefficient = 0.1;
    SpherePress shape(options);
    for (int k = 2; k < 4; ++k)
      for (int j = 4; j < 9; ++j)
        for (int i = 8; i < 12; ++i)
          options.inclusions.front().cells.push_back(shape.volume().index(i, j, k));
    SpherePress press(options);
    for (int offset = 0; offset <= 6; offset += 2)
      ASSERT_TRUE(press.press(3.0, Integration::path, offset).converged) << ratio << ' ' << offset;
  }
}

TEST(EmbeddedTest, RefusesBodiesThatCannotYield)
{
  PressOptions options = with_block(2.0);
  options.lower_plastic = false;
  EXPECT_THROW(SpherePress{options}, InputError);
}

} // namespace
} // namespace brinell::elastoplastic::embedded_test
