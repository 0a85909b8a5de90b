// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/contact/elastic_contact.hpp"
#include "brinell/foundation/deviator.hpp"
#include "brinell/foundation/error.hpp"
#include "brinell/green/stack.hpp"
#include "brinell/halfspace/half_space.hpp"
#include "brinell/reference/coated_contact.hpp"
#include "brinell/reference/critical.hpp"
#include "brinell/reference/hertz.hpp"

#include "reference/spherical_bessel.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace brinell::reference::coated_contact_test
{
namespace
{

constexpr double inf = std::numeric_limits<double>::infinity();
constexpr double radius = 1e-3, a = 1e-5;
const Elastic steel{210e9, 0.3};
const ElasticStack substrate{{}, steel};
const ElasticStack rigid{{}, {inf, 0.0}};

ElasticStack coated(double thickness, double modulus, double poisson_ratio = 0.25)
{
  return {{{thickness, {modulus, poisson_ratio}}}, steel};
}

PointContact hertz(const Elastic& lower, const Elastic& upper)
{
  return point_contact_at_approach(radius, contact_modulus(lower, upper), a * a / radius);
}

double pressure_of(const PointContact& contact, double r)
{
  return contact.peak_pressure * std::sqrt(1.0 - r * r / (contact.contact_radius * contact.contact_radius));
}

TEST(SphericalBesselTest, AreThoseOfTheStandardLibrary)
{
  for (const double x : {0.0, 1e-9, 1e-3, 0.7, 3.141592653589793, 12.0, 40.0, 41.0, 700.0})
  {
    std::array<double, 40> j{};
    spherical_bessel(x, j);
    for (unsigned n = 0; n < j.size(); ++n)
      EXPECT_NEAR(j[n], std::sph_bessel(n, x), 1e-13) << n << " of " << x;
  }
}

TEST(CoatedContactTest, LayersOfTheSubstrateAreHertz)
{
  for (const ElasticStack& lower : {substrate, coated(0.3 * a, 210e9, 0.3)})
    for (const ElasticStack& upper : {rigid, ElasticStack{{}, {70e9, 0.2}}})
    {
      const CoatedContact contact(radius, a, lower, upper);
      const PointContact h = hertz(steel, upper.substrate);
      EXPECT_NEAR(contact.load() / h.load, 1.0, 1e-14);
      EXPECT_NEAR(contact.approach() / h.approach, 1.0, 1e-14);
      for (const double r : {0.0, 0.5 * a, 0.999 * a})
        EXPECT_NEAR(contact.pressure(r) / pressure_of(h, r), 1.0, 1e-12);
      EXPECT_EQ(contact.pressure(a), 0.0);
      // integral_0^a p0 sqrt(1 - r^2/a^2) J0(k r) r dr = p0 a^2 (sin x - x cos x)/x^3 with x = k a.
      const double k = 3.7 / a, x = k * a;
      EXPECT_NEAR(contact.wave_of_pressure(k) /
                      (h.peak_pressure * a * a * (std::sin(x) - x * std::cos(x)) / (x * x * x)),
                  1.0, 1e-12);
    }
}

/// The load grows with the approach by the stiffness of a flat punch of the present contact radius, whatever the layers are.
TEST(CoatedContactTest, StiffnessIsThatOfAFlatPunch)
{
  for (const double thickness : {10.0 * a, a, 0.1 * a, 0.03 * a})
    for (const double modulus : {2.1e9, 21e9, 420e9, 21e12})
    {
      const ElasticStack lower = coated(thickness, modulus);
      const CoatedContact contact(radius, a, lower, rigid);
      const auto at = [&](double factor) { return CoatedContact(radius, factor * a, lower, rigid); };
      constexpr double h = 3e-4;
      // Fourth order of central differences, of which the error is far below.
      const auto slope = [&](double s)
      { return (at(1.0 + s).load() - at(1.0 - s).load()) / (at(1.0 + s).approach() - at(1.0 - s).approach()); };
      EXPECT_NEAR((4.0 * slope(h) - slope(2.0 * h)) / 3.0 / contact.stiffness(), 1.0, 1e-9) << thickness / a << modulus;
    }
}

TEST(CoatedContactTest, LoadIsTheSumOfThePressure)
{
  for (const double thickness : {a, 0.1 * a, 0.03 * a})
    for (const double modulus : {2.1e9, 2.1e12})
    {
      const CoatedContact contact(radius, a, coated(thickness, modulus), rigid);
      double load = 0.0;
      constexpr int points = 400;
      for (int i = 0; i < points; ++i)
      {
        const double u = (i + 0.5) / points; // r = a sqrt(1 - u^2), where the pressure is smooth in u
        load += 2.0 * std::numbers::pi * a * a * u / points * contact.pressure(a * std::sqrt(1.0 - u * u));
      }
      EXPECT_NEAR(load / contact.load(), 1.0, 2e-5) << thickness / a << " " << modulus;
      EXPECT_NEAR(2.0 * std::numbers::pi * contact.wave_of_pressure(0.0) / contact.load(), 1.0, 1e-14);
    }
}

TEST(CoatedContactTest, ThickLayersAreTheBody)
{
  for (const double modulus : {21e9, 2.1e12})
  {
    const PointContact of_layer = hertz({modulus, 0.25}, rigid.substrate);
    // What the substrate adds within the circle decays as (a/t)^3 but for a rigid displacement.
    EXPECT_NEAR(CoatedContact(radius, a, coated(10.0 * a, modulus), rigid).load() / of_layer.load, 1.0, 2e-3);
    EXPECT_NEAR(CoatedContact(radius, a, coated(40.0 * a, modulus), rigid).load() / of_layer.load, 1.0, 2e-3 / 64.0);
  }
}

/// A thin layer changes the approach under a load in proportion to its thickness.
TEST(CoatedContactTest, ThinLayersAreHardlyThere)
{
  const PointContact bare = hertz(steel, rigid.substrate);
  for (const double modulus : {150e9, 300e9})
  {
    const auto change = [&](double thickness)
    {
      const ElasticStack lower = coated(thickness, modulus, 0.3);
      return CoatedContact::at_load(radius, bare.load, lower, rigid).approach() / bare.approach - 1.0;
    };
    const double thin = change(0.0225 * a), thicker = change(0.045 * a);
    EXPECT_LT(std::abs(thin), 0.025);
    EXPECT_NEAR(thin / thicker, 0.5, 0.03);
  }
}

TEST(CoatedContactTest, LoadOrApproachMayBeGiven)
{
  for (const double thickness : {10.0 * a, 0.3 * a, 0.05 * a})
    for (const double modulus : {20e9, 800e9})
    {
      const ElasticStack lower = coated(thickness, modulus);
      const CoatedContact contact(radius, a, lower, rigid);
      EXPECT_NEAR(CoatedContact::at_load(radius, contact.load(), lower, rigid).contact_radius() / a, 1.0, 1e-12);
      EXPECT_NEAR(CoatedContact::at_approach(radius, contact.approach(), lower, rigid).contact_radius() / a, 1.0,
                  1e-12);
    }
  // The first guess, a body of the soft coat alone, is wider than what can be resolved.
  for (const double ratio : {20.0, 40.0, 49.9})
  {
    const ElasticStack soft = coated(a / ratio, 2.1e9);
    const CoatedContact contact(radius, a, soft, rigid);
    EXPECT_NEAR(CoatedContact::at_load(radius, contact.load(), soft, rigid).contact_radius() / a, 1.0, 1e-11);
  }
  const ElasticStack soft = coated(a / 50.0, 2.1e9);
  const double most = CoatedContact(radius, a, soft, rigid).load();
  EXPECT_THROW(static_cast<void>(CoatedContact::at_load(radius, 2.0 * most, soft, rigid)), InputError);
}

/// Two spheres with layers of their own: displacements add up, whichever body is called the lower one.
TEST(CoatedContactTest, BothBodiesMayHaveLayers)
{
  const ElasticStack one = coated(0.2 * a, 50e9);
  const ElasticStack two{{{0.1 * a, {400e9, 0.2}}, {0.5 * a, {100e9, 0.35}}}, steel};
  const CoatedContact contact(radius, a, one, two), exchanged(radius, a, two, one);
  EXPECT_NEAR(exchanged.load() / contact.load(), 1.0, 1e-13);
  EXPECT_NEAR(exchanged.approach() / contact.approach(), 1.0, 1e-13);
  // Equal bodies share the displacement: half of the approach against a rigid plane, at the same pressure and twice the curvature.
  const CoatedContact equal(radius, a, two, two), half(2.0 * radius, a, two, rigid);
  EXPECT_NEAR(equal.load() / half.load(), 1.0, 1e-12);
  EXPECT_NEAR(equal.approach() / (2.0 * half.approach()), 1.0, 1e-12);
}

/// The solver on cells finds the same contact: convergence to a solution that knows no cells.
TEST(CoatedContactTest, IsWhatTheCellsConvergeTo)
{
  for (const ElasticStack& lower : {coated(0.5 * a, 21e9), coated(0.5 * a, 840e9)})
  {
    const CoatedContact exact(radius, a, lower, rigid);
    double coarse = 0.0;
    for (const int cells : {8, 16, 32})
    {
      const double d = a / cells;
      const int n = 2 * (cells + cells / 4) + 1;
      const SurfaceGrid grid{.nx = n, .ny = n, .dx = d, .dy = d};
      const halfspace::SurfaceCompliance compliance(grid, lower, rigid);
      std::vector<double> distance(grid.size()), pressure(grid.size(), 0.0), gap(grid.size());
      for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i)
        {
          const double x = (i - n / 2) * d, y = (j - n / 2) * d;
          distance[static_cast<std::size_t>(j * n + i)] = (x * x + y * y) / (2.0 * radius);
        }
      const contact::Report report =
          contact::ElasticContact(compliance)
              .solve(distance, {contact::Drive::Kind::load, exact.load()}, 1e-6 * exact.approach(), 200, pressure, gap);
      ASSERT_TRUE(report.converged);
      const double error = std::abs(report.approach / exact.approach() - 1.0);
      const double error_of_pressure = std::abs(pressure[grid.size() / 2] / exact.pressure(0.0) - 1.0);
      EXPECT_LT(error, 0.4 / (cells * cells)) << cells;
      EXPECT_LT(error_of_pressure, 0.1 / cells) << cells;
      if (cells == 32)
      {
        EXPECT_LT(error, 0.2 * coarse);
      }
      coarse = cells == 8 ? error : coarse;
    }
  }
}

/// The stress in layers of cells, from the operator of layered half spaces under the exact pressure.
TEST(CoatedContactTest, PeakStressIsThatOfTheCells)
{
  for (const ElasticStack& lower : {coated(0.5 * a, 70e9), coated(0.5 * a, 630e9)})
  {
    const CoatedContact exact(radius, a, lower, rigid);
    constexpr int cells = 12, n = 2 * (cells + 2) + 1;
    const double d = a / cells;
    const VolumeGrid grid{{.nx = n, .ny = n, .dx = d, .dy = d}, 2 * cells, d};
    std::vector<double> pressure(grid.surface.size());
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i)
        pressure[static_cast<std::size_t>(j * n + i)] = exact.pressure(std::hypot((i - n / 2) * d, (j - n / 2) * d));
    const halfspace::HalfSpace body(grid, lower);
    halfspace::HalfSpace::Work work = body.make_guest();
    std::array<double, 2>
        largest{}; // in the layer and in the substrate, without the cells at the surface and the interface
    std::vector<double> stress(6 * grid.surface.size());
    const double deep = 2.0 * d; // above, the stress changes within a cell
    for (int layer = 2; layer < grid.nz; ++layer)
    {
      body.stress_of_load({.pressure = pressure}, layer, work, stress);
      for (std::size_t cell = 0; cell < grid.surface.size(); ++cell)
      {
        const auto s = [&](std::size_t c) { return stress[c * grid.surface.size() + cell]; };
        const Deviator deviator{s(0), s(1), s(2), s(3), s(4)};
        double& to = largest[lower.layer_at((layer + 0.5) * d)];
        to = std::max(to, von_mises(deviator));
      }
    }
    for (std::size_t part = 0; part < 2; ++part)
    {
      const CoatedPeak peak =
          peak_stress(exact, lower,
                      [&](std::size_t layer, double depth)
                      { return layer == part && depth > deep && std::abs(depth - 0.5 * a) >= 0.5 * d ? 1.0 : inf; });
      EXPECT_EQ(peak.layer, part);
      EXPECT_NEAR(peak.ratio / largest[part], 1.0, 0.02);
    }
  }
}

