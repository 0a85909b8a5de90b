// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/constitutive/material.hpp"

#include <gtest/gtest.h>

namespace brinell::constitutive
{
namespace
{

TEST(HardeningTest, WorkIsTheIntegralOfTheYieldStressAndModulusItsSlope)
{
  const auto check = [](const auto& law)
  {
    for (const double e : {0.0, 1e-3, 0.2})
    {
      const double h = 1e-5; // both laws are at most quadratic in work: central differences are exact to round-off
      EXPECT_NEAR((law.work(e + h) - law.work(e - h)) / (2.0 * h), law.yield_stress_at(e), 1e-10);
      EXPECT_NEAR((law.yield_stress_at(e + h) - law.yield_stress_at(e - h)) / (2.0 * h), law.modulus_at(e), 1e-10);
    }
    EXPECT_EQ(law.work(0.0), 0.0);
    EXPECT_EQ(law.yield_stress_at(0.0), initial_yield_stress(HardeningLaw(law)));
  };
  check(PerfectPlasticity{0.9});
  check(LinearHardening{0.9, 3.0});
}

TEST(MaterialTest, IsPlasticIfItHardens)
{
  EXPECT_FALSE((Material{{1.0, 0.3}, {}}).is_plastic());
  EXPECT_TRUE((Material{{1.0, 0.3}, PerfectPlasticity{1.0}}).is_plastic());
}

} // namespace
} // namespace brinell::constitutive
