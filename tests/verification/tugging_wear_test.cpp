// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/reference/hertz.hpp"
#include "order.hpp"
#include "record.hpp"
#include "tugging_runs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

/// Wear of two balls that pass each other at constant height, between its limits: so little that the pressure stays that of
/// Hertz, and so much that one ball cuts its shape into the other.
namespace brinell::verification::tugging_wear_test
{
namespace
{

using simulation::BodySnapshot;
using simulation::TuggingCase;

constexpr double lower_radius = 1.0, upper_radius = 2.0, sum = lower_radius + upper_radius;
constexpr double equivalent = lower_radius * upper_radius / sum;
constexpr double interference = 2e-4;

TuggingCase elastic_balls(double cells)
{
  TuggingCase c;
  c.lower = {ball(lower_radius), {{200e9, 0.3}, {}}};
  c.upper = {ball(upper_radius), {{200e9, 0.3}, {}}};
  c.interference = interference;
  const double a = std::sqrt(equivalent * interference);
  c.spacing = {{a / cells, a / cells, a}};
  return c;
}

/// Integral over a pass of a quantity of the contact by the interference; zero outside the contact.
double over_the_pass(const std::function<double(double alpha, double theta)>& f)
{
  const double height = sum - interference, half = std::acos(height / sum);
  constexpr int points = 20000;
  double integral = 0.0;
  for (int i = 0; i < points; ++i)
  {
    const double theta = half * (2.0 * (i + 0.5) / points - 1.0);
    const double distance = height / std::cos(theta); // of the centres
    integral += f(sum - distance, theta) * distance * 2.0 * half / points;
  }
  return integral;
}

/// By Hertz (Johnson 1985, Eqs. 4.22 to 4.24): worn volume, and worn depth at the top of the lower ball, over the coefficient.
struct Hertzian
{
  double volume, depth_at_top;
};
Hertzian hertzian(double modulus)
{
  const auto contact = [&](double alpha) { return reference::point_contact_at_approach(equivalent, modulus, alpha); };
  return {over_the_pass([&](double alpha, double) { return contact(alpha).load; }),
          over_the_pass(
              [&](double alpha, double theta)
              {
                const auto c = contact(alpha);
                const double x = lower_radius * theta / c.contact_radius;
                return x * x < 1.0 ? c.peak_pressure * std::sqrt(1.0 - x * x) : 0.0;
              })};
}

double depth_at(const BodySnapshot& body, double x, double y)
{
  const SurfaceGrid& g = body.grid.surface;
  const int i = static_cast<int>(std::lround((x - body.x0) / g.dx));
  const int j = static_cast<int>(std::lround((y - body.y0) / g.dy));
  return body.effect("worn_depth").at(g.index(i, j));
}

TEST(TuggingWear, OfLittleIsThatOfHertzOnTheWay)
{
  const double modulus = contact_modulus({200e9, 0.3}, {200e9, 0.3});
  const Hertzian exact = hertzian(modulus);
  std::vector<double> volumes, depths;
  for (const int cells : {6, 12, 24})
  {
    TuggingCase c = elastic_balls(cells);
    c.wear = {.lower = 1e-20, .upper = 3e-20};
    const TuggingRun run = computed(c);
    volumes.push_back(run.summary.worn_volume_upper / (3e-20 * exact.volume) - 1.0);
    depths.push_back(depth_at(run.summary.final_state.lower, 0.0, 0.0) / (1e-20 * exact.depth_at_top) - 1.0);
    EXPECT_NEAR(run.summary.worn_volume_upper, 3.0 * run.summary.worn_volume_lower,
                1e-12 * run.summary.worn_volume_upper);
  }
  // Tolerances: three to five times the error of the mesh, whose order is tested.
  const char* origin = "exact: Hertz on the way of two balls";
  test::expect_close("worn volume of a pass over k int P ds, 12 cells per radius", 1.0 + volumes[1], 1.0, 2e-3, origin);
  test::expect_close("worn depth at the top over k int p ds, 12 cells per radius", 1.0 + depths[1], 1.0, 2e-3, origin);
  EXPECT_GT(test::Orders("worn volume of a pass", volumes).overall, 1.2);
  EXPECT_GT(test::Orders("worn depth at the top", depths).overall, 0.8);
}

// An upper ball that wears without resistance on a lower one that does not is cut along the path of the lower ball's top. At s along
// and y across its own surface it loses the largest interference there on the way: alpha - s^2/2 R2 - y^2/2 R1 - y^2/2 R2, in the
// middle of the track the plane through the top.
TEST(TuggingWear, OfMuchIsTheShapeOfTheOther)
{
  const char* origin = "geometry: depth of the path of one ball in the other";
  const double along = std::sqrt(2.0 * upper_radius * interference),
               across = std::sqrt(2.0 * equivalent * interference);
  const double exact = 0.5 * std::numbers::pi * interference * along * across;
  std::vector<double> volumes;
  for (const int cells : {6, 12, 24})
  {
    TuggingCase c = elastic_balls(cells);
    // A step, whose slip is two cells, wears some two thousand times what an explicit scheme would bear (0.9 cells over the modulus),
    // so that hardly any pressure remains.
    c.wear.upper = 1e3 / contact_modulus({200e9, 0.3}, {200e9, 0.3});
    const TuggingRun run = computed(c);
    EXPECT_EQ(run.summary.split_increments, 0);
    EXPECT_EQ(run.summary.worn_volume_lower, 0.0);
    volumes.push_back(run.summary.worn_volume_upper / exact - 1.0);
    const BodySnapshot& body = run.summary.final_state.upper;
    const SurfaceGrid& g = body.grid.surface;
    double largest = 0.0;
    for (int j = 0; j < g.ny; ++j)
      for (int i = 0; i < g.nx; ++i)
      {
        const double s = body.x0 + i * g.dx, y = body.y0 + j * g.dy;
        const double cut = std::max(0.0, interference - 0.5 * s * s / upper_radius - 0.5 * y * y / equivalent);
        largest = std::max(largest, std::abs(body.effect("worn_depth")[g.index(i, j)] - cut) / interference);
      }
    std::printf("  %2d cells per radius: largest error of the depth over the interference %.4f\n", cells, largest);
    if (cells == 24)
    {
      test::expect_close("worn volume of a pass over that of the cut, 24 cells per radius", 1.0 + volumes.back(), 1.0,
                         4e-3, origin);
      test::expect_close("largest error of the worn depth over the interference, 24 cells per radius", largest, 0.0,
                         4e-3, origin);
    }
  }
  EXPECT_GT(test::Orders("worn volume of the cut", volumes).overall, 0.8);
}

} // namespace
} // namespace brinell::verification::tugging_wear_test