TEST(CoatedYieldTest, WithoutLayersItIsHertz)
{
  const auto yield = coated_first_yield(radius, substrate, rigid, [](std::size_t, double) { return 1e9; }, {});
  ASSERT_TRUE(yield);
  const CriticalValues c =
      critical_values(radius, contact_modulus(steel, rigid.substrate), first_yield(0.3).pressure_ratio, 1e9);
  EXPECT_NEAR(yield->peak_pressure / c.peak_pressure, 1.0, 2e-3); // points of depth are 0.05 a apart
  EXPECT_NEAR(yield->load / c.load, 1.0, 6e-3);
  EXPECT_NEAR(yield->place.depth / yield->contact_radius, first_yield(0.3).depth_ratio, 0.03);
  EXPECT_FALSE(yield->in_upper);
}

TEST(CoatedYieldTest, TheWeakerPartYields)
{
  const ElasticStack lower = coated(a, 420e9);
  const auto with = [&](double of_layer, double of_substrate)
  {
    return coated_first_yield(
        radius, lower, substrate, [=](std::size_t layer, double) { return layer == 0 ? of_layer : of_substrate; },
        [](std::size_t, double) { return 8e9; });
  };
  EXPECT_EQ(with(1e9, 1e9)->place.layer, 0U);
  EXPECT_EQ(with(7e9, 1e9)->place.layer, 1U);
  EXPECT_DOUBLE_EQ(with(7e9, 1e9)->place.depth, a) << "bent most at the interface";
  EXPECT_TRUE(with(40e9, 20e9)->in_upper);
  // A layer that is all of the body as far as the contact is concerned.
  const double small = with(0.05e9, 1e9)->load;
  const CriticalValues alone =
      critical_values(radius, contact_modulus({420e9, 0.25}, steel), first_yield(0.25).pressure_ratio, 0.05e9);
  EXPECT_NEAR(small / alone.load, 1.0, 0.01);
}

