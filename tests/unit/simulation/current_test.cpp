// SPDX-License-Identifier: BSD-3-Clause
// Electric current in runs of every scenario: what it depends on, what it leaves alone, what is refused.
#include "brinell/foundation/error.hpp"
#include "brinell/quality/quality.hpp"
#include "brinell/simulation/run.hpp"
#include "brinell/simulation/scenarios.hpp"
#include "conducting_cases.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <type_traits>
#include <vector>

namespace brinell::simulation::current_test
{
namespace
{

using conducting_cases::ball, conducting_cases::bronze, conducting_cases::conducting, conducting_cases::copper,
    conducting_cases::hot_fretting, conducting_cases::rows_of;

template <typename Case>
class CurrentTest : public testing::Test
{
};
TYPED_TEST_SUITE(CurrentTest, Scenarios<testing::Types>);

TYPED_TEST(CurrentTest, FollowsTheContactAndLeavesItAlone)
{
  const TypeParam with = conducting<TypeParam>();
  TypeParam without = with;
  without.current = {};
  without.lower.material.electrical.reset();
  const auto rows = rows_of(with), plain = rows_of(without);
  ASSERT_EQ(rows.size(), plain.size());
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < rows.size(); ++i)
  {
    const auto& row = rows[i];
    EXPECT_EQ(row.F_n, plain[i].F_n);
    EXPECT_EQ(row.work, plain[i].work);
    EXPECT_EQ(plain[i].contact_resistance, 0.0);
    if (row.F_n == 0.0)
    {
      EXPECT_TRUE(std::isinf(row.contact_resistance));
      EXPECT_EQ(row.current, 0.0);
      continue;
    }
    EXPECT_NEAR(row.current * row.contact_resistance, 0.05, 1e-10);
    EXPECT_GE(row.current_spots, 1);
    EXPECT_GT(row.contact_temperature, 30.0);
    // No area of this size conducts better than many small spots, nor worse than a disc.
    const double disc =
        (bronze.resistivity + copper.resistivity) / (4.0 * std::sqrt(row.contact_area / std::numbers::pi));
    EXPECT_LT(row.contact_resistance, 1.1 * disc);
    EXPECT_GT(row.contact_resistance, 0.2 * disc);
    least = std::min(least, row.contact_resistance);
  }
  EXPECT_EQ(rows.back().min_contact_resistance, least);
}

TYPED_TEST(CurrentTest, GoesOnFromACheckpointToTheLastDigit)
{
  TypeParam c = conducting<TypeParam>();
  c.upper.material.electrical = bronze;
  c.current = {.voltage = {0.01, 0.05, 0.02}, .steps = {1.0, 4.0, 30.0}, .film = {.resistance = 1e-13}};
  if constexpr (!std::is_same_v<TypeParam, IndentationCase> && !std::is_same_v<TypeParam, RollingCase>) // which slide
    c.current.film.growth = 1e-9;
  simulation::Run<TypeParam> whole(c);
  std::vector<Archive::Fields> checkpoints;
  while (!whole.is_done())
  {
    const auto row = whole.step();
    checkpoints.push_back(whole.checkpoint());
    const double step = row.step;
    const double expected = step < 1.0    ? 0.01
                            : step < 4.0  ? 0.01 + 0.04 * (step - 1.0) / 3.0
                            : step < 30.0 ? 0.05 - 0.03 * (step - 4.0) / 26.0
                                          : 0.02;
    EXPECT_NEAR(row.voltage, expected, 1e-15) << step;
  }
  for (const std::size_t at : {checkpoints.size() / 3, checkpoints.size() / 2, checkpoints.size() - 1})
  {
    simulation::Run<TypeParam> later(c, {}, &checkpoints[at]);
    while (!later.is_done())
      later.step();
    EXPECT_EQ(later.snapshot().effect("current_density"), whole.snapshot().effect("current_density")) << at;
    EXPECT_EQ(later.summary().last.film_resistance, whole.summary().last.film_resistance) << at;
    EXPECT_EQ(later.summary().min_contact_resistance, whole.summary().min_contact_resistance) << at;
    EXPECT_EQ(later.summary().max_contact_temperature, whole.summary().max_contact_temperature) << at;
  }
}

/// Bodies so hard that nothing yields, whose spots soften by a fifth: the increments are solved again with new softening, which
/// must begin from the state before them.
TYPED_TEST(CurrentTest, SofteningOfWhatDoesNotYieldChangesNothing)
{
  TypeParam c = conducting<TypeParam>();
  for (ShapedBody* body : {&c.lower, &c.upper})
    if (!body->material.elastic.is_rigid())
    {
      body->material.hardening = constitutive::PerfectPlasticity{1e13};
      body->material.kinematic = {};
      body->material.softening = constitutive::LinearSoftening{.reference = 20.0, .melting_point = 1000.0};
      body->material.thermal.reset();
    }
  c.solver.mirror = false; // bodies of unlike resistivities are no twins
  c.current.voltage = {0.1};
  c.friction.coefficient = 0.2;
  if constexpr (std::is_same_v<TypeParam, IndentationCase>)
    c.friction.coefficient = 0.0;
  else
    c.wear = {.lower = 1e-15, .upper = 2e-15};
  if constexpr (std::is_same_v<TypeParam, RollingCase>)
    c.slide_to_roll = 0.02;
  TypeParam without = c;
  without.current = {};
  without.lower.material.electrical.reset();
  const auto rows = rows_of(c), plain = rows_of(without);
  ASSERT_EQ(rows.size(), plain.size());
  double hottest = 0.0;
  for (std::size_t i = 0; i < rows.size(); ++i)
  {
    EXPECT_EQ(rows[i].F_n, plain[i].F_n) << i;
    EXPECT_EQ(rows[i].work, plain[i].work) << i;
    EXPECT_EQ(rows[i].dissipation_friction, plain[i].dissipation_friction) << i;
    EXPECT_EQ(rows[i].worn_volume_upper, plain[i].worn_volume_upper) << i;
    hottest = std::max(hottest, rows[i].contact_temperature);
  }
  EXPECT_GT(hottest, 150.0);
}

TYPED_TEST(CurrentTest, IsTheSameOnBothSidesOfAMirror)
{
  TypeParam c = conducting<TypeParam>();
  const auto by_halves = rows_of(c);
  c.solver.symmetry = false;
  c.solver.mirror = false;
  const auto whole = rows_of(c);
  ASSERT_EQ(whole.size(), by_halves.size());
  for (std::size_t i = 0; i < whole.size(); ++i)
    if (whole[i].F_n > 0.0)
    {
      EXPECT_NEAR(by_halves[i].contact_resistance / whole[i].contact_resistance, 1.0, 1e-3) << i;
    }
}

TEST(Current, CurrentAndVoltageFollowFromEachOther)
{
  IndentationCase c = ball();
  const IndentationRecord by_voltage = rows_of(c).back();
  c.current = {.current = {by_voltage.current}};
  const IndentationRecord by_current = rows_of(c).back();
  EXPECT_NEAR(by_current.voltage, 0.05, 1e-9);
  EXPECT_NEAR(by_current.contact_temperature, by_voltage.contact_temperature, 1e-6);
  c.current = {};
  EXPECT_LT(rows_of(c).back().contact_resistance, by_current.contact_resistance); // cold
  EXPECT_EQ(rows_of(c).back().contact_temperature, 20.0);
}

TEST(Current, TheExpectedErrorHoldsAgainstFinerCells)
{
  // Of an elastic ball, whose exact resistance is known, at the load of which the pressure is found.
  for (const double resolution : {4.0, 5.0, 6.5, 8.0, 11.0, 16.0})
  {
    IndentationCase c = ball();
    c.upper.material.electrical->temperature_coefficient = 0.0;
    c.resolution = resolution;
    const double modulus = contact_modulus(c.lower.material.elastic, c.upper.material.elastic);
    const double curvature = (*relative_curvature(c.lower.shape, c.upper.shape))[0];
    const double exact = (bronze.resistivity + copper.resistivity) / (4.0 * std::cbrt(0.75 / (modulus * curvature)));
    simulation::Run<IndentationCase> run(c);
    while (!run.is_done())
      run.step();
    const quality::Quality found = quality::judged(c, plan(c), run.summary());
    const auto error = std::find_if(found.resolution.expected_errors.begin(), found.resolution.expected_errors.end(),
                                    [](const auto& e) { return e.quantity == std::string("contact resistance"); });
    ASSERT_NE(error, found.resolution.expected_errors.end());
    const double actual = run.summary().last.contact_resistance / exact - 1.0;
    EXPECT_LT(std::abs(actual), error->relative) << resolution;
  }
}

TEST(Current, RefusesWhatCannotFlow)
{
  const auto refused = [](const char* what, const auto& change)
  {
    IndentationCase c = ball();
    change(c);
    try
    {
      static_cast<void>(plan(c));
      ADD_FAILURE() << "not refused: " << what;
    }
    catch (const PlanError& error)
    {
      EXPECT_NE(std::string(error.what()).find(what), std::string::npos) << error.what();
    }
  };
  refused("insulates", [](auto& c) { c.lower.material.electrical.reset(); });
  refused("each follows from the other", [](auto& c) { c.current.current = {1.0}; });
  refused("CurrentDrive::voltage` = -1", [](auto& c) { c.current.voltage = {-1.0}; });
  refused("lower.material.electrical.resistivity` = 0",
          [](auto& c) { c.lower.material.electrical->resistivity = 0.0; });
  refused("temperature_coefficient` = -0.1",
          [](auto& c) { c.lower.material.electrical->temperature_coefficient = -0.1; });
  refused("2 steps, but `CurrentDrive::voltage` = [0.1, 0.2, 0.3] V has 3 values",
          [](auto& c) {
            c.current = {.voltage = {0.1, 0.2, 0.3}, .steps = {0.0, 1.0}};
          });
  refused("element 2 is 1; allowed: steps >= 0 in ascending order",
          [](auto& c) {
            c.current = {.voltage = {0.1, 0.2}, .steps = {1.0, 1.0}};
          });
  refused("but there is no current", [](auto& c) { c.current = {.steps = {1.0}}; });
  refused("CurrentDrive::voltage` = -0.1", [](auto& c) { c.current.voltage = {0.1, -0.1}; });
  refused("FilmLaw::growth` = 1e-09", [](auto& c) { c.current.film.growth = 1e-9; }); // nothing slides
  refused("FilmLaw::growth` = -1e-09", [](auto& c) { c.current.film.growth = -1e-9; });
  refused("not less than the film", [](auto& c) { c.current.film = {.resistance = 2e-12, .limit = 1e-12}; });
  refused("nothing wears", [](auto& c) { c.current.film = {.resistance = 2e-12, .wear = 1.0}; });
  refused("FilmLaw::resistance", [](auto& c) { c.current.film.resistance = -1e-12; });
  // Under a coat voltage and temperature follow Kohlrausch only where all conductors are alike.
  const auto plated = [](auto& c)
  {
    c.lower.material.thermal = c.upper.material.thermal = std::nullopt;
    c.lower.material.temperature = c.upper.material.temperature = 20.0;
    c.upper.material.electrical->temperature_coefficient = c.lower.material.electrical->temperature_coefficient;
    c.lower.material.layers = {
        {1e-3, c.lower.material.elastic, c.lower.material.hardening, c.lower.material.electrical}};
  };
  IndentationCase allowed = ball();
  plated(allowed);
  EXPECT_NO_THROW(static_cast<void>(plan(allowed)));
  refused("both are equally warm",
          [&](auto& c)
          {
            plated(c);
            c.upper.material.temperature = 80.0;
          });
  refused("all resistivities grow alike",
          [&](auto& c)
          {
            plated(c);
            c.lower.material.layers[0].electrical->temperature_coefficient += 1e-3;
          });
  refused("heat is conducted as current is",
          [&](auto& c)
          {
            plated(c);
            c.upper.material.thermal = Thermal{.conductivity = 50.0, .density = 7850.0, .specific_heat = 460.0};
          });
  const auto map = [](double thickness)
  { return HeightMap{.nx = 1, .ny = 1, .dx = 1e-4, .dy = 1e-4, .heights = {thickness}}; };
  refused("has no resistivity", [&](auto& c) { c.lower.film = map(1e-9); });
  refused("no surface has a film", [](auto& c) { c.current.film.resistivity = 1.0; });
  refused("thickness of -1e-09",
          [&](auto& c)
          {
            c.upper.film = map(-1e-9);
            c.current.film.resistivity = 1.0;
          });
}

/// A ball that slides on a flat and is heated by friction and current.
SlidingCase hot_sliding()
{
  SlidingCase c = conducting<SlidingCase>();
  for (constitutive::Material* material : {&c.lower.material, &c.upper.material})
  {
    material->thermal = Thermal{.conductivity = 50.0, .density = 7850.0, .specific_heat = 460.0, .expansion = 12e-6};
    material->electrical = bronze;
    material->hardening.reset();
  }
  c.friction.coefficient = 0.1;
  c.heat.of_plastic_work = 0.0;
  c.speed = 0.1;
  return c;
}

template <typename Case>
void check_first_law(const Case& c, double duration)
{
  const auto rows = rows_of(c);
  double electric = 0.0, before = 0.0;
  for (const auto& row : rows)
  {
    electric += 0.5 * (before + row.electric_power) * duration;
    before = row.electric_power;
  }
  const auto& end = rows.back();
  ASSERT_GT(electric, 0.0);
  EXPECT_NEAR(end.heat_of_current, electric, 0.005 * electric);
  const double given = c.heat.fraction * end.dissipation_friction + electric;
  EXPECT_NEAR(end.heat_lower + end.heat_upper, given, 0.005 * given);
  Case cold = c;
  cold.current = {.voltage = {0.0}, .film = c.current.film};
  const auto without = rows_of(cold);
  EXPECT_EQ(without.back().heat_of_current, 0.0);
  EXPECT_LT(without.back().max_temperature_lower, end.max_temperature_lower);
  // Zero current is the run without one, to the last digit.
  cold.current = {};
  cold.lower.material.electrical.reset();
  const auto plain = rows_of(cold);
  EXPECT_EQ(without.back().heat_lower, plain.back().heat_lower);
  EXPECT_EQ(without.back().work, plain.back().work);
  EXPECT_EQ(without.back().max_temperature_lower, plain.back().max_temperature_lower);
}

TEST(Current, IsHeatInSliding)
{
  SlidingCase c = hot_sliding();
  for (const double fraction : {0.0, 1.0})
  {
    c.heat.fraction = fraction;
    const SlidingPlan found = plan(c);
    check_first_law(c, found.shift / *c.speed);
  }
}

TEST(Current, IsHeatInFrettingWithAFilm)
{
  FrettingCase c = hot_fretting();
  c.current = {.current = {0.0, 5.0}, .steps = {0.0, 6.0}, .film = {.resistance = 1e-11, .growth = 1e-5}};
  check_first_law(c, 1.0 / (c.steps_per_cycle * *c.frequency));
}

TEST(Current, WithoutASteadyStateHeatsAsThatOfTheColdContact)
{
  // 0.6 V would heat the spots by V^2/(8 rho k) = 7500 K.
  for (const bool is_voltage : {true, false})
  {
    FrettingCase c = hot_fretting();
    c.cycles = 1;
    c.heat.stress = false;
    for (constitutive::Material* material : {&c.lower.material, &c.upper.material})
      material->thermal->expansion = 0.0; // the contact stays as it is
    c.current = {.voltage = {0.0}};
    const auto cold = rows_of(c);
    if (is_voltage)
      c.current = {.voltage = {0.6}};
    else
      c.current = {.current = {0.6 / cold.back().contact_resistance}};
    const auto rows = rows_of(c);
    double before = 0.0;
    for (std::size_t i = 1; i < rows.size(); ++i)
    {
      EXPECT_TRUE(std::isnan(rows[i].contact_temperature) && std::isnan(rows[i].contact_resistance)) << i;
      EXPECT_EQ(is_voltage ? rows[i].voltage : rows[i].current,
                is_voltage ? c.current.voltage[0] : c.current.current[0]);
      const double power = is_voltage ? 0.36 / cold[i].contact_resistance
                                      : std::pow(c.current.current[0], 2) * cold[i].contact_resistance;
      const double heat = 0.5 * (before + power) / (c.steps_per_cycle * *c.frequency);
      if (rows[i - 1].cycle > 0) // pressing takes another time
      {
        EXPECT_NEAR(rows[i].heat_of_current - rows[i - 1].heat_of_current, heat, 1e-6 * heat) << i;
      }
      before = power;
    }
    EXPECT_GT(rows.back().heat_of_current, 0.0);
  }
}

TEST(Current, IsWarnedOfWhereBodiesDoNotFeelIt)
{
  IndentationCase c = conducting<IndentationCase>();
  c.current.voltage = {0.3};
  simulation::Run<IndentationCase> run(c);
  while (!run.is_done())
    run.step();
  const auto warnings = quality::judged(c, plan(c), run.summary()).warnings;
  EXPECT_TRUE(std::any_of(warnings.begin(), warnings.end(), [](const auto& w) { return w.key == "hot_current"; }));
}

} // namespace
} // namespace brinell::simulation::current_test
