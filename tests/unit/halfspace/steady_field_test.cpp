// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/halfspace/steady_field.hpp"
#include "brinell/halfspace/thermal_response.hpp"

#include "grid_fields.hpp"
#include "order.hpp"
#include "steady_heat.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <cstdio>
#include <numbers>
#include <vector>

/// A flux that has always moved over an elastic half space.
namespace brinell::halfspace::steady_field_test
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
const double kappa = body.diffusivity(), nu = elastic.poisson_ratio, E_alpha = elastic.young_modulus * body.expansion;

template <typename Call>
void expect_refusal(const Call& call, const std::string& part)
{
  try
  {
    call();
    ADD_FAILURE() << "not refused: " << part;
  }
  catch (const InputError& error)
  {
    EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
  }
}

TEST(SteadyField, DiscAtRest)
{
  // Barber (1971): d^2u/dr^2 + du/dr/r = alpha (1 + nu) q/K under the flux, and a logarithm beside it. Steady heat leaves no
  // stress but along the surface, sigma_xx = -E alpha T ky^2/k^2 of each wave: Hankel's transform.
  const double q = 2.0, z = 0.5, reference = 7.0;
  std::vector<double> errors, stresses;
  for (const int n : {21, 41, 81})
  {
    const SurfaceGrid g{n, n, 3.0 / n, 3.0 / n};
    Field flux = test::disc(g);
    for (double& value : flux)
      value *= q;
    const SteadyField field(g, body, elastic, {0.0, reference}, {z});
    const Field u = displacement_of(field, flux);
    const double unit = body.expansion * (1.0 + nu) * q / body.conductivity;
    double error = 0.0, none = 0.0;
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i)
      {
        const double r = std::hypot(g.x(i), g.y(j));
        const double exact = unit * ((r < 1.0 ? 0.25 * r * r - 0.25 : 0.5 * std::log(r)) - 0.5 * std::log(reference));
        error = std::max(error, std::abs(u[g.index(i, j)] - exact));
      }
    errors.push_back(error / unit);
    const Layer layer = layers_of(field, flux).front();
    for (std::size_t i = 0; i < g.size(); ++i)
    {
      const SymTensor& s = layer.stress[i];
      none = std::max({none, std::abs(s[0] + s[1] + E_alpha * layer.temperature[i]), std::abs(s[2]), std::abs(s[3]),
                       std::abs(s[4])});
    }
    EXPECT_LT(none, 1e-3 * E_alpha * q / body.conductivity);
    error = 0.0;
    const auto hankel = [&](int order, double r)
    {
      double sum = 0.0;
      for (int p = 0; p < 60; ++p)
      {
        const test::Gauss k(8, p, p + 1.0);
        for (std::size_t m = 0; m < k.point.size(); ++m)
          sum += k.weight[m] * j1(k.point[m]) * std::exp(-k.point[m] * z) * jn(order, k.point[m] * r) / k.point[m];
      }
      return q / body.conductivity * sum;
    };
    for (const int i : {n / 2, n / 2 + n / 6, n - 1})
    {
      const double r = g.x(i), mean = hankel(0, r), difference = hankel(2, r);
      const std::size_t here = g.index(i, n / 2);
      error = std::max({error, std::abs(layer.temperature[here] - mean),
                        std::abs(layer.stress[here][0] / E_alpha + 0.5 * (mean + difference)),
                        std::abs(layer.stress[here][1] / E_alpha + 0.5 * (mean - difference))});
    }
    stresses.push_back(error * body.conductivity / q);
  }
  const test::Orders bulge("bulge of a heated disc", errors), stress("stress below it", stresses);
  EXPECT_LT(errors.back(), 1e-3);
  EXPECT_GT(bulge.overall, 1.2);
  EXPECT_LT(stresses.back(), 2e-3);
  EXPECT_GT(stress.overall, 1.0);
}

