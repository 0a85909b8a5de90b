// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/simulation/indentation.hpp"
#include "brinell/simulation/run.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

/// A hardening law of a user's own goes through a whole run as those of the library do.
namespace brinell::simulation::user_law_test
{
namespace
{

using constitutive::HardeningLaw;
using constitutive::SwiftHardening;
using constitutive::UserHardening;
using constitutive::VoceHardening;

/// Written as a user would: without the integral, which is then computed, and without a comparison.
struct OwnVoce
{
  double yield_stress, saturation, rate;

  [[nodiscard]] double yield_stress_at(double e) const
  {
    return yield_stress + saturation * (1.0 - std::exp(-rate * e));
  }
  [[nodiscard]] double modulus_at(double e) const { return saturation * rate * std::exp(-rate * e); }
};

std::vector<IndentationRecord> pressed(const HardeningLaw& law, bool plain = false)
{
  IndentationCase c;
  c.lower = {Plane{}, {{200e9, 0.3}, law}};
  c.upper = {Paraboloid{1e-3, 1e-3}, {{300e9, 0.25}, {}}};
  c.sequence = {{contact::Drive::Kind::load, 40.0}, {contact::Drive::Kind::load, 0.0}};
  c.steps = 4;
  c.resolution = 3.0;
  c.solver.yield_tolerance = 1e-6; // so that rounding is not carried on to shares of these that count
  c.solver.displacement_tolerance = 1e-6;
  if (plain) // the fixed point of the convex problem, which is watched by the energy: the integral of the law counts
    c.solver.max_evaluations = 2;
  Run<IndentationCase> run(c);
  std::vector<IndentationRecord> history;
  while (!run.is_done())
    history.push_back(run.step());
  return history;
}

/// Largest difference over the largest value.
double difference(const std::vector<IndentationRecord>& a, const std::vector<IndentationRecord>& b,
                  double IndentationRecord::*quantity)
{
  double change = 0.0, largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    change = std::max(change, std::abs(a[i].*quantity - b[i].*quantity));
    largest = std::max(largest, std::abs(a[i].*quantity));
  }
  return change / largest;
}

void expect_same(const std::vector<IndentationRecord>& a, const std::vector<IndentationRecord>& b)
{
  ASSERT_EQ(a.size(), b.size());
  EXPECT_GT(a.back().dissipation_lower, 0.0);
  // Rounding, which the iteration may carry on to some share of its tolerances, 1e-6 of the yield stress here.
  constexpr double rounding = 1e-6;
  EXPECT_LT(difference(a, b, &IndentationRecord::approach), rounding);
  // A cell an eighth of the contact radius wide turns the gap that the contact may leave, 1e-7 of the approach, into
  // 1e-7 * 2.8 * 8 of the peak pressure (Hertz' approach and pressure; a cell gives way by 0.56 p dx / E').
  EXPECT_LT(difference(a, b, &IndentationRecord::max_pressure), 3.0 * rounding);
  EXPECT_LT(difference(a, b, &IndentationRecord::residual_depth), rounding);
  EXPECT_LT(difference(a, b, &IndentationRecord::work), rounding);
}

TEST(UserLaw, GivesTheResultsOfTheSameLawOfTheLibrary)
{
  const VoceHardening voce{1e9, 0.4e9, 60.0};
  const auto built_in = pressed(voce);
  expect_same(built_in, pressed(UserHardening(voce)));
  expect_same(built_in, pressed(UserHardening(OwnVoce{1e9, 0.4e9, 60.0})));
  const SwiftHardening swift{2e9, 2e-3, 0.12};
  expect_same(pressed(swift), pressed(UserHardening([swift](double e) { return swift.yield_stress_at(e); },
                                                    [swift](double e) { return swift.modulus_at(e); })));
  // It is the law that counts: a softer one gives a deeper indent.
  EXPECT_GT(pressed(UserHardening(OwnVoce{0.9e9, 0.4e9, 60.0})).back().residual_depth,
            1.02 * built_in.back().residual_depth);
}

TEST(UserLaw, AlsoWhereTheEnergyGuardsTheStep)
{
  const VoceHardening voce{1e9, 0.4e9, 60.0};
  expect_same(pressed(voce, true), pressed(UserHardening(OwnVoce{1e9, 0.4e9, 60.0}), true));
}

TEST(UserLaw, BodiesOfTheSameLawAreTwins)
{
  const auto twin = [](const HardeningLaw& lower, const HardeningLaw& upper)
  {
    IndentationCase c;
    c.lower = {Paraboloid{1e-3, 1e-3}, {{200e9, 0.3}, lower}};
    c.upper = {Paraboloid{1e-3, 1e-3}, {{200e9, 0.3}, upper}};
    c.sequence = {{contact::Drive::Kind::load, 40.0}};
    return plan(c).twin;
  };
  const HardeningLaw law = UserHardening(OwnVoce{1e9, 0.4e9, 60.0});
  EXPECT_EQ(twin(law, law), elastoplastic::Twin::alike);
  // Made anew it cannot be compared, so that both bodies are solved.
  EXPECT_EQ(twin(law, UserHardening(OwnVoce{1e9, 0.4e9, 60.0})), elastoplastic::Twin::none);
  const VoceHardening voce{1e9, 0.4e9, 60.0};
  EXPECT_EQ(twin(UserHardening(voce), UserHardening(voce)), elastoplastic::Twin::alike);
}

} // namespace
} // namespace brinell::simulation::user_law_test
