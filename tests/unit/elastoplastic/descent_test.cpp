// SPDX-License-Identifier: BSD-3-Clause
// The guarded way through an increment, the plain fixed point: slow, but its energy falls at every step.
#include "sphere_press.hpp"
#include "state_comparison.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace brinell::elastoplastic::descent_test
{
namespace
{

/// The plain fixed point with the stiffness that bounds that of any plastic strain: it descends always.
Strategy descent(int max_evaluations)
{
  Strategy s;
  s.integration = Integration::backward_euler;
  s.max_evaluations = max_evaluations;
  s.anderson_depth = 0;
  s.stiffness_share = 1.0;
  s.watch_energy = true;
  return s;
}

TEST(DescentTest, PlainAndAcceleratedIterationMeet)
{
  // Backward Euler makes the increment a convex problem: one answer. Both to 1e-9 of yield, times the ratio of stress to
  // the softest response, about 1e3.
  PressOptions options;
  options.settings = tight_settings();
  SpherePress accelerated(options), plain(options);
  for (const double interference : {3.0, 6.0})
  {
    ASSERT_TRUE(accelerated.press(interference, Integration::backward_euler).converged);
    ASSERT_TRUE(plain.press(interference, descent(5000)).converged);
  }
  expect_same_state(plain.contact().lower().state(), accelerated.contact().lower().state(), 1e-6);
  expect_near(copy(plain.contact().pressure()), copy(accelerated.contact().pressure()), 1e-6, "pressure");
}

TEST(DescentTest, EnergyFallsAtEveryPlainIteration)
{
  // The functional of the increment, 1/2 eps H eps + D + 1/2 p A p, at the iterates one by one: a new start each time,
  // stopped after one more evaluation. It may rise by round-off and the inexactness of the contact only.
  PressOptions options;
  options.settings = tight_settings();
  SpherePress press(options);
  ASSERT_TRUE(press.press(3.0, Integration::backward_euler).converged);
  double previous = std::numeric_limits<double>::max();
  for (int evaluations = 2; evaluations <= 26; ++evaluations)
  {
    const IncrementReport stopped =
        press.press(5.0, descent(evaluations)); // reports the energy before its last evaluation
    ASSERT_FALSE(stopped.converged);
    ASSERT_FALSE(stopped.energy_rose);
    EXPECT_LE(stopped.energy, previous * (1.0 + 1e-10)) << evaluations;
    previous = stopped.energy;
  }
  const IncrementReport report = press.press(5.0, descent(5000));
  ASSERT_TRUE(report.converged);
  EXPECT_LE(report.energy, previous * (1.0 + 1e-10));
}

TEST(DescentTest, GivesNoFalseAlarm)
{
  // At the default tolerances the contact is known to 1e-7 of the interference only: that must not look like a rise.
  for (const double share : {0.6, 1.0})
  {
    SpherePress press;
    for (const double interference : {2.0, 3.0, 6.0})
    {
      Strategy strategy = descent(200);
      strategy.stiffness_share = share;
      const IncrementReport report = press.press(interference, strategy);
      EXPECT_TRUE(report.converged) << share << ' ' << interference;
      EXPECT_FALSE(report.energy_rose) << share << ' ' << interference;
    }
  }
}

} // namespace
} // namespace brinell::elastoplastic::descent_test
