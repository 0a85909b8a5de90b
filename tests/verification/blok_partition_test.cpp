// SPDX-License-Identifier: BSD-3-Clause
#include "moving_heat.hpp"
#include "surface_rises.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <numbers>
#include <string>
#include <vector>

/// How two bodies share the heat of friction, from slow to fast contacts.
namespace brinell::verification::blok_partition_test
{
namespace
{

using simulation::RollingCase;
using test::HertzianFlux;

constexpr double pi = std::numbers::pi;
constexpr double load = 20.0, friction = 0.1, conductivity = 50.0, diffusivity = 1.25e-5;
/// Of an incompressible flat: shear does not move its gap, and the pressure is that of Hertz.
constexpr double poisson_ratio = 0.4999;
const double radius = std::cbrt(0.75 * load * 10e-3 * (1.0 - poisson_ratio * poisson_ratio) / 200e9);
constexpr double cells = 12.0; ///< to the radius

/// A rigid ball that rests over its contact slides over a flat; both conduct alike.
/// @param keys  of [thermal]
RollingCase sliding_pair(double peclet, const std::string& keys = "")
{
  return case_of<RollingCase>(fmt::format(R"toml(
scenario = "rolling"
[lower]
shape.type = "flat"
[lower.material]
young_modulus = "200 GPa"
poisson_ratio = {0}
thermal = {{ conductivity = "50 W/(m K)", density = "8000 kg/m^3", specific_heat = "500 J/(kg K)", expansion = 0.0 }}
[upper]
shape = {{ type = "sphere", radius = "10 mm" }}
[upper.material]
rigid = true
thermal = {{ conductivity = "50 W/(m K)", density = "8000 kg/m^3", specific_heat = "500 J/(kg K)" }}
[rolling]
load = "20 N"
load_steps = 1
distance = {1}
slide_to_roll = 2
speed = {2}
[interface]
friction = 0.1
[thermal]
regime = "steady"
displacement = false
{3}
[grid]
resolution = {4:.1f}
)toml",
                                          poisson_ratio, radius, 2.0 * diffusivity * peclet / radius, keys, cells));
}

/// After the step in which the bodies begin to slide, which takes some of the sliding to deform them.
constexpr int settled = 3;

HertzianFlux all_heat(double peclet)
{
  const double speed = 2.0 * diffusivity * peclet / radius;
  return {radius, radius, friction * 1.5 * load / (pi * radius * radius) * speed};
}

TEST(BlokPartition, AllOfTheHeatInOneBody)
{
  for (const double peclet : {1.0, 10.0, 100.0})
  {
    const HertzianFlux source = all_heat(peclet);
    const double at_rest = pi / 4.0 * source.flux * radius / conductivity;
    const double moving = test::largest_moving_rise(source, peclet / radius, conductivity).rise;
    const double rest = rises_of(sliding_pair(peclet, "partition = 0.0"), settled)[1].largest();
    const double motion = rises_of(sliding_pair(peclet, "partition = 1.0"), settled)[0].largest();
    const double both = rises_of(sliding_pair(peclet), settled)[0].largest();
    const std::string name = fmt::format("Pe = {}: ", peclet);
    // Of second order in the cell; a fast flux has its peak where the flux changes by more from cell to cell.
    test::expect_close(name + "all in the body at rest, largest rise / exact", rest / at_rest, 1.0, 2e-3,
                       "exact: pi/4 q a/K of the largest flux");
    test::expect_close(name + "all in the moving body, largest rise / exact", motion / moving, 1.0, 3e-3,
                       "exact: Jaeger's (1942) point source, integrated");
    test::expect_close(name + "one temperature, largest rise / Blok's rule", both * (1.0 / at_rest + 1.0 / moving), 1.0,
                       0.02, "Blok (1937): a rule, exact where the rises of both bodies have one shape");
  }
}

TEST(BlokPartition, EqualBodiesTakeHalves)
{
  // Heat between surfaces that roll: both move alike under it.
  RollingCase c = sliding_pair(5.0, R"(source = { shape = "contact", power = "1 W" })");
  c.slide_to_roll = 0.0;
  c.friction.coefficient = 0.0;
  test::expect_close("heat between rolling surfaces, share of a body", rises_of(c, settled)[1].heat, 0.5, 1e-6,
                     "exact: both move alike; the shares are found to 1e-6");
  // A slow flux has e^{-V (r + x)/2 kappa} = 1 - V (r + x)/2 kappa: the moving body is colder by Q V/4 pi kappa K, and the disc of
  // the contact, of which the conductance is 4 K a, passes that much heat to it.
  constexpr double peclet = 0.01;
  test::expect_close("share of the body at rest, Pe = 0.01", rises_of(sliding_pair(peclet), settled)[1].heat,
                     0.5 - peclet / (2.0 * pi), 0.02 * peclet / (2.0 * pi),
                     "exact: 1/2 - Pe/2 pi, with the next order 0.4 % of the difference, and cells");
}

/// Share of the body at rest times the root of the Peclet number, for fast contacts. The moving body then takes nearly all of the heat
/// and has the rise T; so has the body at rest in the contact, and no flux beside it. By reciprocity with the flux 2 K/(pi sqrt(a^2 - r^2))
/// of a disc at the temperature 1, its heat is the integral of both. T = (2/K) sqrt(kappa/pi V) int q(x + w^2) dw (Jaeger 1942).
double share_of_a_fast_contact()
{
  const test::Gauss quarter(60, 0.0, 0.5 * pi), half(60, 0.0, pi);
  // Along each chord of half-length c, T goes with c^(3/2), and (a^2 - r^2) is c^2 - x^2.
  const auto rise = [&](double x)
  {
    const double end = std::sqrt(1.0 - x);
    double sum = 0.0;
    for (std::size_t n = 0; n < quarter.point.size(); ++n)
    {
      const double w = end * std::sin(quarter.point[n]), source = x + w * w;
      sum += quarter.weight[n] * end * std::cos(quarter.point[n]) * std::sqrt(std::max(0.0, 1.0 - source * source));
    }
    return sum;
  };
  double along = 0.0, across = 0.0;
  for (std::size_t n = 0; n < half.point.size(); ++n)
    along += half.weight[n] * rise(-std::cos(half.point[n]));
  for (std::size_t n = 0; n < quarter.point.size(); ++n)
    across += 2.0 * quarter.weight[n] * std::pow(std::cos(quarter.point[n]), 2.5);
  const double heat = 2.0 / 3.0 * pi; // of the largest flux 1 and the radius 1
  return 2.0 / pi * 2.0 / std::sqrt(2.0 * pi) * along * across / heat;
}

TEST(BlokPartition, AFastContactHeatsTheBodyAtRestByTheRootOfItsSpeed)
{
  std::vector<double> ratio;
  for (const double peclet : {400.0, 1600.0})
  {
    const double share = rises_of(sliding_pair(peclet), settled)[1].heat;
    ratio.push_back(share / (1.0 - share) * std::sqrt(peclet));
  }
  test::expect_close("heat at rest / heat in motion, Pe = 400 over 1600", 2.0 * ratio[0] / ratio[1], 2.0, 0.04,
                     "limit of great speeds: sqrt(1600/400), with 1.1 % of the next order");
  // The next order goes with 1/sqrt(Pe), but for a logarithm.
  test::expect_close("the same times sqrt(Pe), from both to infinite speed", 2.0 * ratio[1] - ratio[0],
                     share_of_a_fast_contact(), 0.01 * share_of_a_fast_contact(),
                     "exact limit: Jaeger's (1942) fast source, and reciprocity with an isothermal disc");
}

/// The rail of Ertz and Knothe (2002): an elliptical contact under 100 kN that passes over the rail at 30 m/s, while the wheel passes it at
/// 29 m/s. Their flux is friction x pressure x the 1 m/s; bodies a hundred times as stiff as steel, under a hundred times the radii,
/// have that contact and do not change the slip by being strained.
struct Rail
{
  static constexpr double a = 5.88e-3, b = 10.54e-3, load = 100e3, friction = 0.3, speed = 30.0, other_speed = 29.0;
  static constexpr double kappa = 50.0 / (7850.0 * 450.0);
  double young_modulus = 20e12;
  std::string upper_thermal =
      R"toml(conductivity = "50 W/(m K)", density = "7850 kg/m^3", specific_heat = "450 J/(kg K)")toml";

