// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/constitutive/material.hpp"
#include "brinell/foundation/error.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace brinell::constitutive::hardening_test
{
namespace
{

constexpr double yield = 0.9;

/// Infinitely steep at its start, and without an integral.
struct OwnLaw
{
  [[nodiscard]] static double yield_stress_at(double e) { return yield + std::sqrt(e); }
  [[nodiscard]] static double modulus_at(double e) { return 0.5 / std::sqrt(e); }
};

/// Plain numbers, of order one.
std::vector<HardeningLaw> every_law()
{
  return {PerfectPlasticity{yield},         LinearHardening{yield, 3.0},
          SwiftHardening{2.0, 0.003, 0.15}, swift_of_microstrain(0.4, 20.0, 0.08),
          hollomon(yield, 1.8, 0.2),        LudwikHardening{yield, 1.1, 0.4},
          VoceHardening{yield, 0.5, 12.0},  TabulatedHardening({0.0, 0.004, 0.05, 0.3}, {yield, 1.1, 1.3, 1.3}),
          UserHardening(OwnLaw{})};
}

TEST(HardeningTest, ModulusIsTheSlopeOfTheYieldStressAndWorkItsIntegral)
{
  for (const HardeningLaw& any : every_law())
    std::visit(
        [&](const auto& law)
        {
          for (const double e : {1e-3, 0.02, 0.25, 0.6}) // between the points of the table
          {
            const double h = 1e-6;
            const double slope = (law.yield_stress_at(e + h) - law.yield_stress_at(e - h)) / (2.0 * h);
            EXPECT_NEAR(law.modulus_at(e), slope, 1e-4 * (1.0 + slope)) << any.index() << " at " << e;
            // Gauss's rule of two points on 2000 intervals that grow from the start, where a power law is steep.
            double integral = 0.0;
            double from = 0.0;
            for (int i = 1; i <= 2000; ++i)
            {
              const double to = e * std::pow(i / 2000.0, 3);
              const double middle = 0.5 * (from + to), half = 0.5 * (to - from) / std::sqrt(3.0);
              integral += 0.5 * (to - from) * (law.yield_stress_at(middle - half) + law.yield_stress_at(middle + half));
              from = to;
            }
            EXPECT_NEAR(law.work(e), integral, 1e-6 * integral) << any.index() << " at " << e;
          }
          EXPECT_NEAR(law.work(0.0), 0.0, 1e-15);
          EXPECT_GE(law.modulus_at(0.0), 0.0);
          EXPECT_EQ(law.yield_stress_at(0.0), initial_yield_stress(any));
        },
        any);
}

TEST(HardeningTest, LawsOfAUserAreComparedWhereTheyCanBe)
{
  const UserHardening voce(VoceHardening{yield, 0.5, 12.0});
  EXPECT_EQ(voce, UserHardening(VoceHardening{yield, 0.5, 12.0}));
  EXPECT_NE(voce, UserHardening(VoceHardening{yield, 0.5, 13.0}));
  EXPECT_NE(voce, UserHardening(PerfectPlasticity{yield}));
  EXPECT_NE(HardeningLaw(voce), HardeningLaw(VoceHardening{yield, 0.5, 12.0}));
  const UserHardening own(OwnLaw{}); // has no comparison
  const UserHardening& copy = own;
  EXPECT_EQ(own, UserHardening(copy));
  EXPECT_NE(own, UserHardening(OwnLaw{}));
  const auto constant = [](double) { return yield; };
  const auto zero = [](double) { return 0.0; };
  EXPECT_NE(UserHardening(constant, zero), UserHardening(constant, zero));
  EXPECT_NEAR(UserHardening(constant, zero).work(0.3), 0.3 * yield, 1e-15);
}

TEST(HardeningTest, LawsOfAUserMustBeLaws)
{
  const auto refusal = [](auto yield_stress, auto modulus)
  {
    try
    {
      static_cast<void>(UserHardening(yield_stress, modulus));
    }
    catch (const InputError& error)
    {
      return std::string(error.what());
    }
    return std::string();
  };
  const auto zero = [](double) { return 0.0; };
  EXPECT_NE(refusal(zero, zero).find("yield stress 0 Pa at the plastic strain 0; allowed: > 0"), std::string::npos);
  EXPECT_NE(refusal([](double e) { return 1.0 - 0.1 * e; }, zero).find("softening is not modelled"), std::string::npos);
  EXPECT_NE(refusal([](double) { return 1.0; }, [](double) { return -1.0; }).find("slope -1 Pa"), std::string::npos);
  EXPECT_EQ(refusal([](double) { return 1.0; }, zero), "");
}

TEST(HardeningTest, LawsInTheirOwnWords)
{
  EXPECT_DOUBLE_EQ((SwiftHardening{2.0, 0.003, 0.15}.yield_stress_at(0.01)), 2.0 * std::pow(0.013, 0.15));
  EXPECT_NEAR(swift_of_microstrain(0.4, 20.0, 0.08).yield_stress_at(0.01), 0.4 * std::pow(20.0 + 1e4, 0.08), 1e-13);
  EXPECT_NEAR(hollomon(yield, 1.8, 0.2).yield_stress_at(0.0), yield, 1e-14);
  EXPECT_DOUBLE_EQ((LudwikHardening{yield, 1.1, 0.5}.yield_stress_at(0.04)), yield + 1.1 * 0.2);
  EXPECT_NEAR((VoceHardening{yield, 0.5, 12.0}.yield_stress_at(10.0)), yield + 0.5, 1e-15);
  const TabulatedHardening table({0.0, 0.1}, {1.0, 3.0});
  EXPECT_DOUBLE_EQ(table.yield_stress_at(0.025), 1.5);
  EXPECT_DOUBLE_EQ(table.yield_stress_at(0.1), 3.0);
  EXPECT_DOUBLE_EQ(table.yield_stress_at(7.0), 3.0);
  EXPECT_DOUBLE_EQ(TabulatedHardening({0.0}, {2.0}).yield_stress_at(0.5), 2.0);
}

TEST(HardeningTest, TablesThatAreNoneAreRefused)
{
  using V = std::vector<double>;
  EXPECT_THROW(TabulatedHardening(V{}, V{}), InputError);
  EXPECT_THROW(TabulatedHardening(V{0.0, 0.1}, V{1.0}), InputError);
  EXPECT_THROW(TabulatedHardening(V{0.1, 0.2}, V{1.0, 2.0}), InputError); // does not begin at zero
  EXPECT_THROW(TabulatedHardening(V{0.0, 0.2, 0.2}, V{1.0, 2.0, 2.0}), InputError);
  EXPECT_THROW(TabulatedHardening(V{0.0, 0.2}, V{2.0, 1.0}), InputError); // softening
  EXPECT_THROW(TabulatedHardening(V{0.0}, V{0.0}), InputError);
  EXPECT_THROW(TabulatedHardening(V{0.0, std::numeric_limits<double>::infinity()}, V{1.0, 2.0}), InputError);
}

TEST(MaterialTest, IsPlasticIfItHardens)
{
  EXPECT_FALSE((Material{{1.0, 0.3}, {}}).is_plastic());
  EXPECT_TRUE((Material{{1.0, 0.3}, PerfectPlasticity{1.0}}).is_plastic());
}

} // namespace
} // namespace brinell::constitutive::hardening_test
