// SPDX-License-Identifier: BSD-3-Clause
// Current and heat through the contact of plated bodies.
#include "brinell/elastoplastic/effects.hpp"
#include "brinell/elastoplastic/increment.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

namespace brinell::elastoplastic::plated_current_test
{
namespace
{

using constitutive::Electrical;
using constitutive::Material;

constexpr int n = 25;
constexpr double cell = 1e-6, interference = 1.6e-6, radius = 50e-6;
const Elastic copper{120e9, 0.34};

/// Totals of a ball with the resistivity of copper, pressed on a flat.
EffectTotals pressed(const Material& flat, const CurrentDrive& drive = {})
{
  const SurfaceGrid grid{n, n, cell, cell};
  Sliding sliding;
  sliding.effects.current = drive;
  Material ball{copper, {}};
  ball.electrical = Electrical{1.7e-8, 0.0};
  CoupledContact contact(grid, {grid, 2, cell}, {grid, 2, cell}, flat, ball, Scales{interference, interference},
                         Settings{}, Twin::none, Textures{}, 0.0, sliding);
  std::vector<double> gap(grid.size());
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i)
      gap[grid.index(i, j)] =
          (std::pow((i - n / 2) * cell, 2) + std::pow((j - n / 2) * cell, 2)) / (2.0 * radius) - interference;
  EXPECT_TRUE(contact.advance(gap, {}, Placement{{0}, {0}}, Strategy{}).converged);
  EffectTotals totals;
  for (const auto& effect : contact.effects())
    effect->report(totals);
  return totals;
}

/// Copper with two platings.
Material plated(double gold, double nickel)
{
  Material flat{copper, {}};
  flat.temperature = 20.0;
  flat.electrical = Electrical{1.7e-8, 0.0};
  flat.layers = {{1e-6, copper, {}, Electrical{gold, 0.0}}, {2e-6, copper, {}, Electrical{nickel, 0.0}}};
  return flat;
}

TEST(PlatedCurrent, LayersOfTheSubstrateAreTheHomogeneousBody)
{
  Material bare = plated(1.0, 1.0);
  bare.layers.clear();
  const EffectTotals expected = pressed(bare), found = pressed(plated(1.7e-8, 1.7e-8));
  EXPECT_NEAR(found.contact_resistance, expected.contact_resistance, 1e-9 * expected.contact_resistance);
  EXPECT_NEAR(found.thermal_contact_conductance, expected.thermal_contact_conductance,
              1e-9 * expected.thermal_contact_conductance);
}

TEST(PlatedCurrent, HeatIsConductedByWiedemannAndFranz)
{
  for (const auto& [gold, nickel] : {std::pair{2.2e-8, 7e-8}, {1.2e-7, 1.7e-8}})
  {
    const EffectTotals found = pressed(plated(gold, nickel));
    const double expected = contact::lorenz_number * 293.15 / found.contact_resistance;
    EXPECT_NEAR(found.thermal_contact_conductance, expected, 1e-5 * expected);
  }
}

TEST(PlatedCurrent, LayersHaveTheResistivityOfTheBulkTemperature)
{
  Material warm = plated(2e-8, 6e-8);
  warm.temperature = 120.0;
  warm.layers[1].electrical->temperature_coefficient = 5e-3; // half as much again
  const EffectTotals expected = pressed(plated(2e-8, 9e-8)), found = pressed(warm);
  EXPECT_NEAR(found.contact_resistance, expected.contact_resistance, 1e-9 * expected.contact_resistance);
}

TEST(PlatedCurrent, TheTemperatureIsThatOfTheVoltage)
{
  // Kohlrausch (1900): whatever the plating. The current is that of the cold contact, because no resistivity grows.
  CurrentDrive drive;
  drive.voltage = {0.1};
  const EffectTotals cold = pressed(plated(2.2e-8, 7e-8)), found = pressed(plated(2.2e-8, 7e-8), drive);
  const double kelvin = std::sqrt(293.15 * 293.15 + 0.01 / (4.0 * contact::lorenz_number));
  EXPECT_NEAR(found.contact_temperature, kelvin - 273.15, 1e-6 * kelvin);
  EXPECT_NEAR(found.current, 0.1 / cold.contact_resistance, 1e-9 * found.current);
}

} // namespace
} // namespace brinell::elastoplastic::plated_current_test
