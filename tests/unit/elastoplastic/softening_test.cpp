// SPDX-License-Identifier: BSD-3-Clause
// A yield stress that differs from cell to cell, as of hot bodies.
#include "sphere_press.hpp"
#include "state_comparison.hpp"

#include "brinell/constitutive/softening.hpp"
#include "brinell/foundation/error.hpp"
#include "order.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <vector>

namespace brinell::elastoplastic::softening_test
{
namespace
{

using Factors = std::vector<double>;

PressOptions tight()
{
  PressOptions options;
  options.settings = tight_settings();
  options.hardening_modulus = 20e9;
  return options;
}

void soften(SpherePress& press, const Factors& factor)
{
  press.contact().set_softening(factor, factor);
}

/// Hot in a ball of one contact radius around a place beneath the surface, cold elsewhere.
Factors hot_spot(const VolumeGrid& grid, double depth, double least)
{
  Factors factor(grid.size(), 1.0);
  const double size = 2.0 * grid.surface.dx;
  for (int k = 0; k < grid.nz; ++k)
    for (int j = 0; j < grid.surface.ny; ++j)
      for (int i = 0; i < grid.surface.nx; ++i)
      {
        const double x = (i - grid.surface.nx / 2) * grid.surface.dx, y = (j - grid.surface.ny / 2) * grid.surface.dy;
        const double z = (k + 0.5) * grid.dz - depth;
        factor[grid.index(i, j, k)] -= (1.0 - least) * std::exp(-(x * x + y * y + z * z) / (size * size));
      }
  return factor;
}

TEST(SofteningTest, OneFactorIsAnotherYieldStress)
{
  const double f = 0.8;
  SpherePress soft(tight()), weak(tight());
  CoupledContact weaker(weak.contact().grid(), weak.volume(), weak.volume(),
                        {{200e9, 0.32}, constitutive::LinearHardening{f * SpherePress::yield_stress, f * 20e9}},
                        {{200e9, 0.32}, constitutive::LinearHardening{f * SpherePress::yield_stress, f * 20e9}},
                        Scales{SpherePress::alpha_c, 6.0 * SpherePress::alpha_c}, tight_settings());
  soften(soft, Factors(soft.volume().size(), f));
  for (const double interference : {2.0, 5.0, 3.0})
  {
    ASSERT_TRUE(soft.press(interference).converged);
    ASSERT_TRUE(weaker.advance(weak.rigid_gap(interference), {}, {}, {.max_evaluations = 400}).converged);
  }
  const BodyState a = soft.contact().lower().state(), b = weaker.lower().state();
  EXPECT_GT(*std::max_element(a.equivalent.begin(), a.equivalent.end()), 1e-3);
  // The same equations; what differs is rounding, and where the iteration stops.
  expect_near(a.plastic_strain, b.plastic_strain, 1e-7, "plastic strain");
  expect_near(copy(soft.contact().pressure()), copy(weaker.pressure()), 1e-7, "pressure");
  EXPECT_NEAR(a.dissipation / b.dissipation, 1.0, 1e-7);
}

TEST(SofteningTest, TheStressKeepsToTheYieldStressOfEachCell)
{
  PressOptions options;
  options.hardening_modulus = 20e9;
  SpherePress press(options);
  const Factors factor = hot_spot(press.volume(), 6e-3, 0.4);
  soften(press, factor);
  for (const double interference : {2.0, 5.0})
    ASSERT_TRUE(press.press(interference).converged);
  const CoupledContact::Stress stress = press.contact().stress(0, {});
  const BodyState state = press.contact().lower().state();
  double most = 0.0;
  for (std::size_t cell = 0; cell < factor.size(); ++cell)
  {
    const double yield = factor[cell] * (SpherePress::yield_stress + 20e9 * state.equivalent[cell]);
    most = std::max(most, von_mises(deviator_at(stress.deviator, factor.size(), cell)) / yield);
  }
  EXPECT_LE(most, 1.0 + options.settings.yield_tolerance);
  EXPECT_GT(most, 1.0 - options.settings.yield_tolerance); // it does yield
}

TEST(SofteningTest, NoYieldIsMissedWhereOnlyLayersNearYieldAreComputed)
{
  // A hot spot far beneath what yields otherwise: with and without the shortcuts the result is the same.
  const auto pressed = [](bool shortcuts)
  {
    PressOptions options = tight();
    options.settings.shortcuts = shortcuts;
    SpherePress press(options);
    EXPECT_TRUE(press.press(1.5).converged);
    soften(press, hot_spot(press.volume(), 28e-3, 0.05));
    EXPECT_TRUE(press.press(1.5).converged);
    return press.contact().lower().state();
  };
  const BodyState quick = pressed(true), thorough = pressed(false);
  expect_near(quick.plastic_strain, thorough.plastic_strain, 1e-6, "plastic strain");
  const std::size_t deep = 9 * 13 * 13 + 6 * 13 + 6;
  EXPECT_GT(thorough.equivalent[deep], 1e-5);
}

TEST(SofteningTest, AHeldContactFlowsAsItGetsHot)
{
  // No work is done from outside: what is dissipated was stored. The factor is held through a step, which is of first order at
  // least; where the stress already was on the yield surface the path rule is of second order.
  const auto loss_of_energy = [](int steps)
  {
    SpherePress press(tight());
    EXPECT_TRUE(press.press(4.0).converged);
    const double load = press.load(), dissipation = press.contact().lower().solved().state().dissipation;
    const double energy = press.stored_and_dissipated();
    for (int step = 1; step <= steps; ++step)
    {
      soften(press, Factors(press.volume().size(), 1.0 - 0.3 * step / steps));
      EXPECT_TRUE(press.press(4.0).converged);
    }
    EXPECT_LT(press.load(), 0.95 * load);
    EXPECT_GT(press.contact().lower().solved().state().dissipation, 1.1 * dissipation);
    return press.stored_and_dissipated() / energy - 1.0;
  };
  const test::Orders orders("energy of a held contact", {loss_of_energy(1), loss_of_energy(2), loss_of_energy(4)});
  EXPECT_GT(orders.overall, 1.0);
  EXPECT_LT(std::abs(loss_of_energy(4)), 2e-3);
}

TEST(SofteningTest, EmptyIsNoneAndBadFactorsAreRefused)
{
  SpherePress with(tight()), without(tight());
  soften(with, Factors(with.volume().size(), 0.5));
  soften(with, {});
  ASSERT_TRUE(with.press(3.0).converged);
  ASSERT_TRUE(without.press(3.0).converged);
  // The transforms of two presses may be planned differently: rounding, and where the iteration stops.
  expect_near(with.contact().lower().state().plastic_strain, without.contact().lower().state().plastic_strain, 1e-7,
              "plastic strain");
  EXPECT_THROW(soften(with, Factors(3, 1.0)), InternalError);
  for (const double bad :
       {0.0, -1.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
    EXPECT_THROW(soften(with, Factors(with.volume().size(), bad)), InputError) << bad;
}

TEST(SofteningTest, TheSurfaceBearsLessShearWhereItIsHot)
{
  SpherePress press;
  Factors factor = hot_spot(press.volume(), 0.0, 0.5);
  soften(press, factor);
  const std::vector<double> strength = press.contact().lower().shear_strength(1.0);
  for (std::size_t cell = 0; cell < strength.size(); ++cell)
    EXPECT_NEAR(strength[cell], factor[cell] * SpherePress::yield_stress / std::sqrt(3.0), 1e-3);
}

TEST(SofteningTest, ACheckpointHasIt)
{
  SpherePress press, taken_up;
  soften(press, hot_spot(press.volume(), 0.0, 0.5));
  Archive given;
  press.contact().exchange(given);
  Archive stored(given.fields());
  taken_up.contact().exchange(stored);
  EXPECT_EQ(taken_up.contact().lower().shear_strength(1.0), press.contact().lower().shear_strength(1.0));
  EXPECT_EQ(taken_up.contact().upper().state().softening, press.contact().upper().state().softening);
}

/// A body of its own, softened by its temperature.
Body warm_body(const VolumeGrid& grid)
{
  constitutive::Material material = SpherePress().material();
  material.softening = constitutive::LinearSoftening{20.0, 1020.0};
  material.temperature = 120.0;
  return {grid, std::make_shared<const halfspace::HalfSpace>(grid, material.elastic), material};
}

TEST(SofteningTest, AnIncrementThatFailsLeavesThatOfBefore)
{
  const VolumeGrid grid = SpherePress().volume();
  Body body = warm_body(grid);
  body.set_softening(hot_spot(grid, 0.0, 0.5));
  const std::vector<double> strength = body.shear_strength(1.0);
  body.begin(0, 0.6);
  body.set_softening(Factors(grid.size(), 0.3));
  EXPECT_NE(body.shear_strength(1.0), strength);
  body.restore();
  EXPECT_EQ(body.shear_strength(1.0), strength);
  EXPECT_EQ(body.state().softening, hot_spot(grid, 0.0, 0.5));
}

TEST(SofteningTest, LargerGridsKeepIt)
{
  const VolumeGrid small = SpherePress().volume();
  VolumeGrid large = small;
  large.surface.nx += 4;
  large.surface.ny += 2;
  Body body = warm_body(small), grown = warm_body(large);
  body.set_softening(hot_spot(small, 0.0, 0.5));
  const std::vector<double> no_pressure(large.surface.size(), 0.0);
  grown.continue_from(body.state(), small, {.pressure = no_pressure});
  const std::vector<double> before = body.shear_strength(1.0), now = grown.shear_strength(1.0);
  for (int j = 0; j < large.surface.ny; ++j)
    for (int i = 0; i < large.surface.nx; ++i)
    {
      const bool is_new = i < 2 || i >= small.surface.nx + 2 || j < 1 || j > small.surface.ny;
      // Beyond the smaller grid the bulk is as warm as ever.
      EXPECT_DOUBLE_EQ(now[large.surface.index(i, j)], is_new ? 0.9 * SpherePress::yield_stress / std::sqrt(3.0)
                                                              : before[small.surface.index(i - 2, j - 1)])
          << i << ", " << j;
    }
}

} // namespace
} // namespace brinell::elastoplastic::softening_test
