// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/elastoplastic/heating.hpp"

#include <gtest/gtest.h>

#include <array>
#include <vector>

/// The heat of an increment, where the surfaces touch by turns.
namespace brinell::elastoplastic::heating_test
{
namespace
{

using Field = std::vector<double>;

constitutive::Material steel(double temperature)
{
  constitutive::Material material;
  material.elastic = {200e9, 0.3};
  material.thermal = Thermal{50.0, 7800.0, 470.0, 12e-6};
  material.temperature = temperature;
  return material;
}

/// A hot surface on a cold one, without friction.
struct HotOnCold
{
  SurfaceGrid grid{9, 7, 1e-4, 1e-4};
  VolumeGrid body{grid, 2, 1e-4};
  Heating heating{grid, {{{body, steel(20.0)}, {body, steel(120.0)}}}, {{}, {1e-4, 1e-2}}, Twin::none};
  Field no_friction = Field(grid.size(), 0.0);

  void begin() { heating.begin({.grids = {body, body}, .places = {}, .columns = {}, .duration = 1e-4}); }
  /// The change of the gap under a pressure in the middle, and on that cell, too, or not.
  double follow(std::size_t cell, bool touches)
  {
    Field pressure(grid.size(), 0.0);
    for (const int i : {3, 4, 5})
      pressure[grid.index(i, 3)] = 1e8;
    pressure[cell] = touches ? 1e3 : 0.0;
    return heating.follow(pressure, no_friction, Heating::Sharing::fine);
  }
};

TEST(Heating, ACellThatPartsByItsOwnHeatEndsAsTouching)
{
  HotOnCold pair;
  const std::size_t cell = pair.grid.index(6, 3), away = pair.grid.index(1, 3);
  for (int increment = 0; increment < 2; ++increment)
  {
    pair.begin();
    for (int parting = 1; parting <= 2; ++parting) // may be on its way
    {
      pair.follow(cell, true);
      EXPECT_GT(pair.heating.flux(0)[cell], 0.0);
      EXPECT_GT(pair.follow(cell, false), 1e-9);
      EXPECT_EQ(pair.heating.flux(0)[cell], 0.0) << "increment " << increment << ", parting " << parting;
    }
    pair.follow(cell, true);
    const double touching = pair.heating.flux(0)[cell];
    EXPECT_LT(pair.follow(cell, false), 1e-12); // both turns have one answer now
    EXPECT_NEAR(pair.heating.flux(0)[cell] / touching, 1.0, 1e-4);
    EXPECT_EQ(pair.heating.flux(0)[away], 0.0);
    pair.heating.restore();
  }
}

} // namespace
} // namespace brinell::elastoplastic::heating_test
