// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/constitutive/kinematic_return.hpp"

#include "order.hpp"
#include "random_field.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace brinell::constitutive::kinematic_return_test
{
namespace
{

constexpr double mu = 76.0; // in units of the yield stress, about that of a steel
constexpr PerfectPlasticity perfect{1.0};

Deviator sum(const std::vector<Deviator>& back)
{
  Deviator total;
  for (const Deviator& b : back)
    total = total + b;
  return total;
}

/// One material point, driven by its total strain deviator.
template <typename Law>
struct Point
{
  Law law;
  std::vector<KinematicTerm> terms;
  double end = 0.5;
  Deviator stress{}, plastic{};
  double e = 0.0, work = 0.0;
  std::vector<Deviator> back = std::vector<Deviator>(terms.size());

  void strain_by(const Deviator& increment)
  {
    const Deviator q = stress + (2.0 * mu) * increment;
    const PlasticIncrement p = kinematic_return(stress, q, e, mu, law, end, terms, back);
    stress = q - (2.0 * mu) * p.strain;
    plastic = plastic + p.strain;
    e += p.equivalent;
    work += p.dissipation;
  }
  /// Strains along one direction until the stress along it is `target` (to the accuracy of `step`, a strain).
  void pull(const Deviator& direction, double signed_strain, int steps)
  {
    for (int i = 0; i < steps; ++i)
      strain_by((signed_strain / steps) * direction);
  }
  /// Plastic strain along a direction of size 1, as a uniaxial one, with its sign.
  [[nodiscard]] double equivalent_strain(const Deviator& direction) const { return along(plastic, direction) / 1.5; }
  /// Signed size along a direction of size 1.
  [[nodiscard]] static double along(const Deviator& tensor, const Deviator& direction)
  {
    return 1.5 * contract(tensor, direction);
  }
};

const std::vector<KinematicTerm> prager{{8.0, 0.0}};
const std::vector<KinematicTerm> armstrong_frederick{{60.0, 150.0}};
const std::vector<KinematicTerm> chaboche{{200.0, 900.0}, {40.0, 120.0}, {3.0, 0.0}};

TEST(KinematicReturnTest, WithoutTermsItIsTheIsotropicReturn)
{
  const LinearHardening law{1.0, 20.0};
  std::vector<Deviator> none;
  for (unsigned seed = 0; seed < 200; ++seed)
  {
    const Deviator s0 = test::random_deviator(seed, 0.9), q = test::random_deviator(seed + 500, 0.5 + 0.02 * seed);
    const PlasticIncrement path = path_return(s0, q, 0.0, mu, law), radial = radial_return(q, 0.0, mu, law);
    const PlasticIncrement half = kinematic_return(s0, q, 0.0, mu, law, 0.5, {}, none);
    const PlasticIncrement full = kinematic_return(s0, q, 0.0, mu, law, 1.0, {}, none);
    EXPECT_NEAR(von_mises(half.strain - path.strain), 0.0, 1e-12);
    EXPECT_NEAR(half.equivalent, path.equivalent, 1e-12);
    EXPECT_NEAR(half.dissipation, path.dissipation, 1e-12);
    EXPECT_NEAR(von_mises(full.strain - radial.strain), 0.0, 1e-12);
  }
}

TEST(KinematicReturnTest, StressEndsOnTheMovedYieldSurface)
{
  for (const double end : {0.5, 1.0})
    for (unsigned seed = 0; seed < 300; ++seed)
    {
      Point<LinearHardening> point{{1.0, 5.0}, chaboche, end};
      for (unsigned i = 0; i < 5; ++i)
        point.strain_by(test::random_deviator(7 * seed + i, std::pow(10.0, -4.0 + 0.01 * seed)));
      const double size = von_mises(point.stress - sum(point.back));
      EXPECT_LE(size, point.law.yield_stress_at(point.e) + 1e-9) << seed;
    }
}

TEST(KinematicReturnTest, MonotonicCurveIsTheClosedForm)
{
  // Proportional loading, any size of step: back stress C / gamma (1 - e^{-gamma e}), on top of the yield stress.
  const Deviator direction = test::random_deviator(3, 1.0);
  for (const auto& terms : {prager, armstrong_frederick, chaboche})
    for (const int steps : {1, 7, 100})
    {
      Point<LinearHardening> point{{1.0, 2.0}, terms};
      point.pull(direction, 0.05, steps);
      double expected = point.law.yield_stress_at(point.e);
      for (const KinematicTerm& t : terms)
        expected += t.recall > 0.0 ? -t.modulus / t.recall * std::expm1(-t.recall * point.e) : t.modulus * point.e;
      EXPECT_GT(point.e, 0.02);
      EXPECT_NEAR(Point<LinearHardening>::along(point.stress, direction), expected, 1e-9) << steps;
    }
}

TEST(KinematicReturnTest, ReversalYieldsAtTwiceTheYieldStress)
{
  // Bauschinger: with Prager's term the elastic range keeps its size, 2 S_y, wherever it has moved.
  const Deviator direction = test::random_deviator(4, 1.0);
  Point<PerfectPlasticity> point{perfect, prager};
  point.pull(direction, 0.05, 10);
  const double top = Point<PerfectPlasticity>::along(point.stress, direction), e = point.e;
  const double elastic = 1.0 / mu; // strain of a change of stress by 2 S_y
  point.pull(direction, -0.999 * elastic, 1);
  EXPECT_EQ(point.e, e);
  EXPECT_NEAR(Point<PerfectPlasticity>::along(point.stress, direction), top - 2.0 * 0.999, 1e-10);
  point.pull(direction, -0.01, 1);
  EXPECT_GT(point.e, e);
}

TEST(KinematicReturnTest, SymmetricCyclesReachTheStableLoopOfArmstrongAndFrederick)
{
  // Strain-controlled cycles of plastic range 2 a: the stable stress amplitude is S_y + C / gamma tanh(gamma a).
  const Deviator direction = test::random_deviator(5, 1.0);
  Point<PerfectPlasticity> point{perfect, armstrong_frederick};
  const auto along = [&](const Deviator& t) { return Point<PerfectPlasticity>::along(t, direction); };
  double stress = 0.0, top = 0.0, bottom = 0.0;
  point.pull(direction, 0.01, 20);
  for (int cycle = 0; cycle < 40; ++cycle)
  {
    point.pull(direction, -0.02, 40);
    bottom = point.equivalent_strain(direction);
    point.pull(direction, 0.02, 40);
    top = point.equivalent_strain(direction);
    stress = along(point.stress);
  }
  const double amplitude = 0.5 * (top - bottom);
  const KinematicTerm& t = armstrong_frederick.front();
  EXPECT_NEAR(stress, 1.0 + t.modulus / t.recall * std::tanh(t.recall * amplitude), 1e-6);
}

TEST(KinematicReturnTest, StressCyclesWithAMeanRatchetAsTheClosedFormSays)
{
  // Armstrong, Frederick under stress cycles between s_max and s_min: the plastic strain per cycle is
  //   1/gamma ln( [ (C/gamma)^2 - (s_min + S_y)^2 ] / [ (C/gamma)^2 - (s_max - S_y)^2 ] )
  // (Lemaitre, Chaboche 1990, section 5.4).
  const Deviator direction = test::random_deviator(6, 1.0);
  const KinematicTerm t{60.0, 40.0}; // saturates at 1.5 S_y
  Point<PerfectPlasticity> point{perfect, {t}};
  const auto along = [&](const Deviator& x) { return Point<PerfectPlasticity>::along(x, direction); };
  const double top = 1.6, bottom = -1.2;
  const auto drive_to = [&](double target)
  {
    // Small strain steps, the last ones refined: plasticity makes the stress a function of the strain only in steps.
    double step = (target > along(point.stress) ? 1.0 : -1.0) * 2e-4;
    while (std::abs(step) > 1e-12)
    {
      const Point<PerfectPlasticity> before = point;
      point.strain_by(step * direction);
      if ((along(point.stress) - target) * step > 0.0)
      {
        point = before;
        step *= 0.5;
      }
    }
  };
  const auto equivalent_strain = [&] { return point.equivalent_strain(direction); };
  drive_to(top);
  double previous = equivalent_strain(), gain = 0.0;
  for (int cycle = 0; cycle < 5; ++cycle)
  {
    drive_to(bottom);
    drive_to(top);
    gain = equivalent_strain() - previous;
    previous = equivalent_strain();
  }
  const double saturation = t.modulus / t.recall;
  const double expected = std::log((saturation * saturation - (bottom + 1.0) * (bottom + 1.0)) /
                                   (saturation * saturation - (top - 1.0) * (top - 1.0))) /
                          t.recall;
  EXPECT_NEAR(gain, expected, 1e-6);
  EXPECT_GT(expected, 1e-3);
}

TEST(KinematicReturnTest, TurningPathIsSecondOrderAndBackwardEulerFirst)
{
  const Deviator first = test::random_deviator(9, 1.0), second = test::random_deviator(10, 1.0);
  const auto final_stress = [&](double end, int steps)
  {
    Point<LinearHardening> point{{1.0, 2.0}, chaboche, end};
    for (int i = 0; i < steps; ++i) // a quarter turn of the direction of strain
    {
      const double angle = 0.5 * std::numbers::pi * (i + 0.5) / steps;
      point.strain_by((0.06 / steps) * (std::cos(angle) * first + std::sin(angle) * second));
    }
    return point.stress;
  };
  const Deviator limit = final_stress(0.5, 20000);
  std::vector<double> path, euler;
  for (const int steps : {40, 80, 160})
  {
    path.push_back(von_mises(final_stress(0.5, steps) - limit));
    euler.push_back(von_mises(final_stress(1.0, steps) - limit));
  }
  EXPECT_NEAR(test::Orders("path", path).last, 2.0, 0.3);
  EXPECT_NEAR(test::Orders("backward Euler", euler).last, 1.0, 0.3);
}

} // namespace
} // namespace brinell::constitutive::kinematic_return_test
