// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/halfspace/heat_response.hpp"

#include "brinell/foundation/error.hpp"
#include "gauss.hpp"
#include "grid_fields.hpp"
#include "order.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

/// Temperature of a surface under a flux that is constant while it stands or moves.
namespace brinell::halfspace::heat_response_test
{
namespace
{

constexpr double pi = std::numbers::pi;
constexpr double forever = std::numeric_limits<double>::infinity();
constexpr auto open = Boundary::open;
constexpr auto periodic = Boundary::periodic;
using test::Field;
using test::Gauss;

/// Conductivity 2, diffusivity 0.5: constants that do not drop out.
const Thermal body{2.0, 4.0, 1.0, 0.0};

Field temperature(const SurfaceGrid& g, const HeatMotion& motion, const Field& flux)
{
  const HeatResponse response(g, body, motion);
  HeatResponse::Scratch scratch = response.make_scratch();
  Field result(g.size());
  response.apply(flux, result, scratch);
  return result;
}

/// An independent quadrature of the moving point source (Carslaw and Jaeger 1959, section 10.7),
/// e^{-V (r + x)/2 kappa}/(2 pi K r), x from source to point along the motion: about the point (x, 0) in polar coordinates, which
/// take off the singularity, over a Hertzian flux that moves along x.
double moving_hertz(double x, double velocity)
{
  const double kappa = body.diffusivity();
  static const Gauss chord(40, -1.0, 1.0);
  double sum = 0.0;
  // Behind the point the exponential is e^{-V r (1 - cos)/2 kappa}: narrow about the direction of the wake.
  const double narrow = std::min(1.0, 2.0 * std::sqrt(kappa / velocity));
  // Rays along the edge of the disc are where the chords end.
  const double edge = std::asin(std::min(1.0, 1.0 / std::abs(x)));
  std::vector<double> ends{-pi,    edge - pi, -edge,     -narrow, -0.2 * narrow, 0.0, 0.2 * narrow,
                           narrow, edge,      pi - edge, pi};
  std::sort(ends.begin(), ends.end());
  for (std::size_t e = 0; e + 1 < ends.size(); ++e)
  {
    const Gauss angle(24, ends[e], ends[e + 1]);
    for (std::size_t a = 0; a < angle.point.size(); ++a)
    {
      // Along the ray x + r cos, r sin the flux is that of a chord; substituting its angle smooths its ends.
      const double c = std::cos(angle.point[a]), s = std::sin(angle.point[a]);
      const double half2 = 1.0 - x * x * s * s;
      if (half2 <= 0.0)
        continue;
      const double middle = -x * c, half = std::sqrt(half2);
      const double from = std::max(0.0, middle - half), to = middle + half;
      if (to <= from)
        continue;
      const double first = std::asin(std::clamp((from - middle) / half, -1.0, 1.0));
      double inner = 0.0;
      // The front of the flux is met over a length of kappa/V.
      const double begin = from,
                   layer = std::min(0.5 * (to - from), 20.0 * kappa / (velocity * std::max(1e-3, 1.0 - c)));
      const double mid = std::asin(std::clamp((begin + layer - middle) / half, -1.0, 1.0));
      for (const auto& [low, high] : {std::pair{first, mid}, std::pair{mid, 0.5 * pi}})
        for (std::size_t n = 0; n < chord.point.size(); ++n)
        {
          const double place = 0.5 * (low + high) + 0.5 * (high - low) * chord.point[n];
          const double r = middle + half * std::sin(place);
          inner += 0.5 * (high - low) * chord.weight[n] * std::pow(half * std::cos(place), 2) *
                   std::exp(-velocity * r * (1.0 - c) / (2.0 * kappa));
        }
      sum += angle.weight[a] * inner;
    }
  }
  return sum / (2.0 * pi * body.conductivity);
}

SurfaceGrid cells(int n, double per_radius, Boundary x = open, Boundary y = open)
{
  return {n, n, 1.0 / per_radius, 1.0 / per_radius, x, y};
}

double at_middle(const SurfaceGrid& g, const Field& f)
{
  return f[g.index(g.nx / 2, g.ny / 2)];
}

TEST(HeatResponse, UniformHeatInAPeriodGoesStraightDown)
{
  const SurfaceGrid g = cells(6, 3.0, periodic, periodic);
  for (const double t : {0.01, 1.0, 300.0})
    for (const double velocity : {0.0, 0.7})
    {
      const Field T = temperature(g, {t, velocity, 0.3 * velocity}, Field(g.size(), 3.0));
      // Carslaw and Jaeger (1959), section 2.9.
      const double exact = 2.0 * 3.0 / body.conductivity * std::sqrt(body.diffusivity() * t / pi);
      EXPECT_NEAR(T.front(), exact, 1e-7 * exact) << t << " " << velocity;
      EXPECT_NEAR(T.back(), exact, 1e-7 * exact);
    }
}

TEST(HeatResponse, OneWaveOfHeatInAPeriod)
{
  // The flux cos(kx) in cells has the mean of the wave over a cell less, sin(k dx/2)/(k dx/2), and other waves of an alias.
  const double t = 0.6;
  std::vector<double> errors;
  for (const int n : {16, 32, 64})
  {
    const SurfaceGrid g{n, n, 2.0 * pi / n, 2.0 * pi / n, periodic, periodic};
    const Field flux = test::sampled(g, [&](int i, int j) { return std::cos(i * g.dx + 2.0 * j * g.dy); });
    const double k = std::sqrt(5.0);
    const double exact = std::erf(k * std::sqrt(body.diffusivity() * t)) / (body.conductivity * k);
    errors.push_back(temperature(g, {t}, flux).front() / exact - 1.0);
  }
  const test::Orders orders("one wave of heat", errors);
  EXPECT_LT(std::abs(errors.back()), 2e-3);
  EXPECT_NEAR(orders.last, 2.0, 0.2);
}

TEST(HeatResponse, DiscInTimeAtItsCentre)
{
  const double kappa = body.diffusivity();
  const auto ierfc = [](double x) { return std::exp(-x * x) / std::sqrt(pi) - x * std::erfc(x); };
  for (const double t : {0.05, 1.0, 40.0, forever})
  {
    // Carslaw and Jaeger (1959), section 10.5; steady a/K.
    const double w = 2.0 * std::sqrt(kappa * t);
    const double exact =
        std::isinf(t) ? 1.0 / body.conductivity : w / body.conductivity * (1.0 / std::sqrt(pi) - ierfc(1.0 / w));
    std::vector<double> errors;
    for (const int n : {11, 21, 41})
    {
      const SurfaceGrid g = cells(n, (n - 1) / 2.5);
      errors.push_back(at_middle(g, temperature(g, {t}, test::disc(g))) / exact - 1.0);
    }
    const test::Orders orders("disc, centre", errors);
    EXPECT_LT(std::abs(errors.back()), 1e-3) << t;
    EXPECT_GT(orders.overall, 1.8) << t; // second, of the cells that the edge cuts
  }
}

TEST(HeatResponse, SquareForEver)
{
  // 4 asinh(1)/pi = 1.1222 q a/K in the middle of a square of half-side a: exact in cells of uniform flux.
  const SurfaceGrid g = cells(9, 4.5);
  const Field T = temperature(g, {}, Field(g.size(), 1.0));
  EXPECT_NEAR(at_middle(g, T) * body.conductivity, 4.0 / pi * std::asinh(1.0), 1e-7);
}

TEST(HeatResponse, SlowMotionEndsAtRest)
{
  // e^{-V (r + x)/2 kappa} lies V D/kappa below 1 on a grid with the diagonal D. Of motion as slow as this, cells passed while heat
  // is remembered are more than an int counts.
  const SurfaceGrid g{11, 9, 0.1, 0.12, open, open};
  const Field flux(g.size(), 1.0), at_rest = temperature(g, {forever, 0.0}, flux);
  for (const double velocity : {1e-3, 1e-12})
  {
    const Field moving = temperature(g, {forever, velocity}, flux);
    const double allowed = std::max(1e-9, velocity * std::hypot(g.nx * g.dx, g.ny * g.dy) / 0.5);
    for (std::size_t i = 0; i < moving.size(); ++i)
      EXPECT_NEAR(moving[i] / at_rest[i], 1.0, allowed) << velocity;
  }
}

TEST(HeatResponse, MovingHertzianSourceAtAnySpeed)
{
  const double kappa = body.diffusivity();
  for (const double peclet : {0.1, 1.0, 10.0, 100.0})
  {
    const double velocity = 2.0 * kappa * peclet; // Pe = V a/(2 kappa)
    std::vector<double> errors;
    for (const int n : {25, 49, 97})
    {
      const SurfaceGrid g = cells(n, (n - 1) / 3.0);
      const Field T = temperature(g, {forever, velocity}, test::hertz(g));
      double largest = 0.0, error = 0.0;
      for (int i = 0; i < g.nx; i += (n - 1) / 24)
      {
        const double exact = moving_hertz(g.x(i), velocity);
        largest = std::max(largest, exact);
        error = std::max(error, std::abs(T[g.index(i, g.ny / 2)] - exact));
      }
      errors.push_back(error / largest);
    }
    const test::Orders orders("moving Hertzian source", errors);
    EXPECT_LT(errors.back(), 5e-3) << peclet;
    // Between one, as the temperature rises with the square root of the way from the front at high speeds, and 3/2, as the flux
    // itself ends with a square root.
    EXPECT_GT(orders.overall, 1.1) << peclet;
  }
}

TEST(HeatResponse, RailUnderASlidingWheel)
{
  // The example of Ertz and Knothe (2002): an elliptical contact, 30 m/s over the rail, a sliding speed of 1 m/s, friction 0.3; half of
  // the heat to each body. At a Peclet number of 6000 heat goes straight down: with w^2 from the place to the heat that has passed
  // it, T = 2/K sqrt(kappa/(pi V)) int q(x + w^2) dw (Jaeger 1942).
  const Thermal rail{50.0, 7850.0, 450.0, 0.0};
  constexpr double a = 5.88e-3, b = 10.54e-3, speed = 30.0, largest_flux = 0.5 * 0.3 * 770.6e6 * 1.0;
  const auto flux_at = [&](double x, double y)
  { return largest_flux * std::sqrt(std::max(0.0, 1.0 - x * x / (a * a) - y * y / (b * b))); };
  const auto fast = [&](double x)
  {
    const double end = std::sqrt(a - x);
    double sum = 0.0;
    const Gauss rule(60, 0.0, 0.5 * pi);
    for (std::size_t n = 0; n < rule.point.size(); ++n)
    {
      const double w = end * std::sin(rule.point[n]);
      sum += rule.weight[n] * end * std::cos(rule.point[n]) * flux_at(x + w * w, 0.0);
    }
    return 2.0 * sum / rail.conductivity * std::sqrt(rail.diffusivity() / (pi * speed));
  };
  double exact = 0.0;
  for (double x = -a; x < a; x += 0.002 * a)
    exact = std::max(exact, fast(x));

  std::vector<double> errors;
  for (const int n : {31, 61, 121})
  {
    const SurfaceGrid g{n, 15, 2.2 * a / n, 2.2 * b / 15};
    const Field flux = test::sampled(g, [&](int i, int j) { return flux_at(g.x(i), g.y(j)); });
    const HeatResponse response(g, rail, {forever, speed});
    HeatResponse::Scratch scratch = response.make_scratch();
    Field T(g.size());
    response.apply(flux, T, scratch);
    errors.push_back(*std::max_element(T.begin(), T.end()) / exact - 1.0);
  }
  const test::Orders orders("rail under a sliding wheel", errors);
  // CONTACT prints 166.8 K; the difference is its treatment of a cell's own heat.
  EXPECT_NEAR(exact, 150.33, 0.01);
  EXPECT_LT(std::abs(errors.back()), 1e-3); // of the limit of great speeds itself, too
}

/// The integral of e^{-u} K0(|u|) from 0 to `end`; u = end v^3, as K0 is singular at 0.
double line_source_integral(double end)
{
  double sum = 0.0;
  for (int piece = 0; piece < 8; ++piece)
  {
    const Gauss rule(20, piece / 8.0, (piece + 1) / 8.0);
    for (std::size_t n = 0; n < rule.point.size(); ++n)
    {
      const double v = rule.point[n], u = end * v * v * v;
      sum += rule.weight[n] * end * 3.0 * v * v * std::exp(-u) * std::cyl_bessel_k(0.0, std::abs(u));
    }
  }
  return sum;
}

TEST(HeatResponse, MovingStripInPlaneConduction)
{
  // Jaeger (1942): 2 q kappa/(pi K V) int e^{-u} K0(|u|) du over V (x - s)/2 kappa; one row, with a period in y.
  const double kappa = body.diffusivity();
  for (const double peclet : {0.1, 1.0, 10.0})
  {
    const double velocity = 2.0 * kappa * peclet;
    const SurfaceGrid g{75, 1, 0.04, 0.3, open, periodic};
    const Field flux = test::sampled(g, [&](int i, int) { return std::abs(g.x(i)) < 1.0 ? 1.0 : 0.0; });
    const Field T = temperature(g, {forever, velocity}, flux);
    // 25 cells on each side of the middle one: the half-width is 24.5 or 25.5 cells.
    double half = 0.0;
    for (const double q : flux)
      half += 0.5 * q * g.dx;
    for (const int i : {15, 37, 55})
    {
      const double scale = velocity / (2.0 * kappa);
      const double exact =
          2.0 * kappa / (pi * body.conductivity * velocity) *
          (line_source_integral(scale * (g.x(i) + half)) - line_source_integral(scale * (g.x(i) - half)));
      EXPECT_NEAR(T[g.index(i, 0)], exact, 1e-6 * exact) << peclet << " " << i;
    }
  }
}

TEST(HeatResponse, TurnsWithTheMotion)
{
  const SurfaceGrid g = cells(12, 5.0), turned = g;
  Field flux(g.size()), across(g.size());
  for (int j = 0; j < g.ny; ++j)
    for (int i = 0; i < g.nx; ++i)
    {
      flux[g.index(i, j)] = std::sin(1.0 + i * i + 3.0 * j);
      across[g.index(j, i)] = flux[g.index(i, j)];
    }
  const Field along = temperature(g, {0.7, 1.3}, flux), other = temperature(turned, {0.7, 0.0, 1.3}, across);
  for (int j = 0; j < g.ny; ++j)
    for (int i = 0; i < g.nx; ++i)
      EXPECT_NEAR(along[g.index(i, j)], other[g.index(j, i)], 1e-12);
}

TEST(HeatResponse, NoSteadyStateWhereHeatPilesUp)
{
  const Field none;
  EXPECT_THROW(HeatResponse(cells(4, 2.0, periodic, periodic), body, {forever, 1.0}), InputError);
  EXPECT_THROW(HeatResponse(cells(4, 2.0, open, periodic), body, {}), InputError);
  EXPECT_THROW(HeatResponse(cells(4, 2.0, open, periodic), body, {forever, 0.0, 1.0}), InputError);
  EXPECT_NO_THROW(HeatResponse(cells(4, 2.0, open, periodic), body, {forever, 1.0}));
  EXPECT_THROW(HeatResponse(cells(4, 2.0), body, {0.0}), InputError);
  EXPECT_THROW(HeatResponse(cells(4, 2.0), {0.0, 1.0, 1.0}, {}), InputError);
  EXPECT_THROW(HeatResponse(cells(4, 2.0), {1.0, -1.0, 1.0}, {}), InputError);
}

} // namespace
} // namespace brinell::halfspace::heat_response_test
