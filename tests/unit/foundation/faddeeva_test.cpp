// SPDX-License-Identifier: BSD-3-Clause
#include "foundation/faddeeva.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace brinell::faddeeva_test
{
namespace
{

TEST(Faddeeva, OnTheAxesAndByItsTable)
{
  for (const double y : {0.0, 0.1, 1.0, 3.0, 5.0})
    EXPECT_NEAR(faddeeva({0.0, y}).real(), std::exp(y * y) * std::erfc(y), 1e-12);
  for (const double x : {-4.0, 0.3, 2.0, 6.0})
    EXPECT_NEAR(faddeeva({x, 0.0}).real(), std::exp(-x * x), 1e-12);
  // Abramowitz and Stegun (1972), Table 7.9
  EXPECT_NEAR(faddeeva({0.5, 0.5}).real(), 0.533157, 1e-6);
  EXPECT_NEAR(faddeeva({0.5, 0.5}).imag(), 0.230488, 1e-6);
  EXPECT_NEAR(faddeeva({2.0, 1.0}).real(), 0.140240, 1e-6);
  EXPECT_NEAR(faddeeva({2.0, 1.0}).imag(), 0.222213, 1e-6);
}

} // namespace
} // namespace brinell::faddeeva_test