/// A substrate beneath a thick coat that stays elastic, or is stronger, yields at the interface.
TEST(CoatedYieldTest, SubstratesYieldBeneathThickCoats)
{
  const auto at = [](double thickness, double of_layer, double of_substrate)
  {
    return coated_first_yield(radius, coated(thickness, 400e9, 0.2), rigid,
                              [=](std::size_t layer, double) { return layer == 0 ? of_layer : of_substrate; }, {});
  };
  double before = 0.0; // load
  for (double thickness = 1e-6; thickness < 80e-6; thickness *= 1.3)
  {
    const auto yield = at(thickness, inf, 2e9);
    ASSERT_TRUE(yield) << thickness;
    EXPECT_EQ(yield->place.layer, 1U);
    if (before > 0.0)
    {
      EXPECT_GT(yield->load, 0.85 * before) << "no jump from one thickness to the next";
      EXPECT_LT(yield->load, 2.0 * before);
    }
    before = yield->load;
  }
  // Deep beneath a small contact the stress is that of a point load: proportional to it, and no part of the pressure's width.
  const double thickness = 40e-6, weak = at(thickness, inf, 0.02e9)->load;
  EXPECT_NEAR(at(thickness, inf, 0.01e9)->load / weak, 0.5, 5e-3);
  EXPECT_EQ(at(2e-6, 15e9, 0.05e9)->place.layer, 1U) << "weaker by far, though the coat has more stress";
}

