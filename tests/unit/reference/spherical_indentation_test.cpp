// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/foundation/error.hpp"
#include "brinell/reference/spherical_indentation.hpp"

#include <gtest/gtest.h>

#include <array>

namespace brinell::reference::spherical_indentation_test
{
namespace
{

const IndentedSphere steel{{200e9, 0.32}, 0.9115e9};

TEST(SphericalIndentationTest, Table)
{
  // Evaluated from the published fits, to the last digit given.
  const std::array<std::array<double, 3>, 6> table{{{2.0, 2.817, 2.766},
                                                    {4.0, 7.418, 7.426},
                                                    {6.0, 12.934, 13.234},
                                                    {9.0, 22.353, 22.456},
                                                    {15.0, 43.899, 42.809},
                                                    {20.0, 63.701, 61.564}}};
  for (const auto& [ratio, jackson_green, kogut_etsion] : table)
  {
    EXPECT_NEAR(jackson_green_load(ratio, steel), jackson_green, 6e-4) << ratio;
    EXPECT_NEAR(kogut_etsion_load(ratio), kogut_etsion, 6e-4) << ratio;
  }
}

TEST(SphericalIndentationTest, ElasticBelowTheirLimits)
{
  EXPECT_DOUBLE_EQ(jackson_green_load(1.0, steel), 1.0);
  EXPECT_DOUBLE_EQ(jackson_green_area(1.5, steel), 1.5);
  EXPECT_DOUBLE_EQ(kogut_etsion_load(0.25), 0.125);
}

TEST(SphericalIndentationTest, StepsBetweenTheirBranches)
{
  const auto step = [](auto f, double at) { return f(at * (1.0 + 1e-9)) / f(at * (1.0 - 1e-9)) - 1.0; };
  const auto jackson_green = [](double w) { return jackson_green_load(w, steel); };
  EXPECT_NEAR(step(jackson_green, 1.9), 0.0, 1e-3); // the two branches were fitted to meet
  EXPECT_NEAR(step(kogut_etsion_load, 1.0), 0.030, 5e-4);
  EXPECT_NEAR(step(kogut_etsion_load, 6.0), 0.017, 5e-4);
}

TEST(SphericalIndentationTest, RefusesNonsense)
{
  EXPECT_THROW((void)kogut_etsion_load(111.0), InputError);
  EXPECT_THROW((void)kogut_etsion_load(0.0), InputError);
  EXPECT_THROW((void)jackson_green_load(-1.0, steel), InputError);
  EXPECT_THROW((void)jackson_green_load(2.0, {{200e9, 0.3}, 0.0}), InputError);
}

} // namespace
} // namespace brinell::reference::spherical_indentation_test
