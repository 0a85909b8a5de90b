// SPDX-License-Identifier: BSD-3-Clause
#include "moving_heat.hpp"
#include "surface_rises.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <functional>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

/// Temperatures of heat sources at rest and in motion, in cases as a user writes them, against exact ones.
namespace brinell::verification::flash_temperature_test
{
namespace
{

using simulation::RollingCase;
using simulation::SlidingCase;
using test::Peak;

constexpr double pi = std::numbers::pi;
/// Half the side of squares and strips, or the radius of discs; the steel of the cases.
constexpr double half = 1e-4, flux = 1e8, conductivity = 50.0, diffusivity = 1.25e-5;
const std::string steel = R"toml(
young_modulus = "200 GPa"
poisson_ratio = 0.3
thermal = { conductivity = "50 W/(m K)", density = "8000 kg/m^3", specific_heat = "500 J/(kg K)", expansion = 0.0 }
)toml";
const std::string square = R"(shape = "rectangle", length = "0.2 mm", width = "0.2 mm")";
const std::string disc = R"(shape = "disc", radius = "0.1 mm")";

/// A source on a steel ball that slides over a rigid flat: it rests on the ball.
SlidingCase source_at_rest(const std::string& source, double cells)
{
  return case_of<SlidingCase>(fmt::format(R"toml(
scenario = "sliding"
lower = {{ shape.type = "flat", material.rigid = true }}
upper.shape = {{ type = "sphere", radius = "10 mm" }}
[upper.material]{0}
[sliding]
load = "1 N"
press_steps = 1
distance = {2}
speed = "1 m/s"
[thermal]
regime = "steady"
displacement = false
source = {{ on = "upper", flux = "100 W/mm^2", {1} }}
[grid]
spacing = [{2}, {2}, {2}]
)toml",
                                          steel, source, half / cells));
}

/// A rigid ball, which takes no heat, rolls over steel without friction, and a source moves with it.
RollingCase moving_source(const std::string& source, double peclet, double cells)
{
  return case_of<RollingCase>(fmt::format(R"toml(
scenario = "rolling"
lower.shape.type = "flat"
upper.shape = {{ type = "sphere", radius = "10 mm" }}
upper.material.rigid = true
[lower.material]{0}
[rolling]
load = "1 N"
load_steps = 1
distance = {4}
speed = {2}
[thermal]
regime = "steady"
source = {{ on = "lower", flux = "100 W/mm^2", {1} }}
[grid]
spacing = [{3}, {3}, {3}]
)toml",
                                          steel, source, 2.0 * diffusivity * peclet / half, half / cells,
                                          2.0 * half / cells));
}

/// A strip of heat that moves with a rigid roller, in plane strain, until V^2 t/4 kappa is 12 or more.
RollingCase moving_strip(double peclet, double cells)
{
  return case_of<RollingCase>(fmt::format(R"toml(
scenario = "rolling"
lower.shape.type = "flat"
upper.shape = {{ type = "cylinder", radius = "10 mm" }}
upper.material.rigid = true
[lower.material]{0}
[rolling]
load = "100 kN"
load_steps = 1
distance = {2}
speed = {1}
[thermal]
source = {{ on = "lower", flux = "100 W/mm^2", shape = "rectangle", length = "0.2 mm" }}
[grid]
spacing = [{3}, "1 m", {3}]
boundary = "periodic_y"
)toml",
                                          steel, 2.0 * diffusivity * peclet / half, half * std::max(4.0, 24.0 / peclet),
                                          half / cells));
}

constexpr double coarse = 8.0, fine = 16.0; ///< cells to the half-width

