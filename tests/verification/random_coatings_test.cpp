// SPDX-License-Identifier: BSD-3-Clause
// Random coated bodies that yield: every run converges, or says clearly why it cannot, and its energy closes.
#include "brinell/foundation/error.hpp"
#include "brinell/io/member_keys.hpp"
#include "brinell/simulation/indentation.hpp"
#include "random_scenarios.hpp"
#include "scenario_runs.hpp"
#include "sweep.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace brinell::verification::random_coatings_test
{
namespace
{

using namespace constitutive;

HardeningLaw random_law(Draw& draw, double E)
{
  const double yield = E * draw.power_of_ten(-2.7, -2.0);
  switch (draw.below(4))
  {
  case 0:
    return PerfectPlasticity{yield};
  case 1:
    return LinearHardening{yield, E * draw.between(0.0, 0.1)};
  case 2:
    return SwiftHardening{yield, draw.power_of_ten(-4.0, -2.0), draw.between(0.05, 0.4)};
  default:
    return VoceHardening{yield, yield * draw.between(0.0, 1.0), draw.between(5.0, 100.0)};
  }
}

/// One to four layers, from a fifth of the contact radius to six of them thick, a hundred times softer to a hundred times harder
/// than the substrate. Some stay elastic. In a tenth of the cases the interfaces are at arbitrary depths, which cells may not meet.
simulation::IndentationCase random_coated(Draw& draw)
{
  const double R = draw.power_of_ten(-6.0, -1.0), E = draw.power_of_ten(9.0, 11.6);
  simulation::IndentationCase c;
  Material substrate{{E, draw.between(0.0, 0.45)}, random_law(draw, E)};
  c.lower = {simulation::Plane{}, substrate};
  c.upper = {simulation::Paraboloid{R, R}, {{std::numeric_limits<double>::infinity(), 0.0}, {}}};
  const double a = R * draw.between(0.02, 0.12);
  const double unit = a * draw.power_of_ten(-0.7, 0.0);
  const bool arbitrary = draw.chance(0.1);
  const int count = 1 + draw.below(4);
  for (int n = 0; n < count; ++n)
  {
    const double modulus = E * draw.power_of_ten(-2.0, 2.0);
    Coat coat{unit * (arbitrary ? draw.between(1.0, 6.0) : 1 + draw.below(6)), {modulus, draw.between(0.0, 0.45)}, {}};
    if (draw.chance(0.8))
      coat.hardening = random_law(draw, modulus);
    c.lower.material.layers.push_back(coat);
  }
  const double depth = a * a / R * draw.between(0.5, 1.5);
  c.sequence = {approach(depth), approach(0.0)};
  c.steps = 30;
  c.resolution = 3.0;
  return c;
}

TEST(RandomCoatings, ConvergeAndBalance)
{
  const test::Sweep cases(200);
  int converged = 0, refused = 0, yielded = 0, split = 0;
  double worst = 0.0, evaluations = 0.0, steps = 0.0;
  for (int number = 0; number < cases.count(); ++number)
  {
    if (!cases.has(number))
      continue;
    SCOPED_TRACE(number);
    Draw draw(static_cast<unsigned>(7000 + number));
    try
    {
      const IndentationRun run = computed(random_coated(draw));
      const simulation::RunTotals& s = run.summary;
      ++converged;
      split += s.split_increments;
      evaluations += static_cast<double>(s.evaluations);
      steps += s.steps;
      yielded += s.max_equivalent_plastic_strain > 0.0 ? 1 : 0;
      for (const double x : {s.work, s.dissipation_lower, s.max_residual_lower, s.max_equivalent_plastic_strain})
        EXPECT_TRUE(std::isfinite(x));
      EXPECT_GE(s.dissipation_lower, 0.0);
      EXPECT_LE(std::abs(s.energy_balance_error), 5e-3);
      worst = std::max(worst, std::abs(s.energy_balance_error));
    }
    catch (const InputError& error)
    {
      ++refused;
      const std::string why = io::with_keys(error.what());
      EXPECT_NE(why.find("lower.material.layers"), std::string::npos) << why;
      EXPECT_NE(why.find("cells that end at all interfaces"), std::string::npos) << why;
    }
    catch (const ConvergenceError& error)
    {
      ADD_FAILURE() << error.what();
    }
  }
  std::printf(
      "%d converged, %d of them yielded, %d refused; %d increments split; %.1f evaluations a step; energy to %.2e\n",
      converged, yielded, refused, split, evaluations / steps, worst);
  EXPECT_LE(refused, cases.size() / 4);
  EXPECT_GE(yielded, converged / 2);
}

} // namespace
} // namespace brinell::verification::random_coatings_test
