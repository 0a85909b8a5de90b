// SPDX-License-Identifier: BSD-3-Clause
// Temperature of a contact through which current flows, with a film and without.
#include "brinell/contact/constriction.hpp"
#include "brinell/contact/contact_voltage.hpp"
#include "contact_areas.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace brinell::contact::contact_temperature_test
{
namespace
{

using areas::area, areas::Area, areas::in_discs, areas::infinite, areas::modulus;

constexpr double pi = std::numbers::pi;

/// Temperature of an area under a voltage, and the spread over its cells.
std::array<double, 2> temperatures(const Area& a, const std::array<Conductor, 2>& bodies, double voltage, double film)
{
  const halfspace::SurfaceCompliance compliance(a.grid, modulus);
  Constriction constriction(compliance, modulus);
  const std::vector<double> films(film > 0.0 ? a.grid.size() : 0, film);
  Flow found = constriction.flow({a.pressure, a.gap}, bodies[0].resistivity + bodies[1].resistivity, films);
  std::vector<double> source(a.grid.size());
  for (std::size_t i = 0; i < source.size(); ++i)
  {
    found.density[i] *= voltage;
    source[i] = film * found.density[i] * found.density[i];
  }
  const std::vector<double> t = constriction.heat(a.pressure, found.density, source, bodies).temperature;
  double low = infinite, high = -infinite;
  for (std::size_t i = 0; i < t.size(); ++i)
    if (a.pressure[i] > 0.0)
    {
      low = std::min(low, t[i]);
      high = std::max(high, t[i]);
    }
  return {low, high};
}

const Area& three_spots()
{
  static const Area spots = area(70, 60, 0.25,
                                 [](double x, double y)
                                 {
                                   return std::hypot(x + 3, y) < 2.0 || std::hypot(x - 3, y + 1) < 1.1 ||
                                          (std::abs(x - 2) < 1.3 && std::abs(y - 4) < 0.6);
                                 });
  return spots;
}

TEST(ContactTemperature, OfEqualBodiesIsThatOfKohlrauschOnAnySpots)
{
  constexpr double voltage = 0.1, resistivity = 1.7e-8, conductivity = 400.0;
  const auto [low, high] = temperatures(
      three_spots(), {{{resistivity, conductivity, 20.0}, {resistivity, conductivity, 20.0}}}, voltage, 0.0);
  const double rise = voltage * voltage / (8.0 * resistivity * conductivity);
  EXPECT_NEAR(low, 20.0 + rise, 0.02 * rise);
  EXPECT_NEAR(high, 20.0 + rise, 0.02 * rise);
}

TEST(ContactTemperature, OfUnlikeBodiesIsThatOfTheVoltage)
{
  constexpr double voltage = 0.08;
  const std::array<HotConductor, 2> bodies{
      HotConductor{.resistivity = 1.7e-8, .conductivity = 400.0},
      HotConductor{.resistivity = 7e-8, .conductivity = 60.0, .temperature = 35.0}};
  const HotContact hot = hot_contact(bodies, voltage);
  const auto [low, high] = temperatures(three_spots(), {{{1.7e-8, 400.0, 20.0}, {7e-8, 60.0, 35.0}}}, voltage, 0.0);
  EXPECT_GT(hot.temperature, hot.interface + 1.0); // inside the worse conductor
  EXPECT_NEAR(low, hot.interface, 0.02 * (hot.interface - 20.0));
  EXPECT_NEAR(high, hot.interface, 0.02 * (hot.interface - 20.0));
}

TEST(ContactTemperature, OfABadFilmIsThatOfItsHeat)
{
  // Uniform density j, heat sigma j^2, of which equal bodies take half each: q a/k in the middle of a disc, 2/pi of it at the edge.
  constexpr double film = 1e-6, conductivity = 50.0, voltage = 1.0;
  const Area disc = area(70, 70, 1.0 / 32, in_discs({{0.0, 0.0}}));
  const auto [low, high] =
      temperatures(disc, {{{1e-12, conductivity, 0.0}, {1e-12, conductivity, 0.0}}}, voltage, film);
  const double half = 0.5 * voltage * voltage / film / conductivity;
  EXPECT_NEAR(high, half, 0.005 * half);
  EXPECT_NEAR(low, 2.0 / pi * half, 0.03 * half);
}

TEST(ContactTemperature, OfWiedemannAndFranz)
{
  // T_m^2 - T_0^2 = V^2/(4 L), T_0 = 293.15 K, whatever the resistivity.
  const std::vector<std::array<double, 2>> table{{0.01, 294.9}, {0.05, 334.0}, {0.1, 434.0},
                                                 {0.12, 483.2}, {0.2, 704.1},  {0.3, 1004.0}};
  for (const auto& [voltage, expected] : table)
    for (const double coefficient : {0.0, 0.004})
    {
      const HotConductor metal{.resistivity = 1.7e-8, .temperature_coefficient = coefficient};
      EXPECT_NEAR(hot_contact({metal, metal}, voltage).temperature + 273.15, expected, 0.1);
      EXPECT_NEAR(hot_contact({metal, HotConductor{.resistivity = 9e-8}}, voltage).temperature + 273.15, expected, 0.1);
    }
  const HotConductor copper{.resistivity = 1.713e-8, .conductivity = 400.0};
  EXPECT_NEAR(hot_contact({copper, copper}, 0.1).temperature - 20.0, 0.01 / (8.0 * 1.713e-8 * 400.0), 1e-6);
}

TEST(ContactTemperature, OfAFilmIsThatOfTheLineThroughTheContact)
{
  // Along a tube from one far end to the other, of length 1 in each body, with a film between: d/ds (k dT/ds) = -rho F^2 with
  // rho F = dphi/ds. The temperatures at the film are equal, and its heat F (drop) flows into both. Integrated by midpoints from
  // both ends with the flow, the hot contact and its heat as they were found.
  const HotConductor copper{.resistivity = 1.7e-8, .temperature_coefficient = 4e-3},
      bronze{.resistivity = 1.2e-7, .temperature_coefficient = 1e-3, .conductivity = 60.0, .temperature = 60.0};
  const double film = 5e-8, voltage = 0.15;
  const HotContact hot = hot_contact({copper, bronze}, voltage, film);
  const auto from_end = [&](const HotConductor& body, double drop, double heat_at_end)
  {
    // heat_at_end: k dT/ds at the far end, into the body towards the contact
    constexpr int steps = 20000;
    double t = body.temperature, phi = 0.0, flux = heat_at_end;
    for (int n = 0; n < steps; ++n)
    {
      const double ds = 1.0 / steps, half = t + 0.5 * ds * flux / body.conductivity_at(t);
      const double rho = body.resistivity_at(half);
      t += ds * (flux - 0.5 * ds * rho * hot.flow * hot.flow) / body.conductivity_at(half);
      flux -= ds * rho * hot.flow * hot.flow;
      phi += ds * rho * hot.flow;
    }
    EXPECT_NEAR(phi, drop, 1e-5 * voltage);
    EXPECT_NEAR(t, hot.interface, 1e-3 * (hot.interface - 20.0));
    return flux; // into the contact, < 0: out of it
  };
  const double into_lower = from_end(copper, voltage - hot.contact[0], hot.flow * (voltage - hot.hottest)),
               into_upper = from_end(bronze, hot.contact[1], hot.flow * hot.hottest);
  const double drop = hot.contact[0] - hot.contact[1];
  EXPECT_NEAR(drop, film * hot.flow, 1e-9 * voltage);
  EXPECT_NEAR(into_lower + into_upper, hot.flow * drop, 1e-4 * hot.flow * voltage);
  const auto again = hot_contact_of_current({copper, bronze}, hot.flow, film);
  ASSERT_TRUE(again);
  EXPECT_NEAR(again->voltage, voltage, 1e-9);
  const Conductor constant = as_constant({copper, bronze}, hot, 1);
  EXPECT_NEAR(constant.resistivity, hot.contact[1] / hot.flow, 1e-9 * constant.resistivity);
  EXPECT_GT(constant.resistivity, bronze.resistivity_at(60.0));
}

TEST(ContactTemperature, RaisesTheResistance)
{
  const HotConductor metal{.resistivity = 1.7e-8, .temperature_coefficient = 0.004};
  double before = 0.0;
  for (const double voltage : {1e-4, 0.05, 0.1, 0.2, 0.4})
  {
    const HotContact hot = hot_contact({metal, metal}, voltage);
    const double resistance = voltage / hot.flow;
    EXPECT_GT(resistance, before);
    before = resistance;
    const std::optional<HotContact> again = hot_contact_of_current({metal, metal}, hot.flow);
    ASSERT_TRUE(again);
    EXPECT_NEAR(again->voltage / voltage, 1.0, 1e-9);
  }
  EXPECT_NEAR(hot_contact({metal, metal}, 1e-4).flow * 2.0 * 1.7e-8 / 1e-4, 1.0, 1e-6);
  // As the voltage grows the current of a metal of this kind approaches pi sqrt(L)/(2 rho alpha) in this measure, from above.
  const double most = 0.5 * pi * std::sqrt(lorenz_number) / (1.7e-8 * 0.004);
  EXPECT_FALSE(hot_contact_of_current({metal, metal}, 1.5 * most));
  EXPECT_TRUE(hot_contact_of_current({metal, metal}, 0.5 * most));
}

TEST(ContactTemperature, WithoutVoltageIsThatOfTheBulk)
{
  const HotConductor metal{.resistivity = 1.7e-8, .conductivity = 400.0, .temperature = 80.0};
  EXPECT_EQ(hot_contact({metal, metal}, 0.0).temperature, 80.0);
  EXPECT_EQ(hot_contact_of_current({metal, metal}, 0.0)->flow, 0.0);
}

} // namespace
} // namespace brinell::contact::contact_temperature_test