  [[nodiscard]] double largest_pressure() const { return 1.5 * load / (pi * a * b); }
  /// Johnson (1985), Eqs. 4.26.
  [[nodiscard]] RollingCase rolling(double per_half_width, const std::string& keys) const
  {
    const double modulus = 0.5 * young_modulus / (1.0 - 0.3 * 0.3), e = std::sqrt(1.0 - a * a / (b * b));
    const double K = std::comp_ellint_1(e), E = std::comp_ellint_2(e);
    const double curvature = 2.0 * largest_pressure() / modulus * a / (e * e * b * b);
    return case_of<RollingCase>(fmt::format(
        R"toml(
scenario = "rolling"
[lower]
shape.type = "flat"
[lower.material]
young_modulus = {0}
poisson_ratio = 0.3
thermal = {{ conductivity = "50 W/(m K)", density = "7850 kg/m^3", specific_heat = "450 J/(kg K)", expansion = 0.0 }}
[upper]
shape = {{ type = "ellipsoid", radius_x = {1}, radius_y = {2} }}
[upper.material]
young_modulus = {0}
poisson_ratio = 0.3
thermal = {{ {3}, expansion = 0.0 }}
[rolling]
load = "100 kN"
load_steps = 1
distance = "4 mm"
speed = "30 m/s"
slide_to_roll = {4}
[interface]
friction = 0.3
[thermal]
regime = "steady"
displacement = false
{5}
[grid]
spacing = [{6}, {7}, {6}]
)toml",
        young_modulus, 1.0 / (curvature * (b * b / (a * a) * E - K)), 1.0 / (curvature * (K - E)), upper_thermal,
        (speed - other_speed) / (0.5 * (speed + other_speed)), keys, a / per_half_width, 2.0 * b / per_half_width));
  }
  /// Largest rise with all of the heat in a body that passes at that speed.
  [[nodiscard]] double all_in_one(double of_body) const
  {
    const HertzianFlux source{a, b, friction * largest_pressure() * (speed - other_speed)};
    return test::largest_moving_rise(source, of_body / (2.0 * kappa), 50.0).rise;
  }
};

