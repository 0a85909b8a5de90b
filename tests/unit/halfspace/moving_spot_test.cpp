// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/halfspace/steady_field.hpp"

#include "steady_heat.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <vector>

/// A Gaussian spot of heat that has always moved, at any speed.
namespace brinell::halfspace::moving_spot_test
{
namespace
{

constexpr double pi = std::numbers::pi;
using test::displacement_of;
using test::Field;
using test::layers_of;
using test::over_time;
using test::Pulse;
using test::spot;
using Layer = test::HeatedLayer;

const Thermal& body = test::heated_body;
const Elastic& elastic = test::heated_elastic;
const double kappa = body.diffusivity();

class MovingSpot : public testing::TestWithParam<double>
{
protected:
  static constexpr double width = 0.3;
  SurfaceGrid grid{40, 24, 0.1, 0.1};
  double velocity = GetParam() * 2.0 * kappa / width;
};

TEST_P(MovingSpot, Temperature)
{
  // Carslaw and Jaeger (1959), section 10.2, over the Gaussian and all time.
  const std::vector<double> depths{0.0, 0.05, 0.4, 3.0};
  const std::vector<Layer> layers =
      layers_of(SteadyField(grid, body, elastic, {velocity, {}}, depths), spot(grid, width));
  const double end = 400.0 * kappa / (velocity * velocity) + 40.0 / std::abs(velocity);
  const auto exact = [&](double x, double y, double z)
  {
    return kappa / body.conductivity *
           over_time(0.0, end,
                     [&](double t)
                     {
                       const double wide = width * width + 4.0 * kappa * t, r = std::hypot(x + velocity * t, y);
                       return width * width / wide * std::exp(-r * r / wide - z * z / (4.0 * kappa * t)) /
                              std::sqrt(pi * kappa * t);
                     });
  };
  double error = 0.0, largest = 0.0;
  for (std::size_t d = 0; d < depths.size(); ++d)
    for (const int i : {0, 12, 19, 26, 39})
      for (const int j : {0, 11})
      {
        const double value = exact(grid.x(i), grid.y(j), depths[d]);
        largest = std::max(largest, value);
        error = std::max(error, std::abs(layers[d].temperature[grid.index(i, j)] - value));
      }
  std::printf("Pe %g: temperature %.1e\n", GetParam(), error / largest);
  EXPECT_LT(error, 1e-5 * largest);
}

TEST_P(MovingSpot, Displacement)
{
  const Field u = displacement_of(SteadyField(grid, body, elastic, {velocity, {}}), spot(grid, width));
  // What enters later than that time is a nucleus far away; its sum goes with the root of the time, and is left out.
  const double end = 1e4 * (kappa / (velocity * velocity) + grid.nx * grid.dx / std::abs(velocity));
  double error = 0.0;
  for (const int i : {0, 19, 39})
    for (const int j : {0, 11})
    {
      const double exact = over_time(
          0.0, end,
          [&](double t) { return Pulse(width, t).displacement(std::hypot(grid.x(i) + velocity * t, grid.y(j))); });
      error = std::max(error, std::abs(u[grid.index(i, j)] - exact));
    }
  std::printf("Pe %g: displacement %.1e of %.3g\n", GetParam(), error / test::largest(u), test::largest(u));
  EXPECT_LT(error, 1e-4 * test::largest(u));
}

TEST_P(MovingSpot, EquilibriumAndAFreeSurface)
{
  const double h = 0.02;
  const std::vector<double> depths{0.0, 0.4 - h, 0.4, 0.4 + h};
  const SurfaceGrid fine{81, 49, 0.05, 0.05};
  const std::vector<Layer> layers =
      layers_of(SteadyField(fine, body, elastic, {velocity, {}}, depths), spot(fine, width));
  double traction = 0.0, left = 0.0, largest = 0.0;
  for (const SymTensor& s : layers[0].stress)
  {
    traction = std::max({traction, std::abs(s[2]), std::abs(s[3]), std::abs(s[4])});
    largest = std::max(largest, std::abs(s[0]));
  }
  const auto at = [&](std::size_t d, int i, int j, std::size_t c) { return layers[d].stress[fine.index(i, j)][c]; };
  for (int j = 2; j < fine.ny - 2; ++j)
    for (int i = 2; i < fine.nx - 2; ++i)
    {
      const auto along_x = [&](std::size_t c)
      {
        return (8.0 * (at(2, i + 1, j, c) - at(2, i - 1, j, c)) - at(2, i + 2, j, c) + at(2, i - 2, j, c)) /
               (12.0 * fine.dx);
      };
      const auto along_y = [&](std::size_t c)
      {
        return (8.0 * (at(2, i, j + 1, c) - at(2, i, j - 1, c)) - at(2, i, j + 2, c) + at(2, i, j - 2, c)) /
               (12.0 * fine.dy);
      };
      const auto along_z = [&](std::size_t c) { return (at(3, i, j, c) - at(1, i, j, c)) / (2.0 * h); };
      left = std::max({left, std::abs(along_x(0) + along_y(5) + along_z(4)),
                       std::abs(along_x(5) + along_y(1) + along_z(3)), std::abs(along_x(4) + along_y(3) + along_z(2))});
    }
  std::printf("Pe %g: traction %.1e, divergence %.1e\n", GetParam(), traction / largest, left * width / largest);
  EXPECT_LT(traction, 1e-10 * largest);
  EXPECT_LT(left, 1e-3 * largest / width); // differences over 1/20 of the width
}

INSTANTIATE_TEST_SUITE_P(All, MovingSpot, testing::Values(1e-3, 0.1, -1.0, 10.0, 1000.0));

} // namespace
} // namespace brinell::halfspace::moving_spot_test
