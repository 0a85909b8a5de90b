// SPDX-License-Identifier: BSD-3-Clause
#include "order.hpp"
#include "scenario_runs.hpp"

#include "brinell/simulation/fretting.hpp"
#include "brinell/simulation/sliding.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numbers>
#include <vector>

/// Wear of elastic bodies against closed forms.
namespace brinell::verification::wear_test
{
namespace
{

using simulation::BodySnapshot;
using simulation::FrettingCase;
using simulation::FrettingRecord;
using simulation::FrettingSummary;
using simulation::SlidingCase;
using simulation::SlidingSummary;

constexpr double rigid = std::numeric_limits<double>::infinity();
constexpr double final_ratio = 5.0; ///< radius of the scar over that of the first contact

/// A rigid ball slides over a stiff flat until the flat that is worn on it is much wider than the first contact.
/// @param cells  per radius of the scar
SlidingCase worn_ball(int cells, int steps)
{
  constexpr double radius = 10e-3, load_given = 10.0, scar = 0.2e-3, way = 1e-3;
  SlidingCase c;
  const double hertz = scar / final_ratio;
  c.lower = {simulation::Plane{}, {{0.75 * load_given * radius / std::pow(hertz, 3), 0.0}, {}}}; // E* = 3 F R/(4 a^3)
  c.upper = {ball(radius), {{rigid, 0.3}, {}}};
  c.press = load(load_given);
  c.press_steps = 1;
  c.spacing = std::array{scar / cells, scar / cells, scar / cells};
  c.wear.upper = std::numbers::pi * std::pow(scar, 4) / (4.0 * radius) / (load_given * way); // a^4 = 4 k F s R/pi
  c.shift = way / steps;
  c.distance = 0.1 * way;
  c.strokes = 10;
  c.to_and_fro = true;
  return c;
}

/// Depth in the middle of the scar over that of a spherical cap of the volume k F s.
double depth_of_scar(int cells, int steps)
{
  const SlidingCase c = worn_ball(cells, steps);
  const SlidingSummary summary = simulation::run(c);
  const double volume = c.wear.upper * c.press.value * 1e-3;
  EXPECT_NEAR(summary.worn_volume_upper / volume, 1.0, 1e-9);
  const double exact = std::sqrt(volume / (std::numbers::pi * 10e-3)); // V = pi R h^2, flat
  return summary.max_worn_depth_upper / exact;
}

// Where only a ball wears on a flat that hardly gives way, what is left of it is a cap cut off: Archard's scar, a^4 = 4 k F s R/pi.
// The flat gives way by about (8/3) (a_Hertz/a)^3 of the depth, 2 %. A step wears thirty times more, on the finest grid, than an
// explicit scheme bears.
TEST(Wear, OfABallOnAStiffFlatIsACapCutOff)
{
  std::vector<double> depths;
  for (const int cells : {6, 12, 24})
  {
    depths.push_back(depth_of_scar(cells, 60));
    std::printf("  depth of the scar over that of the cap, %2d cells per radius: %.4f\n", cells, depths.back());
    EXPECT_NEAR(depths.back(), 1.0, 8.0 / 3.0 / std::pow(final_ratio, 3));
  }
  const test::Orders orders("change of the depth by halved cells", {depths[1] - depths[0], depths[2] - depths[1]});
  EXPECT_GT(orders.last, 1.0); // the edge of the scar falls on cells: no smooth order beyond the first
}

FrettingSummary computed(const FrettingCase& c, std::vector<FrettingRecord>& history)
{
  history.clear();
  simulation::Observer<FrettingRecord> observer;
  observer.on_step = [&](const FrettingRecord& r, int) { history.push_back(r); };
  return simulation::run(c, observer);
}

/// Two elastic balls of 1 m without Poisson's effect: Mindlin's solutions are exact then.
FrettingCase fretting_balls(double cells)
{
  FrettingCase c;
  c.lower = c.upper = {ball(1.0), {{200e9, 0.0}, {}}};
  c.press = load(1e5);
  c.press_steps = 1;
  c.friction.coefficient = 0.5;
  c.resolution = cells;
  c.steps_per_cycle = 32;
  c.wear = {.lower = 1e-18, .upper = 3e-18}; // so little that the pressure stays Hertz's
  return c;
}

/// Displacement at which two equal balls slide everywhere: Mindlin (1949); and the radius of their contact.
struct Mindlin
{
  double displacement, radius, peak_pressure;
};
Mindlin mindlin(const FrettingCase& c)
{
  const double E = c.lower.material.elastic.young_modulus, P = c.press.value, R = 0.5; // of the pair
  const double a = std::cbrt(0.75 * P * R / (0.5 * E));
  return {0.75 * c.friction.coefficient * P / (0.5 * E * a), a, 1.5 * P / (std::numbers::pi * a * a)};
}

// In a cycle of gross slip the loop has the area 4 f P (A - 0.8 d), with A the amplitude and d the displacement at which all slides:
// Mindlin's and Deresiewicz's branches between straight lines. The volume that Archard's law wears is k/f times that.
TEST(Wear, OfGrossSlipIsThatOfMindlinsLoop)
{
  FrettingCase c = fretting_balls(8.0);
  const Mindlin m = mindlin(c);
  c.amplitude = 3.0 * m.displacement;
  c.cycles = 2;
  std::vector<FrettingRecord> history;
  const FrettingSummary summary = computed(c, history);
  const auto after = [&](int cycle) { return history.at(static_cast<std::size_t>(cycle * c.steps_per_cycle)); };
  const double exact = 4.0 * c.press.value * (c.amplitude - 0.8 * m.displacement);
  const double lower = (after(2).worn_volume_lower - after(1).worn_volume_lower) / (c.wear.lower * exact);
  const double upper = (after(2).worn_volume_upper - after(1).worn_volume_upper) / (c.wear.upper * exact);
  std::printf("  volume of a cycle over that of the loop: %.5f\n", lower);
  EXPECT_NEAR(lower, 1.0, 0.01); // Mindlin's displacement has an error of some 0.5 % on 8 cells
  EXPECT_NEAR(upper, lower, 1e-9);
  // In the middle: Hertz's pressure times what is slipped there, 4 (A - d) but for the bulge of Cattaneo's displacement.
  const double deepest = summary.max_worn_depth_lower / (c.wear.lower * m.peak_pressure);
  EXPECT_GT(deepest, 4.0 * 2.0 * (c.amplitude - 1.5 * m.displacement));
  EXPECT_LT(deepest, 4.0 * 2.0 * c.amplitude);
}

// Where a middle sticks, nothing wears; around it a ring does.
TEST(Wear, OfPartialSlipIsARing)
{
  FrettingCase c = fretting_balls(12.0);
  const Mindlin m = mindlin(c);
  c.amplitude = 0.5 * m.displacement;
  std::vector<FrettingRecord> history;
  const FrettingSummary summary = computed(c, history);
  const double stuck = m.radius * std::sqrt(1.0 - 0.5); // c/a = sqrt(1 - A/d)
  const BodySnapshot& body = summary.final_state.lower;
  const SurfaceGrid& grid = body.grid.surface;
  double deepest = 0.0, deepest_at = 0.0;
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i)
    {
      const double r = std::hypot(body.x0 + i * grid.dx, body.y0 + j * grid.dy);
      const double depth = body.effect("worn_depth")[grid.index(i, j)];
      if (r < stuck - grid.dx || r > m.radius + 1.5 * grid.dx)
      {
        EXPECT_EQ(depth, 0.0) << r / m.radius;
      }
      else if (r > stuck + grid.dx && r < m.radius - 1.5 * grid.dx)
      {
        EXPECT_GT(depth, 0.0) << r / m.radius;
      }
      if (depth > deepest)
        deepest = depth, deepest_at = r;
    }
  EXPECT_GT(deepest_at, stuck);
  EXPECT_LT(deepest_at, m.radius);
}

// Half of the slip of a step counts under the pressure at its beginning: what is left are the places between the steps where the edge of
// the contact passes a cell.
TEST(Wear, HardlyDependsOnTheStep)
{
  std::vector<double> depths;
  for (const int steps : {8, 16, 32, 64})
  {
    FrettingCase c = fretting_balls(6.0);
    const Mindlin m = mindlin(c);
    c.amplitude = 3.0 * m.displacement;
    c.wear = {.lower = 0.0, .upper = 2e-13};
    c.steps_per_cycle = steps;
    c.solver.contact_tolerance = 1e-8;
    std::vector<FrettingRecord> history;
    depths.push_back(computed(c, history).max_worn_depth_upper);
  }
  std::vector<double> changes;
  for (std::size_t i = 1; i < depths.size(); ++i)
    changes.push_back((depths[i] - depths[i - 1]) / depths.back());
  const test::Orders orders("change of the worn depth by halved steps", changes);
  EXPECT_GT(orders.overall, 0.8);
  EXPECT_LT(std::abs(changes.front()), 2e-5); // 2.4e-5 by the pressure at the end alone
}

} // namespace
} // namespace brinell::verification::wear_test
