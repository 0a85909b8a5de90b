// SPDX-License-Identifier: BSD-3-Clause
#include "elastoplastic/interface/shear_bound.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace brinell::elastoplastic::shear_bound_test
{
namespace
{

using Field = std::vector<double>;

// All numbers are sums of powers of two, so that products with the coefficient 1/4 are exact.
constexpr double coefficient = 0.25;

ShearBound begun(bool is_held)
{
  ShearBound bound(coefficient, 3);
  bound.begin({100.0, 2.0, 0.0}, is_held, Field{4.0, 16.0, 8.0});
  return bound;
}

TEST(ShearBoundTest, IsFrictionCutOffAtWhatTheSurfacesCarry)
{
  const ShearBound bound = begun(false);
  EXPECT_EQ(bound.now(), (Field{1.0, 2.0, 0.0}));
  EXPECT_FALSE(bound.is_limited(0, 4.0));
  EXPECT_FALSE(bound.is_limited(1, 8.0)); // just at it
  EXPECT_TRUE(bound.is_limited(1, 16.0));
}

TEST(ShearBoundTest, FollowsEachPressureAndRemembersTheFirst)
{
  ShearBound bound = begun(false);
  EXPECT_TRUE(bound.follow(Field{8.0, 4.0, 4.0}));
  EXPECT_EQ(bound.now(), (Field{2.0, 1.0, 0.0}));
  EXPECT_TRUE(bound.follow(Field{0.0, 4.0, 4.0}));
  EXPECT_EQ(bound.now(), (Field{0.0, 1.0, 0.0}));
  EXPECT_EQ(bound.before(), (Field{1.0, 2.0, 0.0}));
  bound.set_limit({100.0, 0.5, 0.0}); // the surfaces have softened
  EXPECT_TRUE(bound.follow(Field{0.0, 4.0, 4.0}));
  EXPECT_EQ(bound.now(), (Field{0.0, 0.5, 0.0}));
}

TEST(ShearBoundTest, IsHeldUntilItIsRenewed)
{
  ShearBound bound = begun(true);
  EXPECT_TRUE(bound.follow(Field{8.0, 4.0, 4.0}));
  EXPECT_FALSE(bound.follow(Field{16.0, 4.0, 4.0}));
  EXPECT_EQ(bound.renew(Field{16.0, 6.0, 4.0}), 2.0);
  EXPECT_EQ(bound.now(), (Field{2.0, 1.0, 0.0})); // that of the present solution
  EXPECT_TRUE(bound.follow(Field{16.0, 6.0, 4.0}));
  EXPECT_EQ(bound.now(), (Field{4.0, 1.5, 0.0}));
}

} // namespace
} // namespace brinell::elastoplastic::shear_bound_test
