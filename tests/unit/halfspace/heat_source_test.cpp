// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/halfspace/heat_response.hpp"
#include "gauss.hpp"
#include "grid_fields.hpp"
#include "order.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

/// Sources of uniform flux: a disc that is switched on, at its rim; squares and discs that move.
namespace brinell::halfspace::heat_source_test
{
namespace
{

constexpr double pi = std::numbers::pi;
constexpr double forever = std::numeric_limits<double>::infinity();
using test::Field;
using test::Gauss;

/// Conductivity 2, diffusivity 0.5.
const Thermal body{2.0, 4.0, 1.0, 0.0};
const double kappa = body.diffusivity();

Field temperature(const SurfaceGrid& g, const HeatMotion& motion, const Field& flux)
{
  const HeatResponse response(g, body, motion);
  HeatResponse::Scratch scratch = response.make_scratch();
  Field result(g.size());
  response.apply(flux, result, scratch);
  return result;
}

/// So many cells on a half-width of 1, and some beside.
SurfaceGrid cells(int per_half, double half_width_in_cells, int beside)
{
  const int n = 2 * (per_half + beside) + 1;
  return {n, n, 1.0 / half_width_in_cells, 1.0 / half_width_in_cells, Boundary::open, Boundary::open};
}

TEST(HeatSource, DiscInTimeAtItsRim)
{
  // Of heat that entered a time t ago, what a Gauss's curve of the variance 2 kappa t about a place of the rim has within the disc:
  // (1 - e^{-m} I_0(m))/2, m = 1/(2 kappa t). In all 2/pi of the centre's.
  for (const double duration : {0.05, 1.0, 40.0, forever})
  {
    double exact = 2.0 / (pi * body.conductivity);
    if (!std::isinf(duration))
    {
      double sum = 0.0, last = 0.0;
      const double end = std::sqrt(duration);
      for (double next = 1e-3 * end; last < end; next *= 1.2)
      {
        const Gauss root(10, last, std::min(next, end));
        for (std::size_t q = 0; q < root.point.size(); ++q)
        {
          const double m = 0.5 / (kappa * root.point[q] * root.point[q]);
          // e^{-m} I_0(m), by its first terms for large m, where the functions overflow.
          const double i0 = m < 300.0 ? std::exp(-m) * std::cyl_bessel_i(0.0, m)
                                      : (1.0 + 0.125 / m * (1.0 + 0.5625 / m)) / std::sqrt(2.0 * pi * m);
          sum += root.weight[q] * (1.0 - i0);
        }
        last = next;
      }
      exact = std::sqrt(kappa / pi) / body.conductivity * sum;
    }
    std::vector<double> errors;
    for (const int n : {8, 16, 32})
    {
      const SurfaceGrid g = cells(n, n, 2);
      const Field T = temperature(g, {duration}, test::disc(g));
      errors.push_back(T[g.index(g.nx / 2 + n, g.ny / 2)] / exact - 1.0);
    }
    const test::Orders orders("disc, rim", errors);
    EXPECT_LT(std::abs(errors.back()), 5e-4) << duration;
    EXPECT_GT(orders.overall, 1.6) << duration;
  }
}

/// Jaeger's moving point source, e^{-V (r + ahead)/2 kappa}/(2 pi K r), over a uniform source about a place in it: along the rays from
/// there in closed form, which leaves the direction.
/// @param to_edge  length of the ray in a direction, from the motion on
template <typename ToEdge>
double moving_uniform(double velocity, ToEdge to_edge)
{
  const double slowness = velocity / (2.0 * kappa), narrow = std::min(1.0, 1.0 / std::sqrt(slowness));
  std::vector<double> ends{-pi, pi, 0.0};
  for (int n = 1; n < 48; ++n)
    ends.insert(ends.end(), {pi * n / 48.0, -pi * n / 48.0});
  for (const double widths : {0.1, 0.3, 1.0, 2.0, 3.0})
    ends.insert(ends.end(), {widths * narrow, -widths * narrow});
  std::sort(ends.begin(), ends.end());
  double sum = 0.0;
  for (std::size_t e = 0; e + 1 < ends.size(); ++e)
  {
    const Gauss angle(16, ends[e], ends[e + 1]);
    for (std::size_t a = 0; a < angle.point.size(); ++a)
    {
      const double behind = 2.0 * slowness * std::pow(std::sin(0.5 * angle.point[a]), 2), way = to_edge(angle.point[a]);
      sum += angle.weight[a] * (behind * way > 1e-12 ? -std::expm1(-behind * way) / behind : way);
    }
  }
  return sum / (2.0 * pi * body.conductivity);
}

TEST(HeatSource, MovingSquareAtAnySpeed)
{
  for (const double peclet : {0.1, 1.0, 10.0, 100.0})
  {
    const double velocity = 2.0 * kappa * peclet;
    const SurfaceGrid g = cells(4, 4.5, 0); // the square fills it
    const Field T = temperature(g, {forever, velocity}, Field(g.size(), 1.0));
    for (const int i : {0, 2, 4, 7, 8})
      for (const int j : {1, 4})
      {
        const double x = g.x(i), y = g.y(j);
        const auto to_edge = [&](double angle)
        {
          const double c = std::cos(angle), s = std::sin(angle);
          return std::min(((c > 0.0 ? 1.0 : -1.0) - x) / c, ((s > 0.0 ? 1.0 : -1.0) - y) / s);
        };
        // To the corners that the rule for the directions passes over.
        EXPECT_NEAR(T[g.index(i, j)] / moving_uniform(velocity, to_edge), 1.0, 1e-4) << peclet << " " << i << " " << j;
      }
  }
}

TEST(HeatSource, MovingDiscAtAnySpeed)
{
  for (const double peclet : {0.1, 1.0, 10.0, 100.0})
  {
    const double velocity = 2.0 * kappa * peclet;
    std::vector<double> errors;
    for (const int n : {12, 24, 48})
    {
      const SurfaceGrid g = cells(n, n, 1);
      const Field T = temperature(g, {forever, velocity}, test::disc(g));
      double error = 0.0, largest = 0.0;
      for (const double x : {-0.75, -0.25, 0.0, 0.5, 0.75})
      {
        const auto to_edge = [x](double angle)
        {
          const double s = std::sin(angle);
          return -x * std::cos(angle) + std::sqrt(1.0 - x * x * s * s);
        };
        const double exact = moving_uniform(velocity, to_edge);
        largest = std::max(largest, exact);
        error =
            std::max(error, std::abs(T[g.index(g.nx / 2 + static_cast<int>(std::lround(x * n)), g.ny / 2)] - exact));
      }
      errors.push_back(error / largest);
    }
    const test::Orders orders("moving disc", errors);
    EXPECT_LT(errors.back(), 2e-4) << peclet;
    EXPECT_GT(orders.overall, 1.8) << peclet;
  }
}

} // namespace
} // namespace brinell::halfspace::heat_source_test