TEST(FlashTemperature, SourcesAtRest)
{
  constexpr double unit = flux * half / conductivity;
  std::vector<double> of_square, of_disc, of_mean;
  for (const double cells : {coarse, fine})
  {
    const Rises angular = rises_of(source_at_rest(square, cells), 2)[1];
    const Rises round = rises_of(source_at_rest(disc, cells), 2)[1];
    of_square.push_back(angular.in_the_middle() / unit / (4.0 / pi * std::asinh(1.0)));
    of_disc.push_back(round.in_the_middle() / unit);
    of_mean.push_back(round.mean() / unit / (8.0 / (3.0 * pi)));
    // The edges pass through cells, whose flux is spread over all of the cell: second order. The mean is taken from the middles of the
    // cells, between which the slope of the rise has a logarithm at the rim.
    const double cell2 = 1.0 / (cells * cells);
    const std::string mesh = fmt::format("{} cells, ", cells), origin = "exact: Carslaw and Jaeger (1959)";
    test::expect_close(mesh + "middle of a square / 1.1222 q a/K", of_square.back(), 1.0, 0.25 * cell2, origin);
    test::expect_close(mesh + "middle of a disc / (q a/K)", of_disc.back(), 1.0, 0.25 * cell2, origin);
    test::expect_close(mesh + "mean over a disc / (8 q a/(3 pi K))", of_mean.back(), 1.0, cell2, origin);
  }
  expect_order("middle of a square", of_square, 1.9, 2.1, "cells that the edges cut");
  expect_order("middle of a disc", of_disc, 1.9, 2.1, "cells that the edge cuts");
  expect_order("mean over a disc", of_mean, 1.6, 2.0, "second, less a logarithm at the rim");
}

/// What two meshes give of a source that moves, against its exact steady rise.
struct Comparison
{
  std::string name;
  std::function<Rises(double)> computed; ///< with so many cells to the half-width
  std::function<double(double)> exact;   ///< at x, in half-widths
  double half_width = half;
};

/// Tolerances of a comparison, in powers of the cell over the half-width.
struct Bounds
{
  double middle, largest, largest_power, place, place_power;
};

/// Far from its edge the rise under a source is right to second order. The peak of a slow source is as smooth. That of a fast one is
/// narrower than a cell, kappa/V wide, and lies at the trailing edge: the hottest cell misses up to a cell of the way over which
/// heat has entered, and the rise goes with the root of this way.
Bounds bounds(double peclet)
{
  if (peclet > 50.0)
    return {0.25, 0.5, 1.0, 1.5, 1.0};
  if (peclet > 5.0)
    return {0.25, 3.0, 2.0, 1.5, 1.0};
  return {0.25, 0.5, 2.0, 2.0, 2.0};
}

/// @returns the ratios to the exact values in the middle and of the largest rise, on both meshes
std::array<std::vector<double>, 2> compare(const Comparison& c, const Bounds& b, const std::string& origin)
{
  const Peak peak = test::largest_rise(-1.0, 1.0, c.exact);
  std::array<std::vector<double>, 2> ratios;
  for (const double cells : {coarse, fine})
  {
    const Rises r = c.computed(cells);
    const std::string name = fmt::format("{}, {} cells: ", c.name, cells);
    ratios[0].push_back(r.in_the_middle() / c.exact(0.0));
    ratios[1].push_back(r.largest() / peak.rise);
    test::expect_close(name + "rise in the middle / exact", ratios[0].back(), 1.0, b.middle / (cells * cells), origin);
    test::expect_close(name + "largest rise / exact", ratios[1].back(), 1.0,
                       b.largest * std::pow(cells, -b.largest_power), origin);
    test::expect_close(name + "place of the largest rise, in half-widths", r.hottest_place() / c.half_width, peak.place,
                       b.place * std::pow(cells, -b.place_power), origin);
  }
  return ratios;
}

template <typename Source>
void compare_with_point_sources(const std::string& name, const std::string& shape, const Source& source)
{
  for (const double peclet : {0.1, 1.0, 10.0, 100.0})
  {
    const auto ratios =
        compare({fmt::format("{}, Pe = {}", name, peclet),
                 [&](double cells) { return rises_of(moving_source(shape, peclet, cells), 2)[0]; },
                 [&](double x) { return test::moving_rise(source, x * half, peclet / half, conductivity); }},
                bounds(peclet), "exact: Jaeger's (1942) point source, integrated");
    expect_order(fmt::format("{}, Pe = {}, rise in the middle", name, peclet), ratios[0], 1.9, 2.1,
                 "cells that the edge cuts");
  }
}

TEST(FlashTemperature, MovingSquare)
{
  compare_with_point_sources("square", square, test::UniformRectangle{half, half, flux});
}

TEST(FlashTemperature, MovingDisc)
{
  compare_with_point_sources("disc", disc, test::UniformDisc{half, flux});
}

