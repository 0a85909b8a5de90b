// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/simulation/rolling.hpp"
#include "brinell/simulation/sliding.hpp"
#include "brinell/simulation/tugging.hpp"
#include "scenario_checks.hpp"
#include "sliding_cases.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

/// Steps of rolling, sliding and tugging under a load end where the way does: docs/theory/simulation.md (steps that fit the way).
namespace brinell::simulation::steps_on_way_test
{
namespace
{

constexpr double rounding = 1e-12;

RollingCase rolling(double distance, double resolution = 6.0)
{
  RollingCase c;
  c.lower = {Plane{}, cases::soft_steel};
  c.upper = {Paraboloid{1e-3, 1e-3}, {{210e9, 0.3}, {}}};
  c.drive = {contact::Drive::Kind::load, 2.0};
  c.distance = distance;
  c.resolution = resolution;
  return c;
}

/// The same ball sliding.
SlidingCase sliding(const RollingCase& rolls)
{
  SlidingCase c;
  static_cast<Numerics&>(c) = rolls;
  c.lower = rolls.lower;
  c.upper = rolls.upper;
  c.press = rolls.drive;
  c.distance = rolls.distance;
  c.shift = rolls.shift;
  return c;
}

/// Cell that the resolution alone would make.
double wanted_cell(const RollingCase& c)
{
  return plan(c).half_width_x / c.resolution;
}

TEST(StepsOnWay, EndWhereTheWayDoesForAnyWayAndResolution)
{
  for (double distance = 50e-6; distance < 1e-3; distance *= 1.037)
    for (const double resolution : {2.0, 5.3, 6.0, 8.0, 11.31, 16.0})
    {
      const RollingCase c = rolling(distance, resolution);
      const double wanted = wanted_cell(c);
      const RollingPlan p = plan(c);
      SCOPED_TRACE(distance / wanted);
      EXPECT_NEAR(p.way() / distance, 1.0, rounding);
      EXPECT_EQ(p.rolling_steps % 2, 0);
      EXPECT_EQ(p.shift, p.contact.dx);
      EXPECT_LE(p.contact.dx, wanted * (1.0 + 1e-9)) << "not coarser than asked for";
      EXPECT_GT(p.contact.dx, wanted / (1.0 + 2.0 * wanted / distance) * (1.0 - 1e-9)) << "finer by two steps at most";
      EXPECT_NEAR(p.contact.dy, wanted, rounding);
      const SlidingPlan s = plan(sliding(c));
      EXPECT_EQ(s.sliding_steps, p.rolling_steps) << "a ball that slides takes the steps of one that rolls";
      EXPECT_EQ(s.shift, p.shift);
      EXPECT_EQ(s.contact, p.contact);
    }
}

TEST(StepsOnWay, OfGivenCellsAreWholeAndNearestToTheWay)
{
  RollingCase c = rolling(0.405e-3);
  c.spacing = {{4e-6, 4e-6, 2e-6}};
  EXPECT_EQ(plan(c).contact.dx, 4e-6);
  EXPECT_EQ(plan(c).shift, 4e-6);
  EXPECT_NEAR(plan(c).way(), 0.408e-3, rounding);
  EXPECT_NEAR(plan(sliding(c)).way(), 0.404e-3, rounding);
}

TEST(StepsOnWay, OfAGivenShiftKeepTheCellsThatItIsAWholeNumberOf)
{
  RollingCase c = rolling(0.405e-3);
  const double fitted = plan(c).contact.dx, wanted = wanted_cell(c);
  ASSERT_LT(fitted, 0.999 * wanted);
  for (const double cell : {fitted, wanted})
    for (const double cells : {1.0, 2.0, 3.0})
    {
      c.shift = cells * cell;
      EXPECT_NEAR(plan(c).contact.dx, cell, rounding * cell);
      EXPECT_NEAR(plan(c).shift, cells * cell, rounding * cell);
      EXPECT_LE(std::abs(plan(c).way() - c.distance), cells * cell * (1.0 + rounding));
      EXPECT_EQ(plan(sliding(c)).contact, plan(c).contact);
    }
}

TEST(StepsOnWay, OfAnyOtherShiftFitTheWay)
{
  for (const double cells : {0.4, 0.7, 1.3, 1.77, 2.51})
  {
    RollingCase c = rolling(0.405e-3);
    c.shift = cells * wanted_cell(c);
    const RollingPlan p = plan(c);
    EXPECT_NEAR(p.way() / c.distance, 1.0, rounding);
    EXPECT_LE(std::abs(p.shift / *c.shift - 1.0), 1.0 / p.rolling_steps);
    const SlidingPlan s = plan(sliding(c));
    EXPECT_NEAR(s.way() / c.distance, 1.0, rounding);
    EXPECT_LE(std::abs(s.shift / *c.shift - 1.0), 1.0 / s.sliding_steps);
  }
}

/// The history of stick and slip moves by whole cells, also on the finer cells of a series of runs.
TEST(StepsOnWay, WithCreepageCellsFitAShift)
{
  RollingCase c = rolling(0.405e-3);
  c.friction.coefficient = 0.3;
  c.creepage = {{0.001, 0.0, 0.0}};
  const double resolution = c.resolution;
  for (const double cells : {1.0, 1.3, 2.0, 2.51, 3.7})
  {
    c.shift = cells * wanted_cell(c);
    for (const double finer : {0.5, 1.0 / std::sqrt(2.0), 1.0, 2.0, 3.3})
    {
      c.resolution = finer * resolution;
      const RollingPlan p = plan(c);
      const double whole = *c.shift / p.contact.dx;
      EXPECT_NEAR(whole, std::round(whole), 1e-4 * whole) << cells << " cells, " << finer << " times as fine";
      EXPECT_LE(p.contact.dx, (1.0 + rounding) * wanted_cell(c));
      EXPECT_NEAR(p.shift / *c.shift, 1.0, 1e-4);
    }
    c.resolution = resolution;
  }
  c.shift = 0.4 * wanted_cell(c);
  expect_refused(c, "rolling.shift", "whole multiples of the cell");
}

TEST(StepsOnWay, AShortRunRollsTheDistanceThatWasAskedFor)
{
  RollingCase c = rolling(0.0533e-3, 4.0);
  c.lower.material.hardening = {};
  c.load_steps = 1;
  simulation::Run run(c);
  double first = 0.0, last = 0.0;
  bool passes_the_middle = false;
  while (!run.is_done())
  {
    const double x = run.step().x;
    first = std::min(first, x);
    last = std::max(last, x);
    passes_the_middle = passes_the_middle || x == 0.0;
  }
  EXPECT_NEAR(first, -0.5 * c.distance, rounding * c.distance);
  EXPECT_NEAR(last, 0.5 * c.distance, rounding * c.distance);
  EXPECT_TRUE(passes_the_middle);
}

TEST(StepsOnWay, AShortRunSlidesTheDistanceThatWasAskedFor)
{
  SlidingCase c = cases::ball();
  c.lower.material.hardening = c.upper.material.hardening = {};
  c.distance = 43.21e-6;
  const cases::SlidingResult result = cases::computed(c);
  const double farthest = std::max_element(result.history.begin(), result.history.end(),
                                           [](const auto& a, const auto& b) { return a.slid < b.slid; })
                              ->slid;
  EXPECT_NEAR(farthest, c.distance, rounding * c.distance);
  EXPECT_NEAR(result.history.back().way, c.distance, rounding * c.distance);
}

/// Heat of friction of elastic bodies of which one slides.
double heat_of_friction(double distance, double resolution)
{
  RollingCase rolls = rolling(distance, resolution);
  SlidingCase c = sliding(rolls);
  c.lower.material.hardening = {};
  c.press_steps = 2;
  c.friction.coefficient = 0.1;
  return cases::computed(c).summary.strokes.front().dissipation_friction;
}

TEST(StepsOnWay, HeatOfFrictionIsThatOfTheDistance)
{
  // A remainder would be up to a cell in ten, or a step of the cells in fifteen.
  constexpr double stored = 0.004; // elastic energy of the shear, which is not heat
  for (const auto& [distance, resolution] : {std::pair{60e-6, 4.0}, {62e-6, 4.0}, {65e-6, 4.0}, {60e-6, 4.7}})
    EXPECT_NEAR(heat_of_friction(distance, resolution) / (0.1 * 2.0 * distance), 1.0, stored)
        << distance << " m with " << resolution << " cells";
}

/// Plastic work of a pass [J].
double plastic_work(double distance, double resolution)
{
  simulation::Run run(rolling(distance, resolution));
  while (!run.is_done())
    static_cast<void>(run.step());
  return run.summary().passes.front().dissipation;
}

TEST(StepsOnWay, PlasticWorkGrowsWithTheDistanceWithoutJumps)
{
  // Two cells are 6.5 micrometres: whole pairs of them would give the same work twice, and then that of two cells at once.
  constexpr double from = 90e-6, further = 3e-6;
  constexpr int count = 4;
  std::vector<double> work;
  for (int i = 0; i < count; ++i)
    work.push_back(plastic_work(from + i * further, 8.0));
  const double mean = (work.back() - work.front()) / (count - 1);
  for (int i = 1; i < count; ++i)
    EXPECT_NEAR((work[static_cast<std::size_t>(i)] - work[static_cast<std::size_t>(i) - 1]) / mean, 1.0, 0.3) << i;
}

/// Two balls, of which one passes the other under a load.
TuggingCase tugging(double load, double resolution)
{
  TuggingCase c;
  c.lower = {Paraboloid{1e-3, 1e-3}, cases::soft_steel};
  c.upper = {Paraboloid{1.5e-3, 1.5e-3}, {{210e9, 0.3}, {}}};
  c.load = load;
  c.interference = elastic_approach(c.lower, c.upper, load);
  c.resolution = resolution;
  return c;
}

/// Way of both bodies from first touch to alignment [m].
double way_of_tugging(const TuggingCase& c)
{
  const double sum = 2.5e-3;
  return sum * std::acos(1.0 - c.interference / sum);
}

TEST(StepsOnWay, OfTuggingUnderALoadBeginAndEndWithIt)
{
  for (double load = 1.0; load < 60.0; load *= 1.37)
    for (const double resolution : {3.0, 5.3, 8.0, 11.31})
    {
      const TuggingCase c = tugging(load, resolution);
      const TuggingPlan p = plan(c);
      const double way = way_of_tugging(c), cells = way / p.contact.dx;
      SCOPED_TRACE(cells);
      EXPECT_NEAR(cells, 2.0 * std::round(0.5 * cells), 1e-8);
      EXPECT_EQ(p.shift, p.contact.dx);
      EXPECT_EQ(p.steps_per_pass, std::lround(cells));
      const double wanted = p.elastic_contact_radius / resolution;
      EXPECT_LE(p.contact.dx, wanted * (1.0 + 1e-9)) << "not coarser than asked for";
      EXPECT_GT(p.contact.dx, wanted / (1.0 + 2.0 * wanted / way) * (1.0 - 1e-9)) << "finer by two cells at most";
    }
}

TEST(StepsOnWay, OfTuggingWithAShiftBetweenCellsAreMadeToFit)
{
  TuggingCase c = tugging(10.0, 6.0);
  const double wanted = plan(c).elastic_contact_radius / 6.0;
  c.shift = 0.7 * wanted;
  const TuggingPlan p = plan(c);
  const double steps = way_of_tugging(c) / (2.0 * p.shift);
  EXPECT_NEAR(steps, std::round(steps), 1e-8);
  EXPECT_NEAR(p.shift / *c.shift, 1.0, 0.5 / std::round(steps) * 1.05);
  EXPECT_EQ(p.steps_per_pass, 2 * std::lround(steps));
}

TEST(StepsOnWay, OfTuggingWithGivenCellsOrAtConstantHeightKeepTheCells)
{
  TuggingCase c = tugging(10.0, 6.0);
  c.spacing = {{4e-6, 4e-6, 2e-6}};
  EXPECT_EQ(plan(c).contact.dx, 4e-6);
  EXPECT_EQ(plan(c).shift, 4e-6);
  c.spacing.reset();
  c.load.reset();
  EXPECT_NEAR(plan(c).contact.dx, plan(c).elastic_contact_radius / 6.0, rounding);
}

} // namespace
} // namespace brinell::simulation::steps_on_way_test