TEST(BlokPartition, RailUnderASlidingWheel)
{
  const Rail rail;
  const double halves = 0.5 * rail.all_in_one(Rail::speed);
  const double one_temperature = 1.0 / (1.0 / rail.all_in_one(Rail::speed) + 1.0 / rail.all_in_one(Rail::other_speed));
  for (const double per_half_width : {8.0, 16.0})
  {
    const double tolerance =
        0.25 / (per_half_width * per_half_width); // of second order, as the flux is a mean over cells
    const std::string name = fmt::format("rail of Ertz and Knothe, {} cells to the half-width: ", per_half_width);
    const std::string origin = "exact: Jaeger's (1942) point source, integrated over their ellipse";
    test::expect_close(name + "rise in K, halves to both bodies",
                       rises_of(rail.rolling(per_half_width, "partition = 0.5"), settled)[0].largest(), halves,
                       tolerance * halves, origin);
    test::expect_close(name + "rise in K, one temperature",
                       rises_of(rail.rolling(per_half_width, ""), settled)[1].largest(), one_temperature,
                       tolerance * one_temperature, origin + "; CONTACT prints 166.8 degC");
  }
}

TEST(BlokPartition, FastBodiesShareByTheirConstants)
{
  Rail rail;
  rail.upper_thermal =
      R"toml(conductivity = "20 W/(m K)", density = "3200 kg/m^3", specific_heat = "700 J/(kg K)")toml";
  const double steel = std::sqrt(50.0 * 7850.0 * 450.0 * Rail::speed),
               ceramic = std::sqrt(20.0 * 3200.0 * 700.0 * Rail::other_speed);
  test::expect_close("share of a steel rail under a ceramic wheel", rises_of(rail.rolling(8.0, ""), settled)[0].heat,
                     steel / (steel + ceramic), 1e-3, "limit of great speeds: as sqrt(K rho c V); Pe = 6000");
}

} // namespace
} // namespace brinell::verification::blok_partition_test
