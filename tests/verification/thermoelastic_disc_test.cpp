// SPDX-License-Identifier: BSD-3-Clause
#include "grid_fields.hpp"
#include "record.hpp"
#include "steady_heat.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <numbers>
#include <string>
#include <vector>

/// A half space that is heated on a disc: its bulge and its stress (Barber 1971).
namespace brinell::verification::thermoelastic_disc_test
{
namespace
{

using test::displacement_of;
using test::Field;
using test::layer_of;
using test::layers_of;

constexpr double pi = std::numbers::pi, flux = 2.0, reference = 7.0;
const Thermal& body = test::heated_body;
const Elastic& elastic = test::heated_elastic;
const double nu = elastic.poisson_ratio;
const double stress_unit = elastic.young_modulus * body.expansion * flux / body.conductivity; // E alpha q a/K, a = 1
const std::vector<double> depths{0.0, 0.25, 0.5, 1.0, 3.0};

Field heated_disc(const SurfaceGrid& grid)
{
  Field q = test::disc(grid);
  for (double& value : q)
    value *= flux;
  return q;
}

/// Largest zz, xz and yz of a layer over E alpha q a/K.
double largest_traction(const std::vector<SymTensor>& stress)
{
  double largest = 0.0;
  for (const SymTensor& s : stress)
    largest = std::max({largest, std::abs(s[2]), std::abs(s[3]), std::abs(s[4])});
  return largest / stress_unit;
}

/// Of the surface into the body: within the disc a paraboloid, outside a logarithm, and nothing at the reference.
double exact_displacement(double r)
{
  const double unit = (1.0 + nu) * body.expansion * flux / body.conductivity;
  return unit * ((r < 1.0 ? 0.25 * (r * r - 1.0) : 0.5 * std::log(r)) - 0.5 * std::log(reference));
}

constexpr double coarse = 8.0, fine = 16.0; ///< cells to the radius

SurfaceGrid three_radii(double cells)
{
  const int n = static_cast<int>(3.0 * cells) + 1;
  return {n, n, 1.0 / cells, 1.0 / cells};
}

TEST(ThermoelasticDisc, SteadyBulge)
{
  const double curvature = (1.0 + nu) * body.expansion * flux / (2.0 * body.conductivity);
  std::vector<double> errors;
  for (const double cells : {coarse, fine})
  {
    const SurfaceGrid g = three_radii(cells);
    const Field u = displacement_of(halfspace::SteadyField(g, body, elastic, {0.0, reference}), heated_disc(g));
    double error = 0.0;
    for (int j = 0; j < g.ny; ++j)
      for (int i = 0; i < g.nx; ++i)
        error = std::max(error, std::abs(u[g.index(i, j)] - exact_displacement(std::hypot(g.x(i), g.y(j)))));
    errors.push_back(error / std::abs(exact_displacement(0.0)));
    // Over half of the radius, far from the rim, at which the flux is cut by cells.
    const int middle = g.nx / 2, away = static_cast<int>(0.5 * cells);
    const double span = away * g.dx;
    const double bend =
        (u[g.index(middle + away, middle)] - 2.0 * u[g.index(middle, middle)] + u[g.index(middle - away, middle)]) /
        (span * span);
    const std::string name = fmt::format("{} cells to the radius: ", cells);
    test::expect_close(name + "curvature of the bulge / ((1 + nu) alpha q/2 K)", bend / curvature, 1.0,
                       0.05 / (cells * cells), "exact: Barber (1971)");
    test::expect_close(name + "largest error of the displacement / that in the middle", errors.back(), 0.0,
                       0.1 / (cells * cells), "exact: Barber (1971), paraboloid and logarithm");
  }
  test::expect_within("displacement, order", std::log2(errors[0] / errors[1]), 1.6, 2.6, "cells that the rim cuts");
}

TEST(ThermoelasticDisc, SteadyStress)
{
  for (const double cells : {coarse, fine})
  {
    const SurfaceGrid g = three_radii(cells);
    const halfspace::SteadyField field(g, body, elastic, {0.0, reference}, depths);
    const auto layers = layers_of(field, heated_disc(g));
    double none = 0.0, along = 0.0, axis = 0.0;
    for (std::size_t d = 0; d < depths.size(); ++d)
    {
      none = std::max(none, largest_traction(layers[d].stress));
      for (std::size_t i = 0; i < g.size(); ++i)
      {
        const double thermal = elastic.young_modulus * body.expansion * layers[d].temperature[i];
        along = std::max(along, std::abs(layers[d].stress[i][0] + layers[d].stress[i][1] + thermal) / stress_unit);
      }
      // On the axis xx = yy, and T = q/K (sqrt(a^2 + z^2) - z) (Carslaw and Jaeger 1959).
      const SymTensor& s = layers[d].stress[g.index(g.nx / 2, g.ny / 2)];
      const double exact = -0.5 * (std::hypot(1.0, depths[d]) - depths[d]);
      axis = std::max({axis, std::abs(s[0] / stress_unit - exact), std::abs(s[1] / stress_unit - exact)});
    }
    const std::string name = fmt::format("{} cells to the radius: ", cells);
    test::expect_within(name + "largest zz, xz and yz from the surface to 3 radii / (E alpha q a/K)", none, 0.0, 1e-9,
                        "exact: none in steady heat, Barber (1971); rounding, and waves that are interpolated");
    test::expect_within(name + "largest xx + yy + E alpha T / (E alpha q a/K)", along, 0.0, 1e-6,
                        "exact: Barber (1971); waves that are interpolated");
    test::expect_close(name + "xx and yy on the axis + E alpha T/2, largest / (E alpha q a/K)", axis, 0.0,
                       0.1 / (cells * cells), "exact: the disc's temperature, Carslaw and Jaeger (1959)");
  }
}

/// Bulge in the middle, by pulses of heat: one that has spread by s leaves erfc(k s) in the wave k, of which the disc has J_1(k a).
double exact_bulge(double duration)
{
  const double kappa = body.diffusivity();
  const auto of_pulse = [&](double time)
  {
    const double s = std::sqrt(kappa * time), end = 6.0 / s;
    if (s < 0.02)
      return 1.0 - 2.0 * s / std::sqrt(pi); // first terms
    const int pieces = 4 + static_cast<int>(end / 3.0);
    double sum = 0.0;
    for (int p = 0; p < pieces; ++p)
    {
      const test::Gauss k(8, end * p / pieces, end * (p + 1) / pieces);
      for (std::size_t n = 0; n < k.point.size(); ++n)
        sum += k.weight[n] * j1(k.point[n]) * std::erfc(k.point[n] * s);
    }
    return sum;
  };
  return -2.0 * (1.0 + nu) * body.expansion * flux * kappa / body.conductivity *
         test::over_time(0.0, duration, of_pulse);
}

TEST(ThermoelasticDisc, Transient)
{
  for (const double spread : {0.1, 0.5, 2.0})
  {
    const double duration = spread * spread / body.diffusivity(), exact = exact_bulge(duration);
    for (const double cells : {coarse, fine})
    {
      const SurfaceGrid g = three_radii(cells);
      halfspace::ThermalField field(g, body, elastic, {duration / 5.0, duration}, {0.0, 0.5});
      for (int step = 0; step < 5; ++step)
        field.add_step(heated_disc(g), {duration / 5.0});
      const std::string name = fmt::format("sqrt(kappa t) = {} radii, {} cells: ", spread, cells);
      test::expect_within(name + "largest zz, xz and yz of the surface / (E alpha q a/K)",
                          largest_traction(layer_of(field, 0).stress), 0.0, 1e-13,
                          "exact: free of traction, to rounding");
      EXPECT_GT(largest_traction(layer_of(field, 1).stress), 1e-3) << "in the body there are some";
      test::expect_close(name + "bulge in the middle / exact",
                         displacement_of(field)[g.index(g.nx / 2, g.ny / 2)] / exact, 1.0, 0.2 / (cells * cells),
                         "exact: pulses of heat (Mindlin and Cheng 1950), integrated");
    }
  }
}

} // namespace
} // namespace brinell::verification::thermoelastic_disc_test
