// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/foundation/error.hpp"
#include "brinell/reference/critical.hpp"
#include "brinell/reference/hertz.hpp"
#include "brinell/reference/sliding_contact.hpp"

#include "gauss.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace brinell::reference::critical_test
{
namespace
{

constexpr double epsilon = std::numeric_limits<double>::epsilon();

// Steel spheres of Boucly, Nelias & Green (2006): R1 = R2 = 1 m, E = 200 GPa, nu = 0.32, S_y = 0.9115 GPa.
constexpr double contact_modulus_of_pair = 0.5 * 200e9 / (1.0 - 0.32 * 0.32);

TEST(CriticalTest, ThePapersCase)
{
  // Seven digits are given.
  const double C = critical_pressure_ratio(0.32);
  EXPECT_NEAR(C, 1.637468, 5e-7);
  EXPECT_NEAR(contact_modulus_of_pair / 1.114082e11, 1.0, 5e-7);
  const CriticalValues c = critical_values(0.5, contact_modulus_of_pair, C, 0.9115e9);
  EXPECT_NEAR(c.interference / 2.214290e-4, 1.0, 5e-7);
  EXPECT_NEAR(c.load / 3.460928e5, 1.0, 5e-7);
  EXPECT_NEAR(c.energy / 30.65398, 1.0, 5e-7);
  EXPECT_NEAR(c.contact_radius / 1.052209e-2, 1.0, 5e-7);
  EXPECT_DOUBLE_EQ(c.contact_area, std::numbers::pi * c.contact_radius * c.contact_radius);
  EXPECT_DOUBLE_EQ(c.peak_pressure, C * 0.9115e9);
  EXPECT_NEAR(c.load, 3.461e5, 50.0) << "as printed in the paper";
}

TEST(CriticalTest, HertzAtTheCriticalApproachGivesTheOtherValues)
{
  const CriticalValues c = critical_values(0.5, contact_modulus_of_pair, 1.6, 1e9);
  const PointContact hertz = point_contact_at_approach(0.5, contact_modulus_of_pair, c.interference);
  EXPECT_NEAR(hertz.load / c.load, 1.0, 8.0 * epsilon);
  EXPECT_NEAR(hertz.contact_radius / c.contact_radius, 1.0, 8.0 * epsilon);
  EXPECT_NEAR(hertz.peak_pressure / c.peak_pressure, 1.0, 8.0 * epsilon);
  const double energy = 8.0 / 15.0 * contact_modulus_of_pair * std::sqrt(0.5) * std::pow(c.interference, 2.5);
  EXPECT_NEAR(c.energy / energy, 1.0, 8.0 * epsilon);
}

TEST(CriticalTest, GreensFitIsNearTheExactFirstYield)
{
  for (int i = 0; i <= 50; ++i)
  {
    const double nu = 0.01 * i;
    EXPECT_NEAR(critical_pressure_ratio(nu) / first_yield(nu).pressure_ratio, 1.0, 1.5e-3) << nu << ": stated accuracy";
  }
}

TEST(CriticalTest, BelowZeroTheEdgeMayYieldFirst)
{
  // Independent: the stress under pressure and hardly any shear, searched for the largest von Mises stress.
  for (const double nu : {-0.9, -0.7, -0.5, -0.35, -0.3, -0.2, -0.1, -0.01})
    EXPECT_NEAR(critical_pressure_ratio(nu) / sliding_first_yield(nu, 1e-9).pressure_ratio, 1.0, 1e-4) << nu;
  EXPECT_NEAR(critical_pressure_ratio(-0.5), 0.5 * std::numbers::sqrt3, 1e-12);
  EXPECT_NEAR(critical_pressure_ratio(-1e-9) / critical_pressure_ratio(0.0), 1.0, 1.5e-3);
}

/// A line contact that yields, by Green's (2005) closed forms: the approach that he takes has l = 2 R/e.
TEST(CriticalLineTest, GreensClosedForms)
{
  const double R = 0.5, E = contact_modulus_of_pair, p = 1.8 * 0.9115e9;
  const CriticalValues c = critical_values(R, E, 1.8, 0.9115e9, {3.0, 2.0 * R / std::numbers::e});
  const double share = p / E, logarithm = std::log(2.0 * E / p);
  EXPECT_NEAR(c.interference / (R * share * share * (2.0 * logarithm - 1.0)), 1.0, 8.0 * epsilon);
  EXPECT_NEAR(c.load / (3.0 * std::numbers::pi * R * p * share), 1.0, 8.0 * epsilon);
  const double energy = std::numbers::pi * R * R * p * share * share * share / 4.0 * (4.0 * logarithm - 3.0);
  EXPECT_NEAR(c.energy / (3.0 * energy), 1.0, 8.0 * epsilon);
  EXPECT_NEAR(c.contact_radius / (2.0 * R * share), 1.0, 8.0 * epsilon);
  EXPECT_NEAR(c.contact_area / (3.0 * 4.0 * R * share), 1.0, 8.0 * epsilon);
  EXPECT_DOUBLE_EQ(c.peak_pressure, p);
}

TEST(CriticalLineTest, EnergyIsTheWorkOfTheLoadForAnyReference)
{
  // By parts, P alpha less the integral of alpha over P, which is smooth in the cube root of the load.
  for (const double reference : {0.02, 0.5, 40.0})
  {
    const CriticalValues c = critical_values(0.5, contact_modulus_of_pair, 1.8, 0.9115e9, {1.0, reference});
    const test::Gauss rule(40, 0.0, 1.0);
    double rest = 0.0;
    for (std::size_t i = 0; i < rule.point.size(); ++i)
    {
      const double t = rule.point[i];
      const LineContact contact = line_contact_at_load(0.5, contact_modulus_of_pair, c.load * t * t * t);
      rest += rule.weight[i] * line_contact_approach(contact, contact_modulus_of_pair, reference) * 3.0 * t * t;
    }
    EXPECT_NEAR((c.load * c.interference - c.load * rest) / c.energy, 1.0, 1e-10) << reference;
  }
}

TEST(CriticalLineTest, RefusesNonsense)
{
  const auto of = [](double length, double reference) {
    return critical_values(0.5, contact_modulus_of_pair, 1.8, 0.9115e9, {length, reference});
  };
  const double half_width = of(1.0, 1.0).contact_radius;
  EXPECT_THROW((void)of(0.0, 1.0), InputError);
  EXPECT_THROW((void)of(1.0, 0.0), InputError);
  EXPECT_THROW((void)of(1.0, 0.499 * half_width), InputError);
  EXPECT_GT(of(1.0, 0.501 * half_width).interference, 0.0);
}

TEST(CriticalTest, RefusesNonsense)
{
  EXPECT_THROW((void)critical_values(0.0, 1e11, 1.6, 1e9), InputError);
  EXPECT_THROW((void)critical_values(0.5, -1e11, 1.6, 1e9), InputError);
  EXPECT_THROW((void)critical_values(0.5, 1e11, 1.6, std::nan("")), InputError);
}

} // namespace
} // namespace brinell::reference::critical_test
