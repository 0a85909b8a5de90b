// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/constitutive/return_mapping.hpp"

#include "constitutive/lane_return.hpp"
#include "order.hpp"
#include "random_field.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace brinell::constitutive::return_mapping_test
{
namespace
{

constexpr double mu = 76.0; // in units of the yield stress about: metals have mu/S_y = 50 to 500
constexpr PerfectPlasticity perfect{1.0};
constexpr LinearHardening hardening{1.0, 20.0};

// A Newton iteration stops at 1e-13 of the yield stress; strains are stresses over 2 mu.
constexpr double tolerance = 1e-12;

bool is_finite(const PlasticIncrement& p)
{
  bool finite = std::isfinite(p.equivalent) && std::isfinite(p.dissipation);
  for (int c = 0; c < Deviator::size; ++c)
    finite = finite && std::isfinite(p.strain[c]);
  return finite;
}

Deviator stress_after(const Deviator& q, const PlasticIncrement& p)
{
  return q - (2.0 * mu) * p.strain;
}

double equivalent_of(const Deviator& strain)
{
  return std::sqrt(contract(strain, strain) / 1.5);
}

TEST(ReturnMappingTest, InsideTheYieldSurfaceNothingFlows)
{
  for (unsigned seed = 0; seed < 50; ++seed)
  {
    const Deviator q = test::random_deviator(seed, 0.999), s0 = test::random_deviator(seed + 100, 0.5);
    for (const PlasticIncrement& p : {radial_return(q, 0.0, mu, perfect), path_return(s0, q, 0.0, mu, hardening)})
    {
      EXPECT_EQ(von_mises(p.strain), 0.0);
      EXPECT_EQ(p.equivalent, 0.0);
      EXPECT_EQ(p.dissipation, 0.0);
    }
  }
}

TEST(ReturnMappingTest, StressAfterFlowLiesOnTheYieldSurface)
{
  const auto check = [](const auto& law)
  {
    for (unsigned seed = 0; seed < 300; ++seed)
    {
      const double e = 0.01 * (seed % 7), yield = law.yield_stress_at(e);
      const double far = std::pow(10.0, 0.01 * seed - 1.0); // up to a trial 100 times beyond yield
      const Deviator s0 = test::random_deviator(seed, yield * (seed % 11) / 10.0);
      const Deviator q = test::random_deviator(seed + 1000, yield * (1.0 + far));
      for (const PlasticIncrement& p : {radial_return(q, e, mu, law), path_return(s0, q, e, mu, law)})
      {
        ASSERT_TRUE(is_finite(p)) << seed;
        const double after = law.yield_stress_at(e + p.equivalent);
        // The stress is the difference of two values of size |q|.
        EXPECT_NEAR(von_mises(stress_after(q, p)), after, tolerance * von_mises(q)) << seed;
        EXPECT_GT(p.equivalent, 0.0);
        EXPECT_GT(p.dissipation, 0.0);
      }
    }
  };
  check(perfect);
  check(hardening);
  check(SwiftHardening{2.0, 0.01, 0.15});
  check(hollomon(1.0, 2.0, 0.2));
  check(LudwikHardening{1.0, 1.1, 0.3}); // infinitely steep at the start
  check(LudwikHardening{1.0, 5.0, 0.2});
  check(VoceHardening{1.0, 0.5, 300.0});
  check(TabulatedHardening({0.0, 0.001, 0.002, 0.1}, {1.0, 1.01, 1.3, 1.4})); // steeper in the middle: not concave
}

/// A law of a user: the yield stress rises with the square root of a quadratic. Three members are all it takes.
struct UserLaw
{
  [[nodiscard]] double yield_stress_at(double e) const { return std::sqrt(1.0 + 40.0 * e); }
  [[nodiscard]] double modulus_at(double e) const { return 20.0 / yield_stress_at(e); }
  [[nodiscard]] double work(double e) const { return (std::pow(yield_stress_at(e), 3) - 1.0) / 60.0; }
};

TEST(ReturnMappingTest, TakesALawOfAUser)
{
  // Proportional loading: |q| - 3 mu de = sqrt(1 + 40 (e + de)), a quadratic equation in de.
  const double e = 0.003, size = 2.5, a = 9.0 * mu * mu, b = -(6.0 * mu * size + 40.0),
               c = size * size - 1.0 - 40.0 * e;
  const double de = (-b - std::sqrt(b * b - 4.0 * a * c)) / (2.0 * a);
  const Deviator q = test::random_deviator(8, size);
  EXPECT_NEAR(radial_return(q, e, mu, UserLaw{}).equivalent, de, tolerance / mu);
  EXPECT_NEAR(path_return((0.5 / size) * q, q, e, mu, UserLaw{}).equivalent, de, tolerance / mu);
}

TEST(ReturnMappingTest, UniaxialCurveOfEveryLawIsFollowed)
{
  // Loading in many steps along one direction follows the law itself: stress = sigma_y(e), work = its integral.
  const auto check = [](const auto& law)
  {
    const Deviator direction = test::random_deviator(12, 1.0);
    double e = 0.0, work = 0.0, stress = law.yield_stress_at(0.0);
    const int steps = 400;
    for (int i = 0; i < steps; ++i)
    {
      const double trial = stress + 3.0 * mu * 0.1 / steps;
      const PlasticIncrement p = path_return(stress * direction, trial * direction, e, mu, law);
      e += p.equivalent;
      work += p.dissipation;
      stress = von_mises(stress_after(trial * direction, p));
      ASSERT_NEAR(stress, law.yield_stress_at(e), 1e-11 * stress);
    }
    EXPECT_GT(e, 0.05);
    // The step's work is that of the mean stress: second order, less where the law is infinitely steep at its start.
    EXPECT_NEAR(work, law.work(e), 2e-4 * law.work(e));
  };
  check(perfect);
  check(hardening);
  check(SwiftHardening{2.0, 0.01, 0.15});
  check(hollomon(1.0, 2.0, 0.2));
  check(LudwikHardening{1.0, 1.1, 0.3});
  check(VoceHardening{1.0, 0.5, 30.0});
  check(TabulatedHardening({0.0, 0.001, 0.002, 0.1}, {1.0, 1.01, 1.3, 1.4}));
}

TEST(ReturnMappingTest, UniaxialHardeningIsExact)
{
  // Proportional loading: 3 mu de + H de = |q| - sigma_y(e), flow along q, work under the straight hardening line.
  const double e = 0.02, yield = hardening.yield_stress_at(e);
  for (const double size : {1.0001 * yield, 1.5 * yield, 10.0 * yield})
  {
    const Deviator q = test::random_deviator(3, size), s0 = (0.4 * yield / size) * q;
    const double de = (size - yield) / (3.0 * mu + hardening.modulus);
    const double work = (yield + 0.5 * hardening.modulus * de) * de;
    const PlasticIncrement radial = radial_return(q, e, mu, hardening), path = path_return(s0, q, e, mu, hardening);
    for (const PlasticIncrement& p : {radial, path})
    {
      EXPECT_NEAR(p.equivalent, de, tolerance * size / mu);
      EXPECT_NEAR(p.dissipation, work, tolerance * size * size / mu);
      EXPECT_NEAR(von_mises(p.strain - (1.5 * de / size) * q), 0.0, tolerance * size / mu);
    }
  }
}

TEST(ReturnMappingTest, EquivalentStrainIsThatOfTheRadialStrain)
{
  const PlasticIncrement p = radial_return(test::random_deviator(5, 3.0), 0.0, mu, hardening);
  EXPECT_NEAR(equivalent_of(p.strain), p.equivalent, tolerance / mu);
}

/// Stress at the end of a straight trial path, integrated in `steps` increments.
template <typename Step>
Deviator integrated(const Deviator& s0, const Deviator& q, int steps, Step step)
{
  Deviator s = s0;
  double e = 0.0;
  for (int n = 0; n < steps; ++n)
  {
    const Deviator trial = s + (1.0 / steps) * (q - s0);
    const PlasticIncrement p = step(s, trial, e);
    s = trial - (2.0 * mu) * p.strain;
    e += p.equivalent;
  }
  return s;
}

TEST(ReturnMappingTest, TurningTrialIsSecondOrderByPathAndFirstOrderByRadialReturn)
{
  // From the yield surface, the trial goes on at 70 degrees to the stress: the flow direction turns on the way.
  const auto check = [](const char* name, const auto& law)
  {
    const Deviator s0{{2.0 / 3.0, -1.0 / 3.0, 0.0, 0.0, 0.0}}; // uniaxial, von Mises 1
    const double turn = 70.0 * std::numbers::pi / 180.0;
    const Deviator along = s0, across{{0.0, 0.0, 0.0, 0.0, 1.0 / std::sqrt(3.0)}};
    const Deviator q = s0 + 2.0 * (std::cos(turn) * along + std::sin(turn) * across);
    const auto path = [&](const Deviator& s, const Deviator& trial, double e)
    { return path_return(s, trial, e, mu, law); };
    const auto radial = [&](const Deviator& /*s*/, const Deviator& trial, double e)
    { return radial_return(trial, e, mu, law); };
    const Deviator exact = integrated(s0, q, 20000, path);
    std::vector<double> path_errors, radial_errors;
    for (const int steps : {4, 8, 16, 32})
    {
      path_errors.push_back(von_mises(integrated(s0, q, steps, path) - exact));
      radial_errors.push_back(von_mises(integrated(s0, q, steps, radial) - exact));
    }
    EXPECT_NEAR(test::Orders((std::string("path return, ") + name).c_str(), path_errors).last, 2.0, 0.15);
    EXPECT_NEAR(test::Orders((std::string("radial return, ") + name).c_str(), radial_errors).last, 1.0, 0.15);
    EXPECT_LT(path_errors.front(), radial_errors.front());
  };
  check("perfect", perfect);
  check("hardening", hardening);
}

TEST(ReturnMappingTest, PathReturnsFromOutsideMeetTheLimitOfASmallStep)
{
  // A step that begins inside and just reaches yield: as many elastic parts as one likes in front change nothing.
  const Deviator s0 = test::random_deviator(1, 0.2), q = test::random_deviator(2, 1.4);
  const PlasticIncrement whole = path_return(s0, q, 0.0, mu, hardening);
  const Deviator later = s0 + 0.3 * (q - s0); // still inside
  ASSERT_LT(von_mises(later), 1.0);
  const PlasticIncrement rest = path_return(later, q, 0.0, mu, hardening);
  EXPECT_NEAR(von_mises(whole.strain - rest.strain), 0.0, tolerance / mu);
  EXPECT_NEAR(whole.dissipation, rest.dissipation, tolerance / mu);
}

TEST(ReturnMappingTest, ExtremeTrialsAreFinite)
{
  const auto check = [](const auto& law)
  {
    const Deviator s0 = test::random_deviator(7, 1.0);
    const Deviator outside = (1.0 + 1e-4) * s0; // a stress of the last increment, by its tolerance beyond yield
    const Deviator off = test::random_deviator(8, 1e-9);
    const std::array<std::pair<Deviator, Deviator>, 9> cases{{{s0, -3.0 * s0}, // reversal through the elastic domain
                                                              {s0, -1.0000001 * s0},    // ... that hardly yields
                                                              {outside, outside},       // nothing happens, outside
                                                              {outside, 1.00001 * s0},  // moves inwards, still outside
                                                              {outside, outside + off}, // hardly moves
                                                              {outside, -2.0 * s0},
                                                              {s0, 1e6 * s0},
                                                              {s0, 1e6 * test::random_deviator(9, 1.0)},
                                                              {Deviator{}, 1.0000000001 * s0}}};
    for (std::size_t n = 0; n < cases.size(); ++n)
    {
      const auto& [start, q] = cases[n];
      const PlasticIncrement p = path_return(start, q, 0.0, mu, law);
      ASSERT_TRUE(is_finite(p)) << "case " << n;
      EXPECT_GE(p.dissipation, 0.0) << "case " << n;
      EXPECT_GE(p.equivalent, 0.0) << "case " << n;
      EXPECT_NEAR(von_mises(stress_after(q, p)), law.yield_stress_at(p.equivalent), tolerance * von_mises(q))
          << "case " << n;
    }
  };
  check(perfect);
  check(hardening);
}

TEST(ReturnMappingTest, ReversalFlowsOnlyOnTheFarSide)
{
  // From s0 on the surface to -3 s0: elastic until -s0, then proportional.
  const Deviator s0 = test::random_deviator(7, 1.0);
  const PlasticIncrement p = path_return(s0, -3.0 * s0, 0.0, mu, perfect);
  EXPECT_NEAR(p.equivalent, 2.0 / (3.0 * mu), tolerance / mu);
  EXPECT_NEAR(von_mises(p.strain + (1.0 / mu) * s0), 0.0, tolerance / mu);
}

TEST(ReturnMappingTest, UnitOfStressDoesNotMatter)
{
  const Deviator s0 = test::random_deviator(11, 0.7), q = test::random_deviator(12, 2.5);
  const double unit = 9.115e8; // Pa
  const PlasticIncrement a = path_return(s0, q, 0.01, mu, hardening);
  const PlasticIncrement b =
      path_return(unit * s0, unit * q, 0.01, unit * mu, LinearHardening{unit * 1.0, unit * hardening.modulus});
  EXPECT_NEAR(von_mises(a.strain - b.strain), 0.0, tolerance / mu);
  EXPECT_NEAR(a.dissipation, b.dissipation / unit, tolerance / mu);
}

/// The text of lanes with a double instead, as a CUDA thread has it. The compiler contracts products and sums in other places, so
/// that the last digits differ.
void expect_same_as_number(const PlasticIncrement& in_lanes, const Deviator& before, const Deviator& q,
                           double yield_stress, double slope)
{
  PointsOf<double> point;
  point.start = before.v;
  point.trial = q.v;
  point.yield = yield_stress;
  point.modulus = slope;
  const bool outside = is_outside(point);
  path_return(point, mu);
  EXPECT_EQ(outside, in_lanes.equivalent > 0.0);
  constexpr double rounding = 1e-13;
  for (std::size_t c = 0; c < point.strain.size(); ++c)
    EXPECT_NEAR(point.strain[c], in_lanes.strain.v[c], rounding);
  EXPECT_NEAR(point.equivalent, in_lanes.equivalent, rounding);
  EXPECT_NEAR(point.dissipation, in_lanes.dissipation, rounding);
}

/// Points that flow and others, a virgin one among them, from paths in all directions.
template <typename Law>
void expect_lanes_like_points(const Law& law)
{
  constexpr unsigned kinds = 8;
  const auto stress = [](unsigned point)
  {
    const unsigned kind = point % kinds;
    return kind == 3 ? Deviator{} : test::random_deviator(point - kind + 40, 0.1 * kind);
  };
  const auto trial = [](unsigned point) { return test::random_deviator(point, 0.45 * (point % kinds + 1)); };
  const auto equivalent = [](unsigned point) { return 0.01 * (point % kinds); };
  for (unsigned first = 0; first < 400; first += lane_count)
  {
    LanePoints points;
    for (unsigned lane = 0; lane < lane_count; ++lane)
      points.set(lane, stress(first + lane), trial(first + lane), law.yield_stress_at(equivalent(first + lane)),
                 law.modulus_at(equivalent(first + lane)));
    const auto outside = is_outside(points);
    path_return(points, mu);
    for (unsigned lane = 0; lane < lane_count; ++lane)
    {
      const unsigned point = first + lane;
      const PlasticIncrement alone = path_return(stress(point), trial(point), equivalent(point), mu, law);
      const PlasticIncrement here = points.increment(lane);
      EXPECT_EQ(here.equivalent > 0.0, alone.equivalent > 0.0);
      EXPECT_EQ(outside[lane] != 0, alone.equivalent > 0.0);
      EXPECT_NEAR(von_mises(here.strain - alone.strain), 0.0, tolerance / mu);
      EXPECT_NEAR(here.equivalent, alone.equivalent, tolerance / mu);
      EXPECT_NEAR(here.dissipation, alone.dissipation, tolerance / mu);
      expect_same_as_number(here, stress(point), trial(point), law.yield_stress_at(equivalent(point)),
                            law.modulus_at(equivalent(point)));
    }
  }
}

TEST(ReturnMappingTest, PointsInLanesFlowAsEachByItself)
{
  expect_lanes_like_points(perfect);
  expect_lanes_like_points(hardening);
  expect_lanes_like_points(LinearHardening{1.0, 10.0 * mu}); // stiffer than elastic
}

} // namespace
} // namespace brinell::constitutive::return_mapping_test
