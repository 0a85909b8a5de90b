// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/elastoplastic/heating.hpp"
#include "gauss.hpp"
#include "record.hpp"
#include "scenario_runs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

/// How heat passes from one surface to the other, and the regimes in which it makes them warm.
namespace brinell::verification::heat_contact_test
{
namespace
{

using elastoplastic::Heating;
using elastoplastic::HeatRegime;
using simulation::RollingCase;
using simulation::RollingRecord;

constexpr double pi = std::numbers::pi;
constexpr Thermal ceramic{20.0, 3200.0, 700.0, 0.0};
constexpr Thermal stiff_steel{50.0, 7800.0, 470.0, 0.0};

double effusivity(const Thermal& t)
{
  return std::sqrt(t.conductivity * t.density * t.specific_heat);
}

/// Two rigid half spaces that touch everywhere: what passes from the upper one, the warmer one, to the lower one in that time [J/m^2].
double heat_passed(double conductance, double warmer, double duration, int steps)
{
  const SurfaceGrid grid{2, 2, 1e-3, 1e-3, Boundary::periodic, Boundary::periodic};
  constitutive::Material lower{{std::numeric_limits<double>::infinity(), 0.0}, {}}, upper = lower;
  lower.thermal = stiff_steel;
  upper.thermal = ceramic;
  upper.temperature = lower.temperature + warmer;
  const VolumeGrid volume{grid, 1, 1e-3};
  const double step = duration / steps;
  Heating heating(grid, {Heating::Partner{volume, lower}, Heating::Partner{volume, upper}},
                  {.settings = {.conductance = conductance}, .times = {step, duration}}, elastoplastic::Twin::none);
  const std::vector<double> pressure(grid.size(), 1.0), none(grid.size(), 0.0);
  for (int n = 0; n < steps; ++n)
  {
    heating.begin({.grids = {volume, volume}, .places = {}, .columns = {}, .duration = step});
    static_cast<void>(heating.follow(pressure, none, Heating::Sharing::fine));
    heating.find_fluxes(pressure, none);
    heating.settle(pressure);
  }
  EXPECT_NEAR(heating.heat(0), -heating.heat(1), 1e-12 * heating.heat(0));
  return heating.heat(0) / (grid.cell_area() * static_cast<double>(grid.size()));
}

/// Carslaw and Jaeger (1959): with 1/E the sum of what both resist, the flux is h T e^{a^2 t} erfc(a sqrt(t)), a = h/E.
double exact_heat_passed(double conductance, double warmer, double duration)
{
  const double E = 1.0 / (1.0 / effusivity(stiff_steel) + 1.0 / effusivity(ceramic));
  const double x = conductance / E * std::sqrt(duration);
  // e^{x^2} erfc(x), by its continued fraction where the product overflows.
  const double scaled = x < 20.0 ? std::exp(x * x) * std::erfc(x) : 1.0 / (std::sqrt(pi) * (x + 0.5 / x));
  return warmer * E * E / conductance * (scaled - 1.0 + 2.0 * x / std::sqrt(pi));
}

TEST(HeatContact, AConductanceLetsHeatPass)
{
  constexpr double warmer = 60.0, duration = 1e-3;
  for (const double conductance : {1e3, 3e4, 1e6})
  {
    std::vector<double> errors;
    for (const int steps : {50, 100})
      errors.push_back(
          heat_passed(conductance, warmer, duration, steps) / exact_heat_passed(conductance, warmer, duration) - 1.0);
    // The flux of a step is that of the temperatures at its end: first order, and twice the finer one less the coarser one second.
    const std::string name =
        "heat through an interface of " + std::to_string(conductance / 1e3).substr(0, 6) + " kW/m^2K";
    test::expect_close(name + " / closed form", 1.0 + errors[1], 1.0, 1e-2, "exact: Carslaw and Jaeger (1959)");
    test::expect_close(name + " / closed form, by two steps", 1.0 + 2.0 * errors[1] - errors[0], 1.0, 1e-3,
                       "exact: Carslaw and Jaeger (1959)");
  }
}

/// The lower body takes the flux of a ball that slides, the upper one rests under its own.
RollingCase conducting_pair(double peclet)
{
  RollingCase c = sliding_ball(peclet, slow_build ? 4.0 : 5.0);
  c.upper.material.thermal = ceramic;
  c.distance *= 0.5;
  return c;
}

TEST(HeatContact, LimitsOfTheConductance)
{
  RollingCase c = conducting_pair(2.0);
  const auto heat_of_lower = [](const RollingCase& given)
  {
    const RollingRecord last = computed(given).summary.last;
    return last.heat_lower / (last.heat_lower + last.heat_upper);
  };
  const double one_temperature = heat_of_lower(c);
  c.heat.conductance = 1e12;
  const double conducting = heat_of_lower(c);
  test::expect_close("share of the lower body, conductance 1e12", conducting, one_temperature, 1e-6,
                     "both surfaces at one temperature");
  c.heat.conductance = 0.0;
  test::expect_close("share of the lower body, conductance 0", heat_of_lower(c), 0.5, 1e-12, "exact: halves");
  c.heat.partition = 0.8;
  test::expect_close("share of the lower body, conductance 0, partition 0.8", heat_of_lower(c), 0.8, 1e-12,
                     "exact: as given");
  c.heat.conductance = 1e5;
  const double between = heat_of_lower(c);
  EXPECT_GT(std::abs(between - 0.8), 1e-3);
  EXPECT_LT(std::abs(between - 0.8) + std::abs(between - one_temperature), 1.000001 * std::abs(0.8 - one_temperature));
}

/// Largest rise on the line y = 0 under a Hertzian flux that has moved along x for ever: Jaeger's moving point source,
/// e^{-V (r + ahead)/2 kappa}/(2 pi K r), over all of it, in polar coordinates about the place.
double steady_rise_of_ball(double heat, double radius, double speed)
{
  const double largest_flux = 1.5 * heat / (pi * radius * radius), slowness = speed / (2.0 * steel.diffusivity());
  const test::Gauss angle(80, 0.0, pi);
  const test::Gauss way(40, 0.0, 1.0); // the root of the way from the rim, where the flux is a root
  double largest = 0.0;
  for (double at = -0.98; at < 1.0; at += 0.02)
  {
    double sum = 0.0;
    for (std::size_t n = 0; n < angle.point.size(); ++n)
    {
      const double cosine = std::cos(angle.point[n]), sine = std::sin(angle.point[n]);
      const double end = -at * cosine + std::sqrt(1.0 - at * at * sine * sine);
      for (std::size_t w = 0; w < way.point.size(); ++w)
      {
        const double r = end * (1.0 - way.point[w] * way.point[w]), x = at + r * cosine, y = r * sine;
        sum += 2.0 * angle.weight[n] * way.weight[w] * 2.0 * way.point[w] * end *
               std::sqrt(std::max(0.0, 1.0 - x * x - y * y)) * std::exp(-slowness * radius * r * (1.0 - cosine));
      }
    }
    largest = std::max(largest, sum);
  }
  return largest * largest_flux * radius / (2.0 * pi * steel.conductivity);
}

double largest_rise_of_lower(const RollingRun& run)
{
  double rise = 0.0;
  for (const RollingRecord& r : run.history)
    rise = std::max(rise, r.max_temperature_lower - 20.0);
  return rise;
}

TEST(HeatContact, SteadyBall)
{
  for (const double peclet : {1e-3, 1.0, 10.0})
  {
    RollingCase c = sliding_ball(peclet, slow_build ? 5.0 : 10.0);
    c.heat.regime = HeatRegime::steady;
    c.distance *= 0.25;
    const RollingRun run = computed(c);
    const double modulus = contact_modulus(c.lower.material.elastic, c.upper.material.elastic);
    const double radius = std::cbrt(0.75 * c.drive.value * 10e-3 / modulus);
    const double heat = 0.1 * c.drive.value * *c.speed;
    const double exact = steady_rise_of_ball(heat, radius, *c.speed);
    if (peclet < 0.1)
    {
      EXPECT_NEAR(exact * 8.0 * radius * steel.conductivity / (3.0 * heat), 1.0, 2e-3); // pi/4 q0 a/K at rest
    }
    // Cells of a tenth of the radius, in each of which the flux is uniform.
    test::expect_close("steady rise / that of a Hertzian flux, Pe = " + std::to_string(peclet).substr(0, 5),
                       largest_rise_of_lower(run) / exact, 1.0, 1e-2, "exact: Jaeger's moving source, integrated");
    EXPECT_FALSE(run.summary.final_state.lower.temperature.empty());
  }
}

TEST(HeatContact, SteadyIsWhereTransientEnds)
{
  // After eight half-widths at Pe = 5, V^2 t/4 kappa = 20: nothing of the beginning is left.
  RollingCase c = sliding_ball(5.0, 5.0);
  const double transient = largest_rise_of_lower(computed(c));
  c.heat.regime = HeatRegime::steady;
  EXPECT_NEAR(largest_rise_of_lower(computed(c)) / transient, 1.0, 2e-3);
}

/// Largest rise under the flux of a line contact of so much heat per length that has moved for ever: Jaeger's moving lines,
/// e^{-V ahead/2 kappa} K_0(V distance/2 kappa)/(pi K).
double steady_rise_of_cylinder(double heat, double half_width, double speed)
{
  const double largest_flux = 2.0 * heat / (pi * half_width),
               slowness = speed * half_width / (2.0 * steel.diffusivity());
  const test::Gauss root(60, 0.0, 1.0);
  double largest = 0.0;
  for (double at = -0.98; at < 1.0; at += 0.02)
  {
    double sum = 0.0;
    for (const double side : {-1.0, 1.0}) // sources behind the place, and ahead of it
    {
      const double length = 1.0 - side * at;
      for (std::size_t n = 0; n < root.point.size(); ++n)
      {
        const double u = root.point[n], distance = length * u * u, source = at + side * distance;
        sum += root.weight[n] * 2.0 * u * length * std::sqrt(std::max(0.0, 1.0 - source * source)) *
               std::exp(side * slowness * distance) * std::cyl_bessel_k(0.0, slowness * distance);
      }
    }
    largest = std::max(largest, sum);
  }
  return largest * largest_flux * half_width / (pi * steel.conductivity);
}

TEST(HeatContact, ASlidingCylinderAgainstMovingLines)
{
  for (const double peclet : {1.0, 5.0})
  {
    RollingCase c = sliding_ball(1.0, slow_build ? 5.0 : 10.0);
    c.upper.shape = simulation::Roller{10e-3, std::numeric_limits<double>::infinity()};
    c.domain.y = {Boundary::periodic, 1.0, 1};
    const double modulus = contact_modulus(c.lower.material.elastic, c.upper.material.elastic);
    const double pressure = 1e9, half_width = 2.0 * 10e-3 * pressure / modulus;
    c.drive = load(pi * 10e-3 * pressure * pressure / modulus); // of a metre
    c.speed = 2.0 * steel.diffusivity() * peclet / half_width;
    c.distance = (peclet > 2.0 ? 8.0 : 30.0) * half_width; // V^2 t/4 kappa = 20 and 15
    const RollingRun run = computed(c);
    const double exact = steady_rise_of_cylinder(0.1 * c.drive.value * *c.speed, half_width, *c.speed);
    test::expect_close("rise under a sliding cylinder / that of moving lines, Pe = " +
                           std::to_string(peclet).substr(0, 4),
                       largest_rise_of_lower(run) / exact, 1.0, 1.5e-2, "exact: Jaeger (1942), integrated");
  }
}

} // namespace
} // namespace brinell::verification::heat_contact_test
