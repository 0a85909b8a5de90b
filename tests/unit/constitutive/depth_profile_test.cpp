// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/constitutive/depth_profile.hpp"
#include "brinell/foundation/error.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace brinell::constitutive::depth_profile_test
{
namespace
{

TEST(DepthProfileTest, IsLinearBetweenItsPointsAndConstantBeyond)
{
  const DepthProfile p({0.5, 1.0, 3.0}, {2.0, 4.0, 1.0});
  EXPECT_DOUBLE_EQ(p.at(0.0, 9.0), 2.0);
  EXPECT_DOUBLE_EQ(p.at(0.75, 9.0), 3.0);
  EXPECT_DOUBLE_EQ(p.at(1.0, 9.0), 4.0);
  EXPECT_DOUBLE_EQ(p.at(2.0, 9.0), 2.5);
  EXPECT_DOUBLE_EQ(p.at(8.0, 9.0), 1.0);
  EXPECT_DOUBLE_EQ(DepthProfile().at(0.3, 9.0), 9.0);
  EXPECT_DOUBLE_EQ(DepthProfile({1.0}, {2.0}).at(0.3, 9.0), 2.0);
}

TEST(DepthProfileTest, RefusesWhatIsNone)
{
  using V = std::vector<double>;
  EXPECT_THROW(DepthProfile(V{}, V{}), InputError);
  EXPECT_THROW(DepthProfile(V{0.0, 1.0}, V{1.0}), InputError);
  EXPECT_THROW(DepthProfile(V{1.0, 1.0}, V{1.0, 2.0}), InputError);
  EXPECT_THROW(DepthProfile(V{-1.0}, V{1.0}), InputError);
  EXPECT_THROW(DepthProfile(V{0.0}, V{std::numeric_limits<double>::quiet_NaN()}), InputError);
}

} // namespace
} // namespace brinell::constitutive::depth_profile_test
