// SPDX-License-Identifier: BSD-3-Clause
// Rolling with creepage: what it refuses, and what it shares with rolling without it.
#include "brinell/quality/quality.hpp"
#include "brinell/simulation/rolling.hpp"

#include "brinell/simulation/run.hpp"
#include "scenario_checks.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace brinell::simulation::rolling_creepage_test
{
namespace
{

const constitutive::Material steel{{210e9, 0.3}, constitutive::LinearHardening{1e9, 10e9}};
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// A ball on a flat of the same steel, yielding, that sticks and slips.
RollingCase sample()
{
  RollingCase c;
  c.lower = {Plane{}, steel};
  c.upper = {Paraboloid{1e-3, 1e-3}, steel};
  c.drive = {contact::Drive::Kind::load, 2.0};
  c.distance = 60e-6;
  c.load_steps = 2;
  c.resolution = 4.0;
  c.friction.coefficient = 0.3;
  c.creepage = Creepage{0.003, 0.001, 20.0};
  return c;
}

template <typename Change>
void expect_refused(const std::string& key, const std::string& part, const Change& change)
{
  expect_refused(key, part, sample(), change);
}

TEST(RollingCreepageTest, TakesAShiftOfWholeCellsWithTheDigitsThatAMessageGives)
{
  RollingCase c = sample();
  const double cell = plan(c).contact.dx;
  c.shift = 2.0 * cell * (1.0 + 5e-6);
  const RollingPlan p = plan(c);
  ASSERT_EQ(p.contact.dx, cell);
  EXPECT_EQ(p.shift, 2.0 * cell);
}

TEST(RollingCreepageTest, RefusesWhatDoesNotGoTogether)
{
  EXPECT_NO_THROW(static_cast<void>(plan(sample())));
  expect_refused("rolling.creepage", "interface.friction = 0", [](auto& c) { c.friction.coefficient = 0.0; });
  expect_refused("rolling.spin", "interface.friction = 0",
                 [](auto& c)
                 {
                   c.friction.coefficient = 0.0;
                   c.creepage = Creepage{0.0, 0.0, 20.0};
                 });
  expect_refused("rolling.creepage", "slide_to_roll = 0.1", [](auto& c) { c.slide_to_roll = 0.1; });
  expect_refused("rolling.creepage", "from -0.1 to 0.1", [](auto& c) { c.creepage->longitudinal = 0.2; });
  expect_refused("rolling.creepage", "-0.11", [](auto& c) { c.creepage->lateral = -0.11; });
  expect_refused("rolling.creepage", "nan", [](auto& c) { c.creepage->longitudinal = nan; });
  expect_refused("rolling.creepage", "nan", [](auto& c) { c.creepage->lateral = nan; });
  expect_refused("rolling.spin", "nan", [](auto& c) { c.creepage->spin = nan; });
  expect_refused("rolling.spin", "half-length", [](auto& c) { c.creepage->spin = -1e6; });
  for (const double cells : {0.5, 1.001, 1.5})
    expect_refused("rolling.shift", "whole multiples",
                   [cells](auto& c)
                   {
                     const RollingPlan p = plan(sample());
                     c.spacing = {p.contact.dx, p.contact.dy, p.lower.dz};
                     c.shift = cells * p.shift;
                   });
  expect_refused("rolling.spin", "without ends",
                 [](auto& c)
                 {
                   c.domain.y = {Boundary::periodic, 1.0, 1};
                   c.upper.shape = Roller{1e-3, std::numeric_limits<double>::infinity()};
                   c.drive.value = 1e5;
                 });
  expect_refused("interface.friction", "two rigid bodies",
                 [](auto& c)
                 {
                   for (ShapedBody* body : {&c.lower, &c.upper})
                     body->material = {{std::numeric_limits<double>::infinity(), 0.3}, {}};
                 });
  expect_refused("interface.friction", "rolling.creepage", [](auto& c) { c.creepage.reset(); });
}

TEST(RollingCreepageTest, CellsOfAResolutionFitTheShift)
{
  for (const double cells : {0.7, 1.001, 1.5})
  {
    RollingCase c = sample();
    c.shift = cells * plan(sample()).shift;
    const RollingPlan p = plan(c);
    EXPECT_NEAR(std::remainder(p.shift, p.contact.dx), 0.0, 1e-9 * p.shift) << cells;
    EXPECT_NEAR(p.shift / *c.shift, 1.0, 0.02) << cells;
  }
}

TEST(RollingCreepageTest, NoCreepageOfEqualBodiesIsRollingWithoutFriction)
{
  // They are displaced alike, so that friction has nothing to hold: to the last digit.
  RollingCase c = sample();
  c.creepage = Creepage{};
  c.solver.mirror = false;
  c.solver.symmetry = false; // what may stick is not solved by halves, and the order of sums is one of digits
  const std::vector<RollingRecord> with = history(c);
  c.creepage.reset();
  c.friction.coefficient = 0.0;
  const std::vector<RollingRecord> without = history(c);
  ASSERT_EQ(with.size(), without.size());
  for (std::size_t i = 0; i < with.size(); ++i)
  {
    EXPECT_EQ(with[i].work, without[i].work);
    EXPECT_EQ(with[i].dissipation_lower, without[i].dissipation_lower);
    EXPECT_EQ(with[i].F_x, 0.0);
    EXPECT_EQ(with[i].dissipation_friction, 0.0);
    EXPECT_EQ(with[i].stick_share, with[i].F_n > 0.0 ? 1.0 : 0.0);
  }
}

TEST(RollingCreepageTest, ItsRecordsBelongTogether)
{
  const RollingCase c = sample();
  const RollingPlan p = plan(c);
  EXPECT_EQ(p.twin, elastoplastic::Twin::none);
  const std::vector<RollingRecord> rows = history(c);
  double largest = 0.0;
  for (const RollingRecord& r : rows)
  {
    EXPECT_NEAR(r.F_friction, std::hypot(r.F_x, r.F_y), 1e-12);
    EXPECT_LE(r.F_friction, 0.3 * r.F_n * (1.0 + 1e-12));
    EXPECT_NEAR(r.stick_area, r.stick_share * r.contact_area, 1e-12 * r.contact_area);
    largest = std::max(largest, r.F_x);
  }
  const RollingRecord &before = rows.front(), &end = rows[rows.size() - 3];
  EXPECT_EQ(before.F_x, 0.0);
  EXPECT_NEAR(end.F_x / end.F_n, 0.1924, 4e-3); // with 16 cells 0.19236: of second order
  EXPECT_GT(end.F_y, 0.0);
  EXPECT_GT(end.slip_path, 0.0);
  EXPECT_LT(end.stick_share, 1.0);
  EXPECT_GT(end.F_X, 0.003 * end.F_x); // of the plastic flow, too
  EXPECT_GT(rows.back().dissipation_friction, 0.0);
  EXPECT_EQ(rows.back().F_x, 0.0);
}

TEST(RollingCreepageTest, TheOtherWayAndTheOtherSideAreMirrorImages)
{
  // Lateral creepage and spin the other way: the mirror image in y.
  RollingCase c = sample();
  const std::vector<RollingRecord> one = history(c);
  c.creepage = Creepage{0.003, -0.001, -20.0};
  const std::vector<RollingRecord> other = history(c);
  ASSERT_EQ(one.size(), other.size());
  // Friction times load, and that times the radius of the contact, by the tolerance of the yield condition.
  const double tolerance = 1e-4, limit = 0.3 * 2.0, radius = plan(c).half_width_x;
  for (std::size_t i = 0; i < one.size(); ++i)
  {
    EXPECT_NEAR(other[i].F_x, one[i].F_x, tolerance * limit);
    EXPECT_NEAR(other[i].F_y, -one[i].F_y, tolerance * limit);
    EXPECT_NEAR(other[i].M_z, -one[i].M_z, tolerance * limit * radius);
  }
}

TEST(RollingCreepageTest, TakenUpItGoesOnAsBefore)
{
  RollingCase c = sample();
  c.passes = 2;
  simulation::Run whole(c);
  const int stop = whole.step_count() / 2 + 3; // rolling, in the second pass
  for (int i = 0; i < stop; ++i)
    whole.step();
  const Archive::Fields checkpoint = whole.checkpoint();
  simulation::Run taken_up(c, {}, &checkpoint);
  while (!whole.is_done())
  {
    const RollingRecord& a = whole.step();
    const RollingRecord& b = taken_up.step();
    EXPECT_EQ(a.F_x, b.F_x);
    EXPECT_EQ(a.work, b.work);
    EXPECT_EQ(a.dissipation_friction, b.dissipation_friction);
    EXPECT_EQ(a.slip_path, b.slip_path);
  }
  const RollingSummary one = whole.summary(), other = taken_up.summary();
  ASSERT_EQ(other.passes.size(), 2U);
  EXPECT_EQ(one.passes[1].F_x, other.passes[1].F_x);
  EXPECT_EQ(one.passes[1].creep_unsteadiness, other.passes[1].creep_unsteadiness);
  EXPECT_EQ(one.final_state.slip_path, other.final_state.slip_path);
}

TEST(RollingCreepageTest, LongStepsLoseNothingOverTheEndOfTheGrid)
{
  // Steps of several cells carry shears near the end of the contact grid out of it unless it grows before.
  RollingCase c = sample();
  c.lower.material.hardening.reset();
  c.upper.material.hardening.reset();
  c.distance = 100e-6;
  c.extent = 0.5;
  c.shift = 4.0 * plan(c).shift;
  const std::vector<RollingRecord> tight = history(c);
  EXPECT_FALSE(run(c).grid_changes.empty());
  c.extent = 2.0;
  const std::vector<RollingRecord> wide = history(c);
  ASSERT_EQ(tight.size(), wide.size());
  for (std::size_t i = 0; i < tight.size(); ++i)
    EXPECT_NEAR(tight[i].F_x, wide[i].F_x, 1e-5 * wide[i].F_n + 1e-12);
}

TEST(RollingCreepageTest, AShortTrackIsToldToBeUnsteady)
{
  RollingCase c = sample();
  c.lower.material.hardening.reset();
  c.upper.material.hardening.reset();
  c.distance = 30e-6;
  const auto keys = [](const RollingCase& rolling)
  {
    const RollingSummary summary = run(rolling);
    std::vector<std::string> found;
    for (const quality::Warning& warning : quality::judged(rolling, plan(rolling), summary).warnings)
      found.push_back(warning.key);
    return found;
  };
  const auto has = [](const std::vector<std::string>& list)
  { return std::find(list.begin(), list.end(), "unsteady_creep") != list.end(); };
  EXPECT_TRUE(has(keys(c)));
  c.distance = 300e-6;
  EXPECT_FALSE(has(keys(c)));
}

} // namespace
} // namespace brinell::simulation::rolling_creepage_test