TEST(SteadyField, LineThatMoves)
{
  // Of a line far behind all heat is a skin that has swollen by 2 (1 + nu) alpha times the heat per area; ahead there is nothing yet. Near it
  // lines of heat, each spread since then.
  const SurfaceGrid g{128, 1, 0.05, 1.0, Boundary::open, Boundary::periodic};
  const double width = 0.2;
  for (const double velocity : {1.0, 20.0, 400.0})
  {
    const Field flux = test::sampled(g, [&](int i, int) { return std::exp(-std::pow(g.x(i) / width, 2)); });
    const SteadyField field(g, body, elastic, {velocity, {}}, {0.0, 0.1});
    const Field u = displacement_of(field, flux);
    const std::vector<Layer> layers = layers_of(field, flux);
    const double skin =
        2.0 * (1.0 + nu) * body.expansion * std::sqrt(pi) * width / velocity * kappa / body.conductivity;
    double error = 0.0, warm = 0.0;
    for (const int i : {4, 40, 63, 80, 120})
    {
      // The wave k of u is -2 (1 + nu) alpha q/(K s (s + k)): its imaginary part goes like 1/k.
      const std::complex<double> turn(0.0, velocity / kappa);
      double sum = 0.0;
      double last = 0.0;
      for (double next = 1e-8; last < 12.0 / width; next = std::min(1.3 * next, next + 0.3))
      {
        const test::Gauss k(8, last, next);
        for (std::size_t m = 0; m < k.point.size(); ++m)
        {
          const std::complex<double> s = std::sqrt(k.point[m] * (k.point[m] - turn));
          sum += k.weight[m] * std::exp(-0.25 * std::pow(k.point[m] * width, 2)) *
                 (std::polar(1.0, k.point[m] * g.x(i)) / (s * (s + k.point[m]))).real();
        }
        last = next;
      }
      // The wave k = 0 stands for half of the skin: nothing ahead, all of it behind.
      const double exact =
          -2.0 * (1.0 + nu) * body.expansion / body.conductivity * width / std::sqrt(pi) * sum - 0.5 * skin;
      error = std::max(error, std::abs(u[g.index(i, 0)] - exact));
      const double temperature =
          kappa / body.conductivity *
          over_time(0.0, 400.0 * kappa / (velocity * velocity) + 20.0 / velocity,
                    [&](double t)
                    {
                      const double wide = width * width + 4.0 * kappa * t, x = g.x(i) + velocity * t;
                      return width / std::sqrt(wide) * std::exp(-x * x / wide - 0.01 / (4.0 * kappa * t)) /
                             std::sqrt(pi * kappa * t);
                    });
      warm = std::max(warm, std::abs(layers[1].temperature[g.index(i, 0)] - temperature));
    }
    std::printf("line at %g: displacement %.1e of the skin, temperature %.1e; ahead %.3f, behind %.3f of the skin\n",
                velocity, error / skin, warm / test::largest(layers[0].temperature), -u.back() / skin,
                -u.front() / skin);
    EXPECT_LT(error, 1e-3 * skin);
    EXPECT_LT(warm, 1e-5 * test::largest(layers[0].temperature));
  }
}

TEST(SteadyField, LargerGridsHaveTheSame)
{
  const SurfaceGrid g{24, 16, 0.1, 0.1};
  SurfaceGrid larger = g;
  larger.nx *= 3;
  larger.ny *= 3;
  for (const double velocity : {0.0, 0.5, 5.0, 500.0})
  {
    const SteadyMotion motion{velocity, 1.0};
    const SteadyField own(g, body, elastic, motion, {0.0, 0.2}), wide(larger, body, elastic, motion, {0.0, 0.2});
    const Field flux =
        test::sampled(g, [&](int i, int j)
                      { return std::pow(std::sin(pi * (i + 0.5) / g.nx) * std::sin(pi * (j + 0.5) / g.ny), 2); });
    Field around(larger.size());
    for (int j = 0; j < g.ny; ++j)
      for (int i = 0; i < g.nx; ++i)
        around[larger.index(i + g.nx, j + g.ny)] = flux[g.index(i, j)];
    const Field u = displacement_of(own, flux), v = displacement_of(wide, around);
    const std::vector<Layer> a = layers_of(own, flux), b = layers_of(wide, around);
    double displaced = 0.0, stressed = 0.0, largest = 0.0;
    for (int j = 0; j < g.ny; ++j)
      for (int i = 0; i < g.nx; ++i)
      {
        const std::size_t here = g.index(i, j), there = larger.index(i + g.nx, j + g.ny);
        displaced = std::max(displaced, std::abs(u[here] - v[there]));
        for (std::size_t d = 0; d < 2; ++d)
          for (std::size_t c = 0; c < 6; ++c)
          {
            stressed = std::max(stressed, std::abs(a[d].stress[here][c] - b[d].stress[there][c]));
            largest = std::max(largest, std::abs(a[d].stress[here][c]));
          }
      }
    std::printf("velocity %g: displacement %.1e, stress %.1e\n", velocity, displaced / test::largest(u),
                stressed / largest);
    EXPECT_LT(displaced, 1e-4 * test::largest(u));
    EXPECT_LT(stressed, 1e-4 * largest);
  }
}

