// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/reference/hertz.hpp"
#include "order.hpp"
#include "record.hpp"
#include "scenario_runs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

/// Bodies without ends: plane strain, and periodic surfaces.
namespace brinell::verification
{
namespace
{

using simulation::IndentationCase;
using simulation::IndentationRecord;

constexpr double pi = std::numbers::pi;
constexpr double inf = std::numeric_limits<double>::infinity();
constexpr const char* too_slow = "needs fine cells: too slow in this build";

const Elastic steel{200e9, 0.3};

constitutive::Material soft_steel()
{
  return {steel, constitutive::LinearHardening{600e6, 20e9}};
}

simulation::Domain plane_strain()
{
  simulation::Domain domain;
  domain.y = {Boundary::periodic, 1.0, 1};
  return domain;
}

/// A cylinder of 10 mm without ends on a flat.
IndentationCase cylinder_on_flat(const constitutive::Material& lower, std::vector<contact::Drive> sequence)
{
  IndentationCase c;
  c.lower = {simulation::Plane{}, lower};
  c.upper = {simulation::Roller{10e-3, inf}, {steel, {}}};
  c.domain = plane_strain();
  c.sequence = std::move(sequence);
  return c;
}

double modulus()
{
  return contact_modulus(steel, steel);
}

TEST(PlaneStrain, ElasticCylinderHasTheLineContactOfHertz)
{
  const double P = 1e6; // per metre
  const auto exact = reference::line_contact_at_load(10e-3, modulus(), P);
  // Approach of the centres: P/(pi E') (ln(4 pi E' R / P) - 1) (Johnson 1985, Eq. 5.56 of two equal bodies).
  const double centres = P / (pi * modulus()) * (std::log(4.0 * pi * modulus() * 10e-3 / P) - 1.0);
  std::vector<double> peaks, approaches;
  for (const double cells : {8.0, 16.0, 32.0})
  {
    IndentationCase c = cylinder_on_flat({steel, {}}, {load(P)});
    c.resolution = cells;
    c.steps = 1;
    const IndentationRecord r = computed(c).history.back();
    peaks.push_back(r.max_pressure / exact.peak_pressure - 1.0);
    approaches.push_back(r.approach / centres - 1.0);
  }
  EXPECT_GT(test::Orders("line contact, peak pressure, cells halved", peaks).overall, 1.4); // the edge moves in cells
  EXPECT_GT(test::Orders("line contact, approach, cells halved", approaches).overall, 1.4);
  test::expect_close("line contact: peak pressure", 1.0 + peaks.back(), 1.0, 1e-3, "exact: Hertz");
  test::expect_close("line contact: approach of the centres", 1.0 + approaches.back(), 1.0, 1e-4,
                     "exact: Johnson (1985), section 5.6");
}

TEST(PlaneStrain, IsTheMiddleOfALongRoller)
{
  // The ends of an elastic-plastic roller bear more than their share. What is left for its middle, per length, makes the same
  // dent there as in plane strain, but for what the ends give, which falls with their distance.
  if (slow_build)
    GTEST_SKIP() << too_slow;
  const auto cylinder = [](double load_per_length)
  {
    IndentationCase c = cylinder_on_flat(soft_steel(), {load(load_per_length), load(0.0)});
    c.resolution = 6.0;
    c.steps = 6;
    return c;
  };
  const double b = simulation::plan(cylinder(1.5e6)).contact_radius;
  const double dx = simulation::plan(cylinder(1.5e6)).contact.dx;
  std::vector<double> errors;
  for (const double length : {8.0, 24.0})
  {
    IndentationCase c = cylinder(1.5e6);
    c.domain = {};
    c.upper.shape = simulation::Roller{10e-3, length * b};
    c.sequence = {load(1.5e6 * length * b), load(0.0)};
    const double rows = 2.0 * std::round(0.5 * length * b / (2.0 * dx)) + 1.0;
    c.spacing = {{dx, length * b / rows, 0.5 * dx}};
    double load_in_middle = 0.0; // per length
    simulation::Observer<IndentationRecord> observer;
    observer.wants_snapshot = [&](const IndentationRecord& r) { return r.step == c.steps - 1; };
    observer.on_snapshot = [&](const IndentationRecord&, const simulation::Snapshot& s)
    {
      for (int i = 0; i < s.contact.nx; ++i)
        load_in_middle += s.pressure[s.contact.index(i, s.contact.ny / 2)] * s.contact.dx;
    };
    const simulation::IndentationSummary roller = simulation::run(c, observer);
    const simulation::BodySnapshot& body = roller.final_state.lower;
    const SurfaceGrid& g = body.grid.surface;
    const double dent = body.residual_displacement[g.index(g.nx / 2, g.ny / 2)];
    IndentationCase plane = cylinder(load_in_middle);
    plane.spacing = {{dx, 1.0, 0.5 * dx}};
    const double dent_of_plane = computed(plane).summary.indents.front().residual_depth;
    std::printf("roller of %g half-widths: the middle bears %.3f of the mean load; dent %.4f of that in plane strain\n",
                length, load_in_middle / 1.5e6, dent / dent_of_plane);
    errors.push_back(dent / dent_of_plane - 1.0);
  }
  EXPECT_LT(std::abs(errors[1]), std::abs(errors[0]) / 3.0); // at least first order in the distance of the ends
}

TEST(PlaneStrain, TuggingOfCylindersGivesBackTheWorkIfTheyStayElastic)
{
  simulation::TuggingCase t;
  t.lower = {simulation::Roller{1.0, inf}, {steel, {}}};
  t.upper = t.lower;
  t.domain = plane_strain();
  t.interference = 1e-3;
  t.resolution = slow_build ? 8.0 : 14.0;
  const auto run = computed(t);
  double largest = 0.0;
  double antisymmetry = 0.0;
  const std::size_t n = run.history.size();
  for (std::size_t i = 0; i < n; ++i)
  {
    largest = std::max(largest, std::abs(run.history[i].F_X));
    antisymmetry = std::max(antisymmetry, std::abs(run.history[i].F_X + run.history[n - 1 - i].F_X));
  }
  EXPECT_LT(antisymmetry, 1e-6 * largest);
  EXPECT_LT(std::abs(run.summary.last.work), 1e-3 * run.summary.last.energy_elastic + 1e-6 * largest * 0.1);
}

TEST(PlaneStrain, SwappedCylindersMirrorThePassAndEnergyCloses)
{
  if (slow_build)
    GTEST_SKIP() << too_slow;
  simulation::TuggingCase t;
  t.lower = {simulation::Roller{1.0, inf}, {steel, constitutive::PerfectPlasticity{0.9e9}}};
  t.upper = {simulation::Roller{1.0, inf}, {steel, constitutive::LinearHardening{0.7e9, 5e9}}};
  t.domain = plane_strain();
  t.interference = 0.8e-3;
  t.resolution = 10.0;
  const auto run = computed(t);
  std::swap(t.lower, t.upper);
  const auto swapped = computed(t);
  ASSERT_EQ(run.history.size(), swapped.history.size());
  double largest = 0.0;
  double difference = 0.0;
  for (std::size_t i = 0; i < run.history.size(); ++i)
  {
    largest = std::max(largest, std::abs(run.history[i].F_X));
    difference = std::max(difference, std::abs(run.history[i].F_X - swapped.history[i].F_X));
  }
  EXPECT_LT(difference, 1e-3 * largest);
  test::expect_close("tugging of cylinders: energy balance error", run.summary.energy_balance_error, 0.0, 5e-3,
                     "energy: work = dissipated + stored");
}

/// A ball of 10 mm on a flat, again after each period in both directions.
IndentationCase balls_on_flat(const constitutive::Material& lower, double period, int cells,
                              std::vector<contact::Drive> sequence)
{
  IndentationCase c;
  c.lower = {simulation::Plane{}, lower};
  c.upper = {ball(10e-3), {steel, {}}};
  c.domain.x = {Boundary::periodic, period, cells};
  c.domain.y = c.domain.x;
  c.sequence = std::move(sequence);
  return c;
}

TEST(PeriodicSurfaces, TendToTheOpenOneAsThePeriodGrows)
{
  // Of a load F on each ball the others take their part: the mean pressure F / L^2 is not there for them to displace. To first
  // order the surface under the ball rises as a whole by a multiple of F / (E' L), so that the approach has an error of order
  // 1 / L, and the pressure, to which that does nothing, of order 1 / L^3.
  const double F = 20.0;
  const auto hertz = reference::point_contact_at_load(10e-3, modulus(), F);
  const double cell = hertz.contact_radius / 8.0;
  std::vector<double> approaches;
  for (const int cells : {48, 96, 192})
  {
    IndentationCase c = balls_on_flat({steel, {}}, cells * cell, cells, {load(F)});
    c.steps = 1;
    c.domain.layer = 4.0 * cell; // nothing happens in depth
    const IndentationRecord r = computed(c).history.back();
    approaches.push_back(r.approach / hertz.approach - 1.0);
    test::expect_close("balls every " + std::to_string(cells / 8) + " contact radii: peak pressure",
                       r.max_pressure / hertz.peak_pressure, 1.0, 0.01 + 30.0 * std::pow(8.0 / cells, 3),
                       "exact: Hertz");
  }
  const test::Orders orders("periodic balls, approach, period doubled", approaches);
  EXPECT_NEAR(orders.overall, 1.0, 0.1);
}

TEST(PeriodicSurfaces, NothingChangesWhenTheContactIsMovedAroundThePeriod)
{
  const double period = 0.6e-3;
  const int cells = 24;
  IndentationCase c = balls_on_flat(soft_steel(), period, cells, {load(60.0), load(0.0)});
  c.steps = 3;
  const auto here = computed(c);
  c.places = {9 * period / cells}; // so that the dent lies over the end of the grid
  const auto there = computed(c);
  ASSERT_EQ(here.history.size(), there.history.size());
  for (std::size_t i = 0; i < here.history.size(); ++i)
  {
    EXPECT_NEAR(there.history[i].approach, here.history[i].approach, 1e-9 * here.history[2].approach);
    EXPECT_NEAR(there.history[i].max_pressure, here.history[i].max_pressure, 1e-7 * here.history[2].max_pressure);
    EXPECT_NEAR(there.history[i].residual_depth, here.history[i].residual_depth, 1e-6 * here.history[2].residual_depth);
  }
  const auto& a = here.summary.final_state.lower;
  const auto& b = there.summary.final_state.lower;
  for (int j = 0; j < cells; ++j)
    for (int i = 0; i < cells; ++i)
      EXPECT_NEAR(b.residual_displacement[b.grid.surface.index((i + 9) % cells, j)],
                  a.residual_displacement[a.grid.surface.index(i, j)], 1e-6 * here.history[2].residual_depth);
}

TEST(PeriodicSurfaces, EnergyClosesThroughLoadingAndUnloading)
{
  IndentationCase c = balls_on_flat(soft_steel(), 0.6e-3, slow_build ? 24 : 48, {load(80.0), load(0.0)});
  c.steps = slow_build ? 8 : 16;
  const auto run = computed(c);
  EXPECT_GT(run.summary.last.dissipation_lower, 0.0);
  test::expect_close("periodic balls: energy balance error", run.summary.energy_balance_error, 0.0,
                     slow_build ? 2e-2 : 5e-3, "energy: work = dissipated + stored");
}

TEST(PeriodicSurfaces, ShortcutsChangeNothing)
{
  IndentationCase c = balls_on_flat(soft_steel(), 0.6e-3, 24, {load(80.0), load(0.0)});
  c.steps = 4;
  const auto with = computed(c);
  c.solver.shortcuts = false;
  const auto without = computed(c);
  for (std::size_t i = 0; i < with.history.size(); ++i)
  {
    EXPECT_NEAR(with.history[i].approach, without.history[i].approach, 1e-3 * without.history[3].approach);
    EXPECT_NEAR(with.history[i].max_equivalent_plastic_strain, without.history[i].max_equivalent_plastic_strain,
                1e-3 * without.history[3].max_equivalent_plastic_strain);
  }
}

} // namespace
} // namespace brinell::verification
