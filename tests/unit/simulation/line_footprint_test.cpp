// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/halfspace/surface_compliance.hpp"
#include "brinell/simulation/run.hpp"
#include "brinell/simulation/tugging.hpp"
#include "domain_cases.hpp"
#include "simulation/plan/footprint.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

/// Plans of contact in a line, in plane strain.
namespace brinell::simulation::line_footprint_test
{
namespace
{

using cases::approach;
using cases::cylinder;
using cases::load;
using cases::steel;

constexpr double pi = std::numbers::pi;
constexpr double R = cases::radius;

double modulus()
{
  return contact_modulus(steel, steel);
}

Footprint smooth(const IndentationCase& c)
{
  return smooth_footprint(c.lower, c.upper, c.sequence.front(), c.domain);
}

/// Load at which the half-width of the contact is b, per metre.
double load_at(double b)
{
  return pi * modulus() * b * b / (4.0 * R);
}

TEST(LineFootprint, LoadAndApproachAreThatOfTheLogarithm)
{
  const double l = 0.5e-3;
  for (const double b : {1e-6, 0.1e-3, 0.3e-3, 0.499e-3})
  {
    const double P = load_at(b);
    const double delta = P / (pi * modulus()) * (1.0 + 2.0 * std::log(2.0 * l / b));
    const Footprint by_load = smooth(cylinder(load(P), l));
    EXPECT_NEAR(by_load.half_x, b, 1e-12 * b);
    EXPECT_NEAR(by_load.approach, delta, 1e-12 * delta);
    EXPECT_NEAR(smooth(cylinder(approach(delta), l)).half_x, b, 1e-9 * b);
  }
}

TEST(LineFootprint, ARollerIsTheSameFromEitherSide)
{
  for (const double P : {1.0, 1e3, 1e5})
  {
    IndentationCase c = cylinder(load(P));
    c.domain = {};
    c.upper.shape = Roller{R, 5e-3};
    const Footprint by_load = smooth(c);
    const double b = std::sqrt(4.0 * P * R / (pi * 5e-3 * modulus()));
    EXPECT_NEAR(by_load.half_x, b, 1e-12 * b);
    EXPECT_TRUE(by_load.straight_y);
    c.sequence = {approach(by_load.approach)};
    EXPECT_NEAR(smooth(c).half_x, b, 1e-9 * b);
  }
}

TEST(LineFootprint, AnImposedApproachLimitsTheWidthOfAPlasticContact)
{
  // A soft body would spread under the load that an elastic one bears; what comes down by delta is no wider than its overlap.
  const double delta = 20e-6;
  IndentationCase c = cylinder(approach(delta));
  c.lower.material.hardening = constitutive::PerfectPlasticity{50e6};
  for (const bool plane : {true, false})
  {
    if (!plane)
    {
      c.domain = {};
      c.upper.shape = Roller{R, 5e-3};
    }
    EXPECT_LE(smooth(c).half_x, 1.2 * std::sqrt(2.0 * R * delta) * (1.0 + 1e-12));
    EXPECT_GE(smooth(c).half_x, smooth(c).elastic_x);
  }
}

TEST(LineFootprint, IsRefusedWhereItIsWiderThanTheReference)
{
  const double l = 0.2e-3;
  const double most = l * l / (4.0 * R) * (1.0 + 2.0 * std::log(2.0));
  EXPECT_NO_THROW(static_cast<void>(plan(cylinder(load(load_at(0.99 * l)), l))));
  EXPECT_NO_THROW(static_cast<void>(plan(cylinder(approach(0.99 * most), l))));
  expect_refused(cylinder(load(load_at(1.01 * l)), l), "grid.reference", "grid.reference = 0.0002 m is less than");
  expect_refused(cylinder(approach(1.01 * most), l), "grid.reference", "grid.reference = 0.0002 m: with it");
  // Of a row of balls, which tugging has estimates of its own for, as well.
  TuggingCase t;
  t.lower = t.upper = {Paraboloid{R, R}, {steel, {}}};
  t.interference = 10e-6;
  t.domain.y = {Boundary::periodic, 2e-3, 64};
  EXPECT_NO_THROW(static_cast<void>(plan(t)));
  t.domain.reference = 0.1e-3;
  expect_refused(t, "grid.reference", "grid.reference = 0.0001 m is less than the half-width of the contact");
}

TEST(LineFootprint, TheOperatorIsDefiniteUpToTwiceTheReference)
{
  // The pressure 1/sqrt(a^2 - x^2) sinks a strip of half-width a evenly, by 2/E' ln(2 l/a): no stiffness is left at a = 2 l,
  // where the approach of a cylinder is the largest. Mean over a cell, so that the strip is exact but for the cells' error.
  constexpr int n = 400;
  const auto work = [&](double a)
  {
    const SurfaceGrid g{n, 1, 2.0 * a / n, 1.0, Boundary::open, Boundary::periodic};
    std::vector<double> p(g.size()), u(g.size());
    for (int i = 0; i < n; ++i)
      p[static_cast<std::size_t>(i)] =
          (std::asin(std::min(1.0, 2.0 * (i + 1) / n - 1.0)) - std::asin(2.0 * i / n - 1.0)) / g.dx;
    const halfspace::SurfaceCompliance compliance(g, 1.0, 1.0); // E' = 1, l = 1
    auto scratch = compliance.make_scratch();
    compliance.apply({.pressure = p}, {.z = u}, scratch);
    double sum = 0.0;
    for (std::size_t i = 0; i < p.size(); ++i)
      sum += p[i] * u[i] * g.dx;
    return sum;
  };
  for (const double a : {0.5, 1.0, 1.9, 2.1, 4.0})
    EXPECT_NEAR(work(a), 2.0 * pi * std::log(2.0 / a), 0.05) << a; // of the cells, about 1/sqrt(n)
  EXPECT_GT(work(1.95), 0.0);
  EXPECT_LT(work(2.05), 0.0);
}

TEST(LineFootprint, InAPeriodTheApproachCountsFromTheMeanPlane)
{
  IndentationCase c = cylinder(load(0.3e6));
  const double period = 4e-3;
  c.domain.x = {Boundary::periodic, period, 1024};
  c.domain.layer = 0.1e-3;
  c.steps = 1;
  const IndentationPlan p = plan(c);
  double found = 0.0;
  Observer<IndentationRecord> observer;
  observer.on_step = [&](const IndentationRecord& r, int) { found = r.approach; };
  static_cast<void>(run(c, observer));
  EXPECT_GT(found, 0.0);
  EXPECT_NEAR(p.scales.gap, found, 0.01 * found); // lines beside each other, of (b/period)^2; and the cells
  // Beyond full contact nothing is left to estimate, but the plan still holds.
  c.sequence = {load(1e8)};
  EXPECT_GT(plan(c).scales.gap, 0.0);
  EXPECT_TRUE(std::isfinite(plan(c).scales.gap));
}

} // namespace
} // namespace brinell::simulation::line_footprint_test