TEST(SteadyField, TransientEndsThere)
{
  // A spot that comes along a track; what entered before that is felt as displacement and stress for long, and is added by pulses.
  const double width = 0.4;
  for (const double peclet : {0.1, 1.0, 10.0})
  {
    const SurfaceGrid g{96, 24, 0.1, 0.1};
    const double velocity = peclet * 2.0 * kappa / width, way = 4.0;
    const double duration = way / velocity;
    const Field flux = test::sampled(
        g, [&](int i, int j) { return std::exp(-(std::pow(g.x(i) - 1.5, 2) + g.y(j) * g.y(j)) / (width * width)); });
    ThermalField transient(g, body, elastic, {duration / 8.0, duration}, {0.0});
    for (int n = 1; n <= 8; ++n)
    {
      const double x = 1.5 + way * (n - 8) / 8.0;
      transient.add_step(
          test::sampled(g, [&](int i, int j)
                        { return std::exp(-(std::pow(g.x(i) - x, 2) + g.y(j) * g.y(j)) / (width * width)); }),
          {duration / 8.0, velocity});
    }
    const SteadyField steady(g, body, elastic, {velocity, {}}, {0.0});
    const Field u = displacement_of(steady, flux), before = test::displacement_of(transient);
    const double end = 1e4 * (kappa / (velocity * velocity) + g.nx * g.dx / velocity);
    const Layer now = layers_of(steady, flux).front(), then = test::layer_of(transient, 0);
    double displaced = 0.0, stressed = 0.0;
    for (const int i : {50, 62, 75})
    {
      const std::size_t n = g.index(i, 11);
      const auto rest = [&](auto what)
      {
        return over_time(duration, end,
                         [&](double t)
                         { return what(Pulse(width, t), std::hypot(g.x(i) - 1.5 + velocity * t, g.y(11))); });
      };
      const double of_displacement = rest([](const Pulse& p, double r) { return p.displacement(r); });
      const double of_stress = rest([](const Pulse& p, double r) { return p.stress(r); });
      displaced = std::max(displaced, std::abs(before[n] + of_displacement - u[n]));
      stressed = std::max(
          stressed, std::abs(then.stress[n][0] + then.stress[n][1] + of_stress - now.stress[n][0] - now.stress[n][1]));
    }
    const double largest = test::largest(now.temperature);
    std::printf("Pe %g: displacement %.1e, stress %.1e, temperature %.1e\n", peclet, displaced / test::largest(u),
                stressed / (E_alpha * largest), test::largest_difference(now.temperature, then.temperature) / largest);
    EXPECT_LT(displaced, 5e-4 * test::largest(u));
    EXPECT_LT(stressed, 1e-3 * E_alpha * largest);
  }
}

TEST(SteadyField, AResponseIsTheSame)
{
  const SurfaceGrid g{20, 12, 0.1, 0.1};
  for (const double velocity : {0.0, -2.0})
  {
    const ThermalResponse response(g, body, elastic, {.velocity_x = velocity}, 3.0);
    auto scratch = response.make_scratch();
    const Field flux = spot(g, 0.3);
    Field own(g.size());
    response.apply(flux, {own, {}, {}}, scratch);
    EXPECT_LT(test::largest_difference(own, displacement_of(SteadyField(g, body, elastic, {velocity, 3.0}), flux)),
              1e-12 * test::largest(own));
  }
}

TEST(SteadyField, RefusesWhatThereIsNot)
{
  const SurfaceGrid g{8, 8, 1.0, 1.0};
  SurfaceGrid along = g, across = g;
  along.boundary_x = Boundary::periodic;
  across.boundary_y = Boundary::periodic;
  expect_refusal([&] { SteadyField(along, body, elastic, {1.0, {}}); }, "there is no steady state");
  expect_refusal([&] { SteadyField(across, body, elastic, {0.0, 1.0}); }, "there is no steady state");
  expect_refusal([&] { SteadyField(g, body, elastic, {1.0, -1.0}); }, "a reference of -1 m");
  expect_refusal([&] { SteadyField(g, body, elastic, {1.0, {}}, {-1.0}); }, "a depth of -1 m");
  const SteadyField at_rest(g, body, elastic, {0.0, {}});
  Field field(g.size());
  expect_refusal([&] { at_rest.displacement(field, field); }, "allowed: a reference");
}

} // namespace
} // namespace brinell::halfspace::steady_field_test
