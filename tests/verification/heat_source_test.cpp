// SPDX-License-Identifier: BSD-3-Clause
#include "gauss.hpp"
#include "record.hpp"
#include "scenario_runs.hpp"

#include "brinell/simulation/sliding.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

/// Heat that is supplied from outside: on a disc or a rectangle of one surface, or between the surfaces.
namespace brinell::verification::heat_source_test
{
namespace
{

using elastoplastic::HeatSource;
using simulation::SlidingCase;
using simulation::SlidingRecord;

constexpr double pi = std::numbers::pi;
constexpr double spot_radius = 0.1e-3, spot_flux = 2e7;

/// A ball that slides over a rigid flat, which takes no heat, without friction.
SlidingCase ball_with_spot(double cells_per_radius)
{
  SlidingCase c;
  c.lower = {simulation::Plane{}, {{std::numeric_limits<double>::infinity(), 0.0}, {}}};
  c.upper = {ball(10e-3), elastic_material()};
  c.upper.material.thermal = steel;
  c.press = load(20.0);
  c.press_steps = 2;
  c.distance = 0.4e-3;
  c.speed = 0.5;
  const double cell = spot_radius / cells_per_radius;
  c.spacing = std::array{cell, cell, 10e-6};
  c.shift = 20e-6;
  c.heat.source = {
      .shape = HeatSource::Shape::disc, .on = HeatSource::Side::upper, .flux = spot_flux, .radius = spot_radius};
  return c;
}

/// Rise at a distance r from the middle of a disc on a half space that has had the flux for the time t: the disc's potential
/// as a sum of rings about the place, each of which adds q/(2 pi K s) erfc(s/sqrt(4 kappa t)) per area (Carslaw and Jaeger 1959,
/// section 10.4).
double rise_under_disc(double r, double time)
{
  const double spread = std::sqrt(4.0 * steel.diffusivity() * time);
  double sum = 0.0;
  // In polar coordinates about the place, area / s is ds d(angle); the integral of erfc has a closed form.
  const auto integral = [&](double s)
  { return s * std::erfc(s / spread) + spread / std::sqrt(pi) * (1.0 - std::exp(-s * s / (spread * spread))); };
  const test::Gauss angle(200, 0.0, pi);
  for (std::size_t n = 0; n < angle.point.size(); ++n)
  {
    const double cosine = std::cos(angle.point[n]), sine = std::sin(angle.point[n]);
    const double under = spot_radius * spot_radius - r * r * sine * sine;
    sum += 2.0 * angle.weight[n] * integral(std::max(0.0, -r * cosine + std::sqrt(under)));
  }
  return spot_flux / (2.0 * pi * steel.conductivity) * sum;
}

/// The same at a place outside the disc.
double rise_beside_disc(double r, double time)
{
  const double spread = std::sqrt(4.0 * steel.diffusivity() * time);
  const auto integral = [&](double s)
  { return s * std::erfc(s / spread) + spread / std::sqrt(pi) * (1.0 - std::exp(-s * s / (spread * spread))); };
  double sum = 0.0;
  const double widest = std::asin(spot_radius / r);
  const test::Gauss root(200, 0.0, 1.0); // of the angle from the tangent, where the chord is a root
  for (std::size_t n = 0; n < root.point.size(); ++n)
  {
    const double angle = widest * (1.0 - root.point[n] * root.point[n]);
    const double half = std::sqrt(std::max(0.0, spot_radius * spot_radius - std::pow(r * std::sin(angle), 2)));
    const double middle = r * std::cos(angle);
    sum += 2.0 * root.weight[n] * 2.0 * root.point[n] * widest * (integral(middle + half) - integral(middle - half));
  }
  return spot_flux / (2.0 * pi * steel.conductivity) * sum;
}

/// Rises of the upper surface [K], step by step, and the last row.
struct SpotRun
{
  std::vector<double> time, middle;
  std::vector<double> at_end; ///< along the row through the middle
  SlidingRecord last;
};

SpotRun run_of_spot(const SlidingCase& c)
{
  const simulation::SlidingPlan plan = simulation::plan(c);
  const double bulk = c.upper.material.temperature;
  SpotRun run;
  simulation::Observer<SlidingRecord> observer;
  observer.on_step = [&](const SlidingRecord& r, int)
  {
    run.time.push_back(static_cast<double>(run.time.size() + 1) * plan.shift / *c.speed);
    run.middle.push_back(r.max_temperature_upper - bulk);
    run.last = r;
  };
  const simulation::Snapshot end = simulation::run(c, observer).final_state;
  for (int i = 0; i < end.contact.nx; ++i)
    run.at_end.push_back(end.temperature[1].at(end.contact.index(i, end.contact.ny / 2)) - bulk);
  return run;
}

/// Rise at the rim at the end of a run: the mean of the two cells on either side of it, whose errors are opposite.
double rise_at_rim(const SpotRun& run, double cell)
{
  const int rim = static_cast<int>(std::floor(spot_radius / cell + 0.5)),
            middle = static_cast<int>(run.at_end.size() / 2);
  const double inside = run.at_end.at(static_cast<std::size_t>(middle + rim - 1)),
               outside = run.at_end.at(static_cast<std::size_t>(middle + rim));
  return 0.5 * (inside + outside);
}

/// The same of the closed form.
double exact_rise_at_rim(double cell, double time)
{
  const double rim = std::floor(spot_radius / cell + 0.5);
  return 0.5 * (rise_under_disc((rim - 1.0) * cell, time) + rise_beside_disc(rim * cell, time));
}

TEST(HeatSource, DiscSwitchedOnAtRest)
{
  std::vector<double> errors;
  for (const double cells : {5.5, 11.5})
  {
    const SpotRun run = run_of_spot(ball_with_spot(cells));
    const double rise = rise_under_disc(0.0, run.time.back());
    const std::string name = fmt::format("disc switched on in a case, {} cells per radius, ", cells);
    for (const std::size_t step : {std::size_t{0}, std::size_t{5}, run.time.size() - 1})
      test::expect_close(name + "middle, step " + std::to_string(step + 1) + " / closed form",
                         run.middle.at(step) / rise_under_disc(0.0, run.time.at(step)), 1.0, 0.15 / (cells * cells),
                         "exact: Carslaw and Jaeger (1959)");
    const double cell = spot_radius / cells;
    test::expect_close(name + "rim / closed form", rise_at_rim(run, cell) / exact_rise_at_rim(cell, run.time.back()),
                       1.0, 0.06 / cells, "exact: Carslaw and Jaeger (1959)");
    const double given = spot_flux * pi * spot_radius * spot_radius * run.time.back();
    test::expect_close(name + "heat of the source / its power x time", run.last.heat_of_source / given, 1.0, 1e-8,
                       "exact");
    test::expect_close(name + "heat into the body / heat of the source", run.last.heat_upper / given, 1.0, 1e-8,
                       "first law");
    EXPECT_EQ(run.last.heat_lower, 0.0);
    EXPECT_GT(run.middle.back(), 0.5 * rise);
  }
}

/// With all of the time behind it: q a/K in the middle, and 2/pi of it at the rim.
TEST(HeatSource, SteadyDiscAtRest)
{
  SlidingCase c = ball_with_spot(8.5);
  c.heat.regime = elastoplastic::HeatRegime::steady;
  c.heat.reference = 10e-3;
  const SpotRun run = run_of_spot(c);
  test::expect_close("middle of a steady disc in a case / closed form",
                     run.middle.back() * steel.conductivity / (spot_flux * spot_radius), 1.0, 2e-3, "exact: q a/K");
}

/// Between the surfaces the heat of a source is shared as that of friction: equal bodies take halves, and with friction both add
/// up.
TEST(HeatSource, BetweenTheSurfaces)
{
  constexpr double power = 2.0;
  simulation::TuggingCase t = warm_spheres(perfect_material(), 2.0, 1.0, 3.0);
  t.heat.source = {.shape = HeatSource::Shape::contact, .power = power};
  const auto run = computed(t);
  const auto& last = run.history.back();
  EXPECT_GT(last.heat_of_source, 0.0);
  test::expect_close("heat of friction and of a current / heat in both bodies",
                     (last.dissipation_friction + last.heat_of_source) / (last.heat_lower + last.heat_upper), 1.0, 1e-3,
                     "first law");
  EXPECT_NEAR(last.heat_lower, last.heat_upper, 1e-6 * last.heat_lower);
  // While they touch: no heat without contact.
  double touched = 0.0;
  const simulation::TuggingPlan plan = simulation::plan(t);
  for (const auto& r : run.history)
    touched += r.F_n > 0.0 ? 1.0 : 0.0;
  EXPECT_NEAR(last.heat_of_source / power, touched * 2.0 * plan.shift, 3.0 * 2.0 * plan.shift);
}

/// One body's heat passes to the other where they touch, and none is lost; mirror images are not at one any more.
TEST(HeatSource, OnOneOfTwoBodies)
{
  simulation::TuggingCase t = warm_spheres(perfect_material(), 2.0, 1.0, 3.0);
  t.friction.coefficient = 0.0;
  t.heat.source = {.shape = HeatSource::Shape::rectangle,
                   .on = HeatSource::Side::upper,
                   .power = 5.0,
                   .length = 0.05e-3,
                   .width = 0.1e-3,
                   .offset = -0.1e-3};
  const auto last = computed(t).history.back();
  EXPECT_GT(last.heat_lower, 0.0);
  EXPECT_GT(last.heat_upper, last.heat_lower);
  test::expect_close("heat of a source on one body / heat in both bodies",
                     last.heat_of_source / (last.heat_lower + last.heat_upper), 1.0, 1e-9, "first law");
}

} // namespace
} // namespace brinell::verification::heat_source_test
