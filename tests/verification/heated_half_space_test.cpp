// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/halfspace/thermal_field.hpp"

#include "grid_fields.hpp"
#include "heated_body.hpp"
#include "order.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

/// A half space without ends that is heated for long, or by a spot that moves, against closed forms.
namespace brinell::halfspace::heated_half_space_test
{
namespace
{

using test::displacement_of;
using test::Field;
using Layer = test::HeatedLayer;
using test::layer_of;
using test::over_past;
using test::over_wavenumbers;

const Thermal& body = test::heated_body;
const Elastic& elastic = test::heated_elastic;
const double kappa = body.diffusivity(), nu = elastic.poisson_ratio;

TEST(ThermalField, DiscThatIsHeatedForLong)
{
  // Barber (1971): d^2u/dr^2 + du/dr/r = alpha (1 + nu) q/K under the flux, and a logarithm beside it. Steady heat leaves no
  // stress but along the surface, xx + yy = -E alpha T. Some (a/sqrt(kappa t))^2 is missing of the former, the root of that of T.
  const double spread = 500.0, q = 2.0;
  std::vector<double> errors;
  for (const int n : {21, 41, 81})
  {
    const SurfaceGrid g{n, n, 3.0 / n, 3.0 / n};
    const double duration = spread * spread / kappa;
    ThermalField field(g, body, elastic, {duration / 10.0, duration}, {0.5});
    Field flux = test::disc(g);
    for (double& value : flux)
      value *= q;
    for (int step = 0; step < 10; ++step)
      field.add_step(flux, {duration / 10.0});
    const Field u = displacement_of(field);
    const double middle = u[g.index(n / 2, n / 2)], unit = body.expansion * (1.0 + nu) * q / body.conductivity;
    double error = 0.0;
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i)
      {
        const double r = std::hypot(g.x(i), g.y(j));
        const double exact = unit * (r < 1.0 ? 0.25 * r * r : 0.25 + 0.5 * std::log(r));
        error = std::max(error, std::abs(u[g.index(i, j)] - middle - exact));
      }
    errors.push_back(error / unit);
    const Layer layer = layer_of(field, 0);
    const double E_alpha = elastic.young_modulus * body.expansion;
    double stress = 0.0;
    for (std::size_t i = 0; i < g.size(); ++i)
    {
      const SymTensor& s = layer.stress[i];
      stress = std::max({stress, std::abs(s[0] + s[1] + E_alpha * layer.temperature[i]), std::abs(s[2]), std::abs(s[3]),
                         std::abs(s[4])});
    }
    EXPECT_LT(stress, E_alpha * q / body.conductivity / spread);
  }
  const test::Orders orders("curvature of a heated disc", errors);
  EXPECT_LT(errors.back(), 1e-3);
  EXPECT_GT(orders.overall, 1.2);
}

TEST(ThermalField, SpotThatMoves)
{
  // Pulses of a Gaussian flux along the way, each spread since then: Hankel's transform in space, Gauss's rule in time.
  const SurfaceGrid g{60, 40, 0.1, 0.1};
  const double w = 0.5, velocity = 3.0, duration = 0.1, end = 1.0;
  const int steps = 8;
  ThermalField field(g, body, elastic, {duration, steps * duration});
  for (int n = 1; n <= steps; ++n)
  {
    const double x = end + velocity * duration * (n - steps);
    field.add_step(test::sampled(g, [&](int i, int j)
                                 { return std::exp(-(std::pow(g.x(i) - x, 2) + g.y(j) * g.y(j)) / (w * w)); }),
                   {duration, velocity});
  }
  const Field u = displacement_of(field);
  double error = 0.0;
  for (const int i : {10, 20, 35, 40, 46, 58})
    for (const int j : {12, 20})
    {
      const auto pulse = [&](double t)
      {
        const double r = std::hypot(g.x(i) - end + velocity * t, g.y(j));
        return over_wavenumbers(
            w, r,
            [&](double k)
            { return 0.5 * w * w * k * std::exp(-0.25 * k * k * w * w) * std::erfc(k * std::sqrt(kappa * t)); });
      };
      const double exact =
          -2.0 * (1.0 + nu) * body.expansion * kappa / body.conductivity * over_past(steps * duration, pulse);
      error = std::max(error, std::abs(u[g.index(i, j)] - exact));
    }
  std::printf("a spot that moves: %.1e\n", error / test::largest(u));
  EXPECT_LT(error, 1e-4 * test::largest(u));
}

} // namespace
} // namespace brinell::halfspace::heated_half_space_test
