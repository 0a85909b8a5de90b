// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/io/member_keys.hpp"
#include "brinell/quality/quality.hpp"
#include "brinell/reference/hertz.hpp"
#include "brinell/reference/sliding_contact.hpp"
#include "brinell/simulation/first_yield.hpp"
#include "brinell/simulation/indentation.hpp"
#include "brinell/simulation/rolling.hpp"
#include "sphere_pairs.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <string>

/// When a pair of bodies begins to yield.
namespace brinell::simulation::first_yield_test
{
namespace
{

TEST(FirstYield, OfAHardenedLayerIsThatOfItsCoreInEveryScenario)
{
  // The yield stress is that of the surface; below the layer it is half of it.
  TuggingCase t = spheres(4.0);
  for (ShapedBody* body : {&t.lower, &t.upper})
    body->material.yield_factor = constitutive::DepthProfile({5e-3, 10e-3}, {1.0, 0.5});
  IndentationCase i;
  i.lower = t.lower;
  i.upper = t.upper;
  i.sequence = {{contact::Drive::Kind::approach, t.interference}};
  const double of_core = 0.25 * critical_interference; // the approach goes with the square of the pressure
  EXPECT_NEAR(plan(t).scales.displacement, of_core, 1e-5 * of_core);
  EXPECT_NEAR(plan(i).scales.displacement, of_core, 1e-5 * of_core);
  // The units of the paper stay those of the nominal yield stress.
  EXPECT_EQ(nominal_yield(t.lower.material, t.upper.material, ContactKind::point)->yield_stress, 0.9115e9);
  EXPECT_EQ(earliest_yield(t.lower.material, t.upper.material, ContactKind::point, 0.0)->yield_stress, 0.5 * 0.9115e9);
  EXPECT_NEAR(nominal_first_yield(t.lower, t.upper, t.domain)->critical.interference, critical_interference, 1e-10);
  EXPECT_NEAR(earliest_first_yield(t.lower, t.upper, t.domain, 0.0)->critical.interference, of_core, 1e-10);
  // A layer that is hard throughout yields late.
  t.lower.material.yield_factor = t.upper.material.yield_factor = constitutive::DepthProfile({0.0}, {1.2});
  EXPECT_NEAR(plan(t).scales.displacement, 1.44 * critical_interference, 1e-5 * critical_interference);
}

TEST(FirstYield, UnderFrictionDoesNotTightenTheToleranceOfTheDisplacement)
{
  TuggingCase t = spheres(4.0);
  RollingCase r;
  r.lower = t.lower;
  r.upper = t.upper;
  r.lower.shape = Plane{};
  r.drive = {contact::Drive::Kind::approach, t.interference};
  r.distance = 10e-3;
  r.slide_to_roll = 0.2;
  const auto yield_of = [](const auto& c)
  { return earliest_first_yield(c.lower, c.upper, c.domain, c.friction.coefficient)->critical.interference; };
  const auto check = [&](auto c)
  {
    const double frictionless = yield_of(c);
    EXPECT_NEAR(plan(c).scales.displacement / frictionless, 1.0, 1e-9);
    EXPECT_NEAR(plan(c).first_yield / frictionless, 1.0, 1e-9);
    c.friction.coefficient = 0.4;
    EXPECT_LT(yield_of(c), 0.7 * frictionless); // Hamilton (1983): at the surface
    EXPECT_NEAR(plan(c).scales.displacement / frictionless, 1.0, 1e-9);
    EXPECT_NEAR(plan(c).first_yield / yield_of(c), 1.0, 1e-9);
  };
  check(t);
  check(r);
}

TEST(FirstYield, IsThatOfTheWeakerBody)
{
  const constitutive::Material weak{{200e9, 0.3}, constitutive::PerfectPlasticity{0.5e9}};
  const constitutive::Material strong{{200e9, 0.3}, constitutive::PerfectPlasticity{1e9}};
  const constitutive::Material elastic{{200e9, 0.3}, {}};
  for (const ContactKind kind : {ContactKind::point, ContactKind::line})
  {
    const auto of = [kind](const auto& lower, const auto& upper) { return nominal_yield(lower, upper, kind); };
    EXPECT_EQ(of(weak, strong)->body, YieldsFirst::lower);
    EXPECT_EQ(of(strong, weak)->body, YieldsFirst::upper);
    EXPECT_EQ(of(weak, weak)->body, YieldsFirst::both);
    EXPECT_EQ(of(elastic, weak)->body, YieldsFirst::upper);
    EXPECT_FALSE(of(elastic, elastic).has_value());
    EXPECT_EQ(of(elastic, weak)->peak_pressure(), of(weak, weak)->peak_pressure());
  }
  // From nu = 0 to 0.3, C grows from 1 to 1.79 of a line, and from 1.30 to 1.61 only of a point.
  const constitutive::Material at_zero{{200e9, 0.0}, constitutive::PerfectPlasticity{0.7e9}};
  EXPECT_EQ(nominal_yield(at_zero, weak, ContactKind::point)->body, YieldsFirst::upper);
  EXPECT_EQ(nominal_yield(at_zero, weak, ContactKind::line)->body, YieldsFirst::lower);
}

/// Two cylinders of 1 m and 3 m in plane strain.
TuggingCase cylinders()
{
  TuggingCase t = spheres(1.0);
  t.lower.shape = Roller{1.0, std::numeric_limits<double>::infinity()};
  t.upper.shape = Roller{3.0, std::numeric_limits<double>::infinity()};
  t.domain.y = {Boundary::periodic, 2.0, 1};
  return t;
}

TEST(FirstYield, OfCylindersInPlaneStrainIsThatOfTheirLineContact)
{
  TuggingCase t = cylinders();
  const auto yield = nominal_first_yield(t.lower, t.upper, t.domain);
  ASSERT_TRUE(yield);
  const double modulus = contact_modulus(t.lower.material.elastic, t.upper.material.elastic);
  const double C = reference::line_contact_first_yield(0.32).pressure_ratio;
  const reference::Line line{2.0, 2.0 * 0.75 / std::numbers::e};
  const auto critical = reference::critical_values(0.75, modulus, C, 0.9115e9, line);
  EXPECT_NEAR(yield->critical.interference / critical.interference, 1.0, 1e-14);
  EXPECT_NEAR(yield->critical.load / critical.load, 1.0, 1e-14);
  EXPECT_NEAR(yield->critical.energy / critical.energy, 1.0, 1e-14);
  // The approach counts from the reference of the case, and the plan's own first yield is the same.
  t.domain.reference = 0.2;
  const double alpha_c = nominal_first_yield(t.lower, t.upper, t.domain)->critical.interference;
  EXPECT_NEAR(alpha_c / reference::critical_values(0.75, modulus, C, 0.9115e9, {2.0, 0.2}).interference, 1.0, 1e-14);
  t.interference = 3.0 * alpha_c;
  EXPECT_NEAR(plan(t).scales.displacement, alpha_c, 1e-9 * alpha_c);
  t.interference = alpha_c * (1.0 - 1e-9);
  EXPECT_EQ(quality::expected(t, plan(t)).warnings.front().key, "no_yield");
}

TEST(FirstYield, HasAReasonWhereItIsNotInClosedForm)
{
  const auto reason = [](const TuggingCase& t)
  { return io::with_keys(reason_against_first_yield(t.lower, t.upper, t.domain).value_or("none")); };
  TuggingCase t = cylinders();
  EXPECT_EQ(reason(t), "none");
  t.domain.reference = 1e-3; // a_c is 22 mm
  EXPECT_EQ(reason(t), "grid.reference = 0.001 m is too short compared with the contact at first yield");
  EXPECT_FALSE(nominal_first_yield(t.lower, t.upper, t.domain));
  EXPECT_FALSE(earliest_first_yield(t.lower, t.upper, t.domain, 0.0));
  t = cylinders();
  t.upper.shape = Roller{3.0, 0.5}; // shorter than the period
  EXPECT_NE(reason(t).find("nor cylinders in plane strain"), std::string::npos) << reason(t);
  t = cylinders();
  t.lower.shape = t.upper.shape = Roller{1.0, 0.5};
  t.domain = {};
  EXPECT_NE(reason(t).find("nor cylinders in plane strain"), std::string::npos) << reason(t);
  t = cylinders();
  t.lower.material.hardening = t.upper.material.hardening = {};
  EXPECT_EQ(reason(t), "neither body can yield");
}

TEST(FirstYield, WithLayersIsThatOfTheWeakestPart)
{
  TuggingCase t = spheres(4.0);
  EXPECT_FALSE(coated_yield(t.lower, t.upper, t.domain)) << "no layers";
  const double a_c = nominal_first_yield(t.lower, t.upper, t.domain)->critical.contact_radius;
  // Layers of the body's own material change nothing.
  t.lower.material.layers = {{0.3 * a_c, t.lower.material.elastic, t.lower.material.hardening},
                             {0.2 * a_c, t.lower.material.elastic, t.lower.material.hardening}};
  const auto same = coated_yield(t.lower, t.upper, t.domain);
  ASSERT_TRUE(same);
  EXPECT_NEAR(same->approach / critical_interference, 1.0, 5e-3)
      << "its stress is right to 0.5 %, the fit of C to 0.15 %";
  // Half of the yield stress at the depth of the largest stress: a quarter of the approach, as if all were as weak.
  t.lower.material.layers[1].hardening = constitutive::PerfectPlasticity{0.5 * 0.9115e9};
  t.lower.material.layers[0].hardening = constitutive::PerfectPlasticity{0.5 * 0.9115e9};
  const auto weak = coated_yield(t.lower, t.upper, t.domain);
  ASSERT_TRUE(weak);
  EXPECT_NEAR(weak->approach / critical_interference, 0.25, 2e-3);
  EXPECT_LT(weak->place.layer, 2U);
  EXPECT_FALSE(weak->in_upper);
  // The yield profile of the body holds for its layers.
  t.lower.material.yield_factor = constitutive::DepthProfile({0.0}, {2.0});
  EXPECT_NEAR(coated_yield(t.lower, t.upper, t.domain)->approach / critical_interference, 1.0, 5e-3);
  // Not for lines, nor without a law.
  TuggingCase line = cylinders();
  line.lower.material.layers = t.lower.material.layers;
  EXPECT_FALSE(coated_yield(line.lower, line.upper, line.domain));
  for (auto& layer : t.lower.material.layers)
    layer.hardening.reset();
  t.lower.material.hardening = t.upper.material.hardening = std::nullopt;
  EXPECT_FALSE(coated_yield(t.lower, t.upper, t.domain));
}

TEST(FirstYield, ComesSoonerWithFriction)
{
  const TuggingCase t = spheres(4.0);
  const double without = earliest_first_yield(t.lower, t.upper, t.domain, 0.0)->critical.interference;
  const double with = earliest_first_yield(t.lower, t.upper, t.domain, 0.4)->critical.interference;
  const double C = reference::critical_pressure_ratio(t.lower.material.elastic.poisson_ratio);
  const double sliding = reference::sliding_first_yield(t.lower.material.elastic.poisson_ratio, 0.4).pressure_ratio;
  EXPECT_NEAR(with / without, std::pow(sliding / C, 2),
              1e-12); // Hertz: the approach goes as the square of the pressure
  EXPECT_LT(with, 0.7 * without);
}

} // namespace
} // namespace brinell::simulation::first_yield_test