/// The square whose edges are those of cells is exact; here as the end of a transient.
TEST(FlashTemperature, TransientOfASquareEndsThere)
{
  const test::UniformRectangle source{half, half, flux};
  for (const double peclet : {0.1, 1.0, 10.0, 100.0})
  {
    const auto largest_error = [&](const Rises& r)
    {
      double error = 0.0;
      for (int i = 0; i < r.grid.nx; ++i)
        if (std::abs(r.grid.x(i)) < half)
          error =
              std::max(error, std::abs(r.at(i) - test::moving_rise(source, r.grid.x(i), peclet / half, conductivity)));
      return error / r.largest();
    };
    RollingCase c = moving_source(square, peclet, 5.5);
    const std::string name = fmt::format("square of 11 x 11 cells, Pe = {}: ", peclet);
    test::expect_within(name + "largest error / largest rise", largest_error(rises_of(c, 2)[0]), 0.0, 1e-8,
                        "exact: Jaeger's (1942) point source, integrated");
    // What heat of before t_e leaves, is of the order of e^{-V^2 t_e/4 kappa}: 2e-2, 3e-4, and less.
    c.heat.regime = elastoplastic::HeatRegime::transient;
    c.distance = half * (peclet < 0.5 ? 80.0 : peclet < 5.0 ? 16.0 : 4.0);
    if (peclet < 0.5)
      c.shift = 2.0 * half;
    // Where heat spreads by a third of a cell in a step, the memory does not represent the edges of cells.
    test::expect_within(name + "the same at the end of a transient",
                        largest_error(rises_of(c, 1 + simulation::plan(c).rolling_steps)[0]), 0.0,
                        peclet > 50.0 ? 5e-3 : 3e-4, "exact: Jaeger's (1942) point source, integrated");
  }
}

TEST(FlashTemperature, MovingStrip)
{
  for (const double peclet : {1.0, 10.0})
    compare({fmt::format("strip, Pe = {}", peclet),
             [&](double cells)
             {
               const RollingCase c = moving_strip(peclet, cells);
               return rises_of(c, 1 + simulation::plan(c).rolling_steps)[0];
             },
             [&](double x) { return test::moving_strip_rise(x * half, half, flux, peclet / half, conductivity); }},
            bounds(peclet), "exact: Jaeger (1942), the moving line integrated");
}

/// The case of cases/flash-temperature, at other speeds. An incompressible surface is not stretched by pressure, and shear does not
/// move its gap: the pressure is that of Hertz. The shear stretches the surface, which slips less at the front of the contact than at
/// its rear, by the slope of u_x = -pi q (4 - 3 nu) x^2/(32 G a) + ... (Johnson 1985, Eq. 3.91a).
TEST(FlashTemperature, MovingContactOfHertz)
{
  constexpr double load = 20.0, kappa = 50.0 / (7800.0 * 470.0), nu = 0.4999;
  const double radius = std::cbrt(0.75 * load * 10e-3 * (1.0 - nu * nu) / 200e9);
  for (const double peclet : {0.1, 1.0, 10.0, 100.0})
  {
    const double speed = 2.0 * kappa * peclet / radius;
    const double shear = 0.1 * 1.5 * load / (pi * radius * radius);
    const double tilt = pi * shear * (4.0 - 3.0 * nu) / (16.0 * 200e9 / (2.0 * (1.0 + nu)));
    const test::HertzianFlux source{radius, radius, shear * speed, tilt};
    const auto computed = [&](double cells)
    {
      const io::Case c =
          io::read_case(BRINELL_SOURCE_DIR "/cases/flash-temperature/case.toml",
                        {fmt::format("rolling.speed={}", speed), fmt::format("grid.resolution={:.1f}", cells),
                         fmt::format("lower.material.poisson_ratio={}", nu), "thermal.regime=steady",
                         "rolling.load_steps=1", "rolling.distance=0.1 mm"});
      return rises_of(std::get<RollingCase>(c.scenario), 3)[0]; // the first step that slides has not all of the slip
    };
    compare({fmt::format("contact, Pe = {}", peclet), computed,
             [&](double x) { return test::moving_rise(source, x * radius, peclet / radius, 50.0); }, radius},
            // Pressure and heat end with a root; both are right as means over the cells.
            {0.1, 0.5, 2.0, 1.5, 2.0}, "exact: Jaeger's (1942) point source, integrated");
  }
}

} // namespace
} // namespace brinell::verification::flash_temperature_test
