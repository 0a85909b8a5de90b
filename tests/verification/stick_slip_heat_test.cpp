// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/halfspace/surface_compliance.hpp"
#include "brinell/halfspace/thermal_field.hpp"
#include "brinell/simulation/fretting.hpp"
#include "creeping_cylinder.hpp"
#include "gauss.hpp"
#include "moving_heat.hpp"
#include "record.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>
#include <vector>

/// Heat of surfaces that stick in places and slip in others: fretting and rolling with creepage.
namespace brinell::verification::stick_slip_heat_test
{
namespace
{

using elastoplastic::HeatSource;
using simulation::FrettingCase;
using simulation::FrettingRecord;
using simulation::RollingCase;
using simulation::RollingRecord;

constexpr double pi = std::numbers::pi;
constexpr Thermal unexpanding{50.0, 7800.0, 470.0, 0.0};

/// An elastic cylinder in steady rolling with a creepage that lets the part `share` of its contact slip: its largest temperature
/// rise over that of the same heat by Jaeger's (1942) moving lines.
double rise_over_exact(double cells, double share, double peclet)
{
  constexpr double f = 0.3, a = Cylinder::a, R = Cylinder::R;
  RollingCase c = Cylinder::rolling(cells, f, share * f * a / R);
  c.lower.material.thermal = c.upper.material.thermal = unexpanding;
  c.speed = 2.0 * unexpanding.diffusivity() * peclet / a;
  const RollingRun run = computed(c);
  const double rise = at_the_end(c, run).max_temperature_lower - c.lower.material.temperature;
  EXPECT_NEAR(at_the_end(c, run).max_temperature_upper - c.upper.material.temperature, rise, 1e-4 * rise);
  // The trailing part slips, -a < x < -a + 2 share a, with V f/R sqrt((x - d)^2 - c^2), where c = (1 - share) a and d = share a
  // (Johnson 1985, section 8.3); half of the heat enters each body.
  const double stuck = (1.0 - share) * a, middle = share * a;
  const double pressure = 0.5 * Cylinder::modulus() * a / R;
  constexpr int strips = 400;
  const double half = share * a / strips;
  std::vector<double> places, fluxes;
  for (int n = 0; n < strips; ++n)
  {
    const double x = -a + (2 * n + 1) * half;
    const double slip = *c.speed * f / R * std::sqrt(std::max(0.0, std::pow(x - middle, 2) - stuck * stuck));
    places.push_back(x);
    fluxes.push_back(0.5 * f * pressure * std::sqrt(1.0 - x * x / (a * a)) * slip);
  }
  const double slowness = *c.speed / (2.0 * unexpanding.diffusivity());
  const auto exact = [&](double x)
  {
    double sum = 0.0;
    for (int n = 0; n < strips; ++n)
      sum += test::moving_strip_rise(x - places[n], half, fluxes[n], slowness, unexpanding.conductivity);
    return sum;
  };
  return rise / test::largest_rise(-1.5 * a, a, exact).rise;
}

TEST(StickSlipHeat, CylindersWithCreepageFollowCarterAndJaeger)
{
  for (const auto& [share, peclet] : {std::pair{0.4, 5.0}, {0.7, 20.0}})
  {
    const std::vector<double> resolutions = slow_build ? std::vector{8.0} : std::vector{8.0, 16.0, 32.0};
    for (const double cells : resolutions)
      test::expect_close(
          fmt::format("largest temperature, {:g} of the contact slips at Peclet {:g}, {:g} cells / exact", share,
                      peclet, cells),
          rise_over_exact(cells, share, peclet), 1.0, 0.25 / cells,
          "exact: Carter (1926), Jaeger (1942); first order, as the force");
  }
}

/// A steel ball of 10 mm on a flat, elastic, moved along x by so many times the displacement at which everything slides.
FrettingCase fretting_ball(double amplitude, double cells)
{
  constitutive::Material material{{210e9, 0.3}, {}};
  material.thermal = unexpanding;
  FrettingCase c;
  c.lower = {simulation::Plane{}, material};
  c.upper = {ball(10e-3), material};
  c.press = load(50.0);
  c.press_steps = 4;
  c.resolution = cells;
  c.friction.coefficient = 0.1;
  c.frequency = 1.0; // until the contact is known
  c.amplitude = amplitude * simulation::plan(c).sliding_displacement;
  return c;
}

TEST(StickSlipHeat, FrettingReachesTheTemperatureOfAHertzSource)
{
  // Gross slip, so fast that the temperature hardly follows a cycle. Its heat is that of a source at rest, as Hertz's pressure; where
  // that of a disc acts for a time t, the rise in its middle is the integral of q erfc(r/sqrt(4 kappa t))/K over the radius
  // (Carslaw and Jaeger 1959, section 10.4), and pi q0 a/(4 K) after a long time.
  FrettingCase c = fretting_ball(40.0, slow_build ? 6.0 : 12.0);
  const double modulus = contact_modulus(c.lower.material.elastic, c.upper.material.elastic);
  const double a = std::cbrt(0.75 * c.press.value * 10e-3 / modulus), kappa = unexpanding.diffusivity();
  c.frequency = 6.0 * kappa / (a * a);
  c.cycles = slow_build ? 8 : 24;
  c.steps_per_cycle = 8;
  const auto run = computed(c);
  double mean = 0.0;
  for (int n = 0; n < c.steps_per_cycle; ++n)
    mean += (run.history.rbegin()[n].max_temperature_lower - 20.0) / c.steps_per_cycle;
  const double power = 0.5 * run.summary.cycles.back().dissipation_friction * *c.frequency; // into each body
  const double flux = 1.5 * power / (pi * a * a);
  const double time = (c.cycles - 0.5) / *c.frequency;
  const test::Gauss radius(40, 0.0, 1.0);
  double exact = 0.0;
  for (std::size_t n = 0; n < radius.point.size(); ++n)
    exact += radius.weight[n] * flux * std::sqrt(1.0 - std::pow(radius.point[n], 2)) *
             std::erfc(radius.point[n] * a / std::sqrt(4.0 * kappa * time)) * a / unexpanding.conductivity;
  EXPECT_NEAR(power / (4.0 * 0.5 * c.friction.coefficient * c.press.value * c.amplitude * *c.frequency), 1.0, 0.05);
  test::expect_close("fretting in gross slip: mean temperature of the last cycle / closed form", mean / exact, 1.0,
                     0.015, "exact: Carslaw and Jaeger (1959), section 10.4; without the swing of a cycle");
}

// Where all of the contact slips, creepage and slide_to_roll are one motion but for the speeds of the surfaces, which differ by the
// creepage itself.
TEST(StickSlipHeat, FullSlipIsSliding)
{
  constexpr double creepage = 0.01;
  constitutive::Material material{{210e9, 0.3}, {}};
  material.thermal = steel;
  RollingCase sticks;
  sticks.lower = {simulation::Plane{}, material};
  sticks.upper = {ball(10e-3), material};
  sticks.drive = load(50.0);
  sticks.load_steps = 2;
  sticks.resolution = slow_build ? 5.0 : 8.0;
  sticks.friction.coefficient = 0.02;
  sticks.speed = 100.0;
  sticks.distance = 1e-3;
  RollingCase slides = sticks;
  sticks.creepage = {creepage, 0.0, 0.0};
  slides.slide_to_roll = -creepage; // of the lower surface past the upper one
  const RollingRun partial = computed(sticks), full = computed(slides);
  const RollingRecord &p = at_the_end(sticks, partial), &q = at_the_end(slides, full);
  EXPECT_LT(p.stick_share, 0.05);
  EXPECT_GT(q.max_temperature_lower, 21.0);
  test::expect_close("temperature rise with creepage / with slide_to_roll",
                     (p.max_temperature_lower - 20.0) / (q.max_temperature_lower - 20.0), 1.0, 2.0 * creepage,
                     "both slide everywhere; speeds differ by the creepage");
  test::expect_close("heat into the lower body with creepage / with slide_to_roll", p.heat_lower / q.heat_lower, 1.0,
                     3.0 * creepage, "the same; the surfaces stick at first");
}

/// Steel on a softer, hotter body that expands more: pressure, shear and heat move the surfaces by different amounts.
template <typename Scenario>
void make_unlike(Scenario& c)
{
  c.lower.material.thermal = Thermal{45.0, 7800.0, 470.0, 60e-6};
  c.upper.material.elastic = {70e9, 0.33};
  c.upper.material.thermal = Thermal{1.0, 2500.0, 800.0, 120e-6};
  c.lower.material.hardening = constitutive::LinearHardening{0.25e9, 10e9};
}

TEST(StickSlipHeat, EnergyOfUnlikeBodiesCloses)
{
  FrettingCase fretting = fretting_ball(0.8, slow_build ? 4.0 : 6.0);
  make_unlike(fretting);
  fretting.friction.coefficient = 0.4;
  fretting.frequency = 1e6; // the expansion does 3 % of the work in gross slip
  fretting.press_steps = 16;
  fretting.cycles = 2;
  fretting.steps_per_cycle = 32;
  for (const double amplitude : {0.6, 3.0}) // partial and gross slip
  {
    fretting.amplitude = amplitude * simulation::plan(fretting).sliding_displacement;
    const auto run = computed(fretting);
    const FrettingRecord& last = run.summary.last;
    EXPECT_GT(run.summary.dissipation_lower, 0.0);
    test::expect_close(
        fmt::format("fretting of unlike bodies with heat, {:g} of the sliding displacement: energy balance", amplitude),
        run.summary.energy_balance_error, 0.0, 2e-3, "work = heat + dissipation + stored energy");
    test::expect_close("the same: heat in both bodies / heat of friction",
                       (last.heat_lower + last.heat_upper) / last.dissipation_friction, 1.0, 1e-6, "first law");
  }
  RollingCase rolling;
  rolling.lower = fretting.lower;
  rolling.upper = fretting.upper;
  rolling.drive = fretting.press;
  rolling.friction.coefficient = 0.3;
  rolling.creepage = {0.004, 0.001, 3.0};
  rolling.speed = 50.0;
  rolling.distance = 1.2e-3;
  rolling.resolution = fretting.resolution;
  const RollingRun run = computed(rolling);
  EXPECT_GT(run.summary.dissipation_lower, 0.0);
  test::expect_close("rolling with creepage of unlike bodies with heat: energy balance",
                     run.summary.energy_balance_error, 0.0, 5e-3, "work = heat + dissipation + stored energy");
  test::expect_close("the same: heat in both bodies / heat of friction",
                     (run.summary.last.heat_lower + run.summary.last.heat_upper) /
                         run.summary.last.dissipation_friction,
                     1.0, 1e-6, "first law");
}

/// A ball that is not moved on a flat that expands under a spot of that power.
FrettingCase warm_spot(double power, double friction)
{
  FrettingCase c = fretting_ball(0.0, slow_build ? 5.0 : 8.0);
  c.lower.material.thermal = steel;
  c.friction.coefficient = friction;
  const double a = simulation::plan(c).contact_radius;
  c.frequency = steel.diffusivity() / (a * a);
  c.heat.partition = 1.0;
  c.heat.source = {.shape = HeatSource::Shape::disc, .on = HeatSource::Side::lower, .power = power, .radius = 0.8 * a};
  return c;
}

// The spot spreads the surface of the flat under a ball that sticks to it: the shears push it back. Where surfaces stick, the
// displacement by the shears is the opposite of that by the heat, which enters the flat at a constant flux.
TEST(StickSlipHeat, StuckSurfacesHoldBackThermalExpansion)
{
  FrettingCase c = warm_spot(1.0, 5.0);
  c.press_steps = 1; // the surfaces touch and stick from the beginning
  c.steps_per_cycle = 4;
  simulation::Run<FrettingCase> run(c);
  while (!run.is_done())
    static_cast<void>(run.step());
  const simulation::Snapshot s = run.snapshot();
  const SurfaceGrid wide{3 * s.contact.nx, 3 * s.contact.ny, s.contact.dx, s.contact.dy};
  std::vector<double> flux(wide.size()), by_heat_x(wide.size()), by_heat_y(wide.size());
  const auto in_wide = [&](int i, int j) { return wide.index(i + s.contact.nx, j + s.contact.ny); };
  for (int j = 0; j < s.contact.ny; ++j)
    for (int i = 0; i < s.contact.nx; ++i)
      flux[in_wide(i, j)] = s.heat_flux[0][s.contact.index(i, j)];
  const double duration = run.step_count() / (c.steps_per_cycle * *c.frequency);
  halfspace::ThermalField field(wide, steel, c.lower.material.elastic, {duration, duration});
  field.add_step(flux, {duration});
  field.displacement({{}, by_heat_x, by_heat_y});
  const halfspace::SurfaceCompliance pair(s.contact, c.lower.material.elastic, c.upper.material.elastic, 0.0);
  std::vector<double> by_shear_x(s.contact.size()), by_shear_y(s.contact.size());
  pair.apply({.shear_x = s.shear[0], .shear_y = s.shear[1]}, {.x = by_shear_x, .y = by_shear_y});
  double largest = 0.0, difference = 0.0;
  int stuck = 0;
  for (int j = 0; j < s.contact.ny; ++j)
    for (int i = 0; i < s.contact.nx; ++i)
    {
      const std::size_t n = s.contact.index(i, j);
      if (std::hypot(s.shear[0][n], s.shear[1][n]) > 0.9 * c.friction.coefficient * s.pressure[n] ||
          s.pressure[n] == 0.0)
        continue;
      ++stuck;
      largest = std::max({largest, std::abs(by_heat_x[in_wide(i, j)]), std::abs(by_heat_y[in_wide(i, j)])});
      difference = std::max({difference, std::abs(by_heat_x[in_wide(i, j)] + by_shear_x[n]),
                             std::abs(by_heat_y[in_wide(i, j)] + by_shear_y[n])});
    }
  EXPECT_GT(stuck, 50);
  EXPECT_GT(largest, 1e-9);
  test::expect_close("stuck surfaces: displacement by shears and by heat, sum / largest", difference / largest, 0.0,
                     2e-3, "no slip; the field by heat has errors of 1e-3");
}

// The expansion does work on the shears of surfaces that stick: without it the energy would be off by 14 % where all sticks.
TEST(StickSlipHeat, ExpansionDoesWorkOnTheShears)
{
  for (const double friction : {0.3, 5.0})
  {
    FrettingCase c = warm_spot(30.0, friction);
    c.press_steps = 16;
    c.steps_per_cycle = 40;
    test::expect_close(fmt::format("a hot spot under a ball that sticks, friction {:g}: energy balance", friction),
                       computed(c).summary.energy_balance_error, 0.0, 2.5e-3, "work = heat + stored energy");
  }
}

TEST(StickSlipHeat, WithoutHeatIsTheIsothermalCase)
{
  FrettingCase cold = fretting_ball(0.6, 5.0);
  cold.steps_per_cycle = 8;
  cold.lower.material.thermal = cold.upper.material.thermal = steel;
  cold.heat.fraction = 0.0;
  FrettingCase isothermal = cold;
  isothermal.lower.material.thermal = isothermal.upper.material.thermal = std::nullopt;
  const auto a = computed(cold), b = computed(isothermal);
  ASSERT_EQ(a.history.size(), b.history.size());
  for (std::size_t n = 0; n < a.history.size(); ++n)
  {
    EXPECT_NEAR(a.history[n].force, b.history[n].force, 1e-6 * 5.0);
    EXPECT_NEAR(a.history[n].approach, b.history[n].approach, 1e-6 * b.history.back().approach);
    EXPECT_EQ(a.history[n].max_temperature_lower, 20.0);
  }
}

// The upper body of a pair of twins is the mirror image of the lower one, also in its heat.
TEST(StickSlipHeat, TwinsAreSolvedOnce)
{
  FrettingCase twins = fretting_ball(2.0, slow_build ? 4.0 : 6.0);
  for (simulation::ShapedBody* body : {&twins.lower, &twins.upper})
  {
    body->shape = ball(20e-3);
    body->material.thermal = Thermal{50.0, 7800.0, 470.0, 60e-6};
    body->material.hardening = constitutive::LinearHardening{0.3e9, 10e9};
  }
  twins.friction.coefficient = 0.3;
  twins.frequency = 1e6;
  twins.steps_per_cycle = 16;
  FrettingCase both = twins;
  both.solver.mirror = false;
  ASSERT_NE(simulation::plan(twins).twin, elastoplastic::Twin::none);
  const auto a = computed(twins), b = computed(both);
  EXPECT_GT(a.summary.dissipation_lower, 0.0);
  double hottest = 0.0;
  for (const FrettingRecord& r : b.history)
    hottest = std::max(hottest, r.max_temperature_lower - 20.0);
  EXPECT_GT(hottest, 3.0);
  for (std::size_t n = 0; n < a.history.size(); ++n)
  {
    EXPECT_NEAR(a.history[n].force, b.history[n].force, 1e-4 * 15.0);
    EXPECT_NEAR(a.history[n].max_temperature_lower, b.history[n].max_temperature_lower, 1e-3 * hottest);
    EXPECT_NEAR(a.history[n].max_temperature_upper, b.history[n].max_temperature_upper, 1e-3 * hottest);
  }
  EXPECT_NEAR(a.summary.last.work_of_expansion / b.summary.last.work_of_expansion, 1.0, 1e-3);
  EXPECT_NEAR(a.summary.dissipation_upper / b.summary.dissipation_upper, 1.0, 1e-3);
}

} // namespace
} // namespace brinell::verification::stick_slip_heat_test