TEST(CoatedYieldTest, NothingYieldsThatIsStrongEnough)
{
  EXPECT_FALSE(coated_first_yield(radius, coated(a, 420e9), rigid, [](std::size_t, double) { return inf; }, {}));
  EXPECT_FALSE(coated_first_yield(radius, coated(a, 420e9), rigid, [](std::size_t, double) { return 1e13; }, {}));
}

// What quality tells of a worn coat: no contact changes by more than the wave that changes most.
TEST(CoatedContactTest, ChangesByLessThanTheComplianceOfItsWaves)
{
  for (const double modulus : {20e9, 70e9, 600e9, 2100e9})
    for (const double thickness : {0.1 * a, 0.5 * a, 2.0 * a})
      for (const double worn : {0.05, 0.4})
      {
        SCOPED_TRACE(testing::Message() << modulus << " Pa, " << thickness / a << ", " << worn);
        const ElasticStack before = coated(thickness, modulus), after = before.without_top(worn * thickness);
        const double bound = green::change_of_compliance(before, after, 0.01 / a, 100.0 / a);
        const double approach = CoatedContact::at_load(radius, 0.1, before, rigid).approach(),
                     worn_approach = CoatedContact::at_load(radius, 0.1, after, rigid).approach();
        const double change = worn_approach / approach - 1.0;
        EXPECT_GT(change * bound, 0.0);
        EXPECT_LT(std::abs(change), std::abs(bound));
        EXPECT_GT(std::abs(change), 0.02 * std::abs(bound)) << "the bound says nothing";
      }
}

TEST(CoatedContactTest, RefusesWhatItCannotResolve)
{
  EXPECT_THROW(CoatedContact(radius, a, coated(0.019 * a, 1e11), rigid), InputError);
  EXPECT_THROW(CoatedContact(radius, a, rigid, rigid), InputError);
  EXPECT_THROW(CoatedContact(radius, 0.0, substrate, rigid), InputError);
  EXPECT_THROW(CoatedContact(0.0, a, substrate, rigid), InputError);
}

} // namespace
} // namespace brinell::reference::coated_contact_test
