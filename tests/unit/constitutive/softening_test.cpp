// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/constitutive/softening.hpp"

#include "brinell/constitutive/flow.hpp"
#include "brinell/foundation/error.hpp"
#include "random_field.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace brinell::constitutive::softening_test
{
namespace
{

constexpr JohnsonCookSoftening steel_4340{25.0, 1520.0, 1.03}; // Johnson and Cook 1983: melting at 1793 K

TEST(Softening, JohnsonAndCook)
{
  EXPECT_EQ(softening_factor(steel_4340, -50.0), 1.0);
  EXPECT_EQ(softening_factor(steel_4340, 25.0), 1.0);
  // T* = 1/4 and 1/2.
  EXPECT_NEAR(softening_factor(steel_4340, 398.75), 1.0 - std::pow(0.25, 1.03), 1e-15);
  EXPECT_NEAR(softening_factor(steel_4340, 772.5), 1.0 - std::pow(0.5, 1.03), 1e-15);
  EXPECT_EQ(melting_temperature(steel_4340), 1520.0);
}

TEST(Softening, LinearIsJohnsonAndCookWithAnExponentOfOne)
{
  const LinearSoftening line{25.0, 1520.0};
  const JohnsonCookSoftening curve{25.0, 1520.0, 1.0};
  for (double t = -100.0; t < 2000.0; t += 37.0)
    EXPECT_EQ(softening_factor(line, t), softening_factor(curve, t)) << t;
  EXPECT_NEAR(softening_factor(line, 772.5), 0.5, 1e-15);
}

TEST(Softening, AFloorIsLeftAtMeltingAndBeyond)
{
  for (const double t : {1519.9, 1520.0, 1e4})
    EXPECT_EQ(softening_factor(steel_4340, t), least_softening_factor) << t;
  EXPECT_EQ(softening_factor(TabulatedSoftening({0.0}, {1e-9}), 0.0), least_softening_factor);
}

TEST(Softening, ATableIsLinearBetweenItsPointsAndConstantOutside)
{
  const TabulatedSoftening table({20.0, 100.0, 300.0}, {1.0, 1.2, 0.6});
  EXPECT_EQ(softening_factor(table, 20.0), 1.0);
  EXPECT_NEAR(softening_factor(table, 60.0), 1.1, 1e-15);
  EXPECT_EQ(softening_factor(table, 100.0), 1.2);
  EXPECT_NEAR(softening_factor(table, 250.0), 0.75, 1e-15);
  EXPECT_EQ(softening_factor(table, -20.0), 1.0);
  EXPECT_EQ(softening_factor(table, 1000.0), 0.6);
  EXPECT_FALSE(melting_temperature(table));
  EXPECT_TRUE(covers(table, 20.0) && covers(table, 300.0));
  EXPECT_FALSE(covers(table, 19.0) || covers(table, 301.0));
  EXPECT_TRUE(covers(steel_4340, -200.0) && covers(steel_4340, 3000.0));
}

TEST(Softening, WhatIsNoTableIsRefused)
{
  const auto table = [](std::vector<double> t, std::vector<double> f)
  { (void)TabulatedSoftening(std::move(t), std::move(f)); };
  EXPECT_THROW(table({}, {}), InputError);
  EXPECT_THROW(table({20.0}, {1.0, 0.5}), InputError);
  EXPECT_THROW(table({20.0, 20.0}, {1.0, 0.5}), InputError);
  EXPECT_THROW(table({20.0, 100.0}, {1.0, 0.0}), InputError);
  EXPECT_THROW(table({20.0, NAN}, {1.0, 0.5}), InputError);
}

// The return mapping of a softened law is that of a law with the softened yield stress.
TEST(Softening, AFactorIsAnotherYieldStress)
{
  const double mu = 76.0, f = softening_factor(steel_4340, 600.0);
  const VoceHardening cold{1.0, 0.3, 25.0}, hot{f, 0.3 * f, 25.0};
  const std::vector<KinematicTerm> terms{{20.0, 60.0}};
  for (unsigned seed = 0; seed < 40; ++seed)
    for (const Integration integration : {Integration::path, Integration::backward_euler})
      for (const bool is_kinematic : {false, true})
      {
        const double e = 0.01 * (seed % 5);
        const Deviator s0 = test::random_deviator(seed, 0.3), q = test::random_deviator(seed + 100, 0.5 + 0.1 * seed);
        std::vector<Deviator> back_a(is_kinematic ? 1 : 0, test::random_deviator(seed + 200, 0.05)), back_b = back_a;
        const std::span<const KinematicTerm> used(terms.data(), back_a.size());
        const PlasticIncrement a =
            flow(ScaledLaw<VoceHardening>{cold, f}, used, integration, s0, q, e, 2.0 * mu, back_a);
        const PlasticIncrement b = flow(hot, used, integration, s0, q, e, 2.0 * mu, back_b);
        EXPECT_NEAR(a.equivalent, b.equivalent, 1e-13) << seed;
        EXPECT_NEAR(a.dissipation, b.dissipation, 1e-13) << seed;
        EXPECT_LT(von_mises(a.strain - b.strain), 1e-13) << seed;
      }
}

// At constant strain a stress on the yield surface shrinks with it: s1 = f s0, and the work is that of a stress that falls on a
// straight line.
TEST(Softening, AStressThatIsHeldFlowsAsTheYieldStressFalls)
{
  const double mu = 76.0, f = 0.7;
  const Deviator s0 = test::random_deviator(3, 1.0);
  const double size = von_mises(s0);
  const PerfectPlasticity law{size};
  for (const Integration integration : {Integration::path, Integration::backward_euler})
  {
    const PlasticIncrement p = flow(ScaledLaw<PerfectPlasticity>{law, f}, {}, integration, s0, s0, 0.0, 2.0 * mu, {});
    EXPECT_NEAR(p.equivalent, (1.0 - f) * size / (3.0 * mu), 1e-14);
    EXPECT_LT(von_mises(s0 - (2.0 * mu) * p.strain - f * s0), 1e-13);
    const double mean = integration == Integration::path ? 0.5 * (1.0 + f) : f;
    EXPECT_NEAR(p.dissipation, mean * size * p.equivalent, 1e-14);
  }
}

} // namespace
} // namespace brinell::constitutive::softening_test
