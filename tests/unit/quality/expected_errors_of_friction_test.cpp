// SPDX-License-Identifier: BSD-3-Clause
// Expected errors of surfaces that rub or creep: docs/verification/accuracy.md (expected error).
#include "stated_errors.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace brinell::quality::expected_errors_of_friction_test
{
namespace
{

TEST(ExpectedErrors, OfCreepDependOnWhatSlips)
{
  RollingCase c = ball_on_flat();
  c.lower.material.hardening.reset();
  c.friction.coefficient = 0.3;
  c.creepage = Creepage{1e-3, 0.0, 1.0};
  RollingSummary s;
  static_cast<RunTotals&>(s) = good_totals(c);
  s.max_equivalent_plastic_strain = 0.0;
  s.coverage.plastic_layers = 0;
  s.passes.resize(1);
  s.passes[0].F_x = 0.5 * c.friction.coefficient * c.drive.value;
  const auto stated = [&](const char* quantity, double sticks)
  {
    s.passes[0].stick_share = sticks;
    return stated_error(quality::judged(c, plan(c), s), quantity);
  };
  EXPECT_GT(stated("creep force", 0.99), 2.0 * stated("creep force", 0.5));
  EXPECT_LT(stated("creep force", 0.5), 0.02);
  // That of the share that sticks is a row of cells, whatever the share.
  EXPECT_NEAR(stated("stick share", 0.2), 2.5 * stated("stick share", 0.5), 1e-12);
  EXPECT_TRUE(std::isnan(stated("stick share", 0.0)));
  EXPECT_TRUE(std::isnan(stated_error(quality::expected(c, plan(c)), "stick share")));
}

TEST(ExpectedErrors, WithFrictionOfShoulderAndLargestStrainAreLarger)
{
  RollingCase c = ball_on_flat();
  c.slide_to_roll = 0.3;
  const auto shoulder = [&] { return stated_error(quality::judged(c, plan(c), good_totals(c)), "shoulder"); };
  const double without = shoulder();
  c.friction.coefficient = 0.25;
  EXPECT_GT(shoulder(), 2.0 * without);
  TuggingCase t;
  t.lower = t.upper = {Paraboloid{1.0, 1.0}, {{200e9, 0.32}, constitutive::PerfectPlasticity{0.9e9}}};
  t.interference = 2e-3;
  const auto strain = [&] { return stated_error(quality::expected(t, plan(t)), "largest plastic strain"); };
  const double smooth = strain();
  t.friction.coefficient = 0.1;
  EXPECT_GT(strain(), 4.0 * smooth);
}

TEST(ExpectedErrors, OfTheShareThatSticksInFrettingFollowMindlin)
{
  // A row of cells around the circle that sticks, of (1 - Q/f P)^(2/3) of the contact.
  FrettingCase c;
  c.lower = {Plane{}, {{210e9, 0.3}, {}}};
  c.upper = {Paraboloid{10e-3, 10e-3}, {{210e9, 0.3}, {}}};
  c.press = {contact::Drive::Kind::load, 10.0};
  c.friction.coefficient = 0.3;
  c.kind = FrettingCase::Kind::force;
  const auto stated = [&](double share)
  {
    c.amplitude = share * 3.0;
    return stated_error(quality::expected(c, plan(c)), "stick share");
  };
  EXPECT_NEAR(stated(0.8) / stated(0.2), std::pow(4.0, 2.0 / 3.0), 1e-9);
  EXPECT_GT(stated(0.5), 0.045 / std::pow(0.5, 2.0 / 3.0)); // found with 8.5 cells
}

} // namespace
} // namespace brinell::quality::expected_errors_of_friction_test
