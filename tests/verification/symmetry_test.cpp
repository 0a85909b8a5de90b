// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/simulation/sliding.hpp"
#include "record.hpp"
#include "scenario_runs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

/// Solving one side of the plane y = 0 must not change what comes out: the same runs with both sides solved, over
/// scenarios, shapes, laws, numbers of rows and friction.
namespace brinell::verification::symmetry_test
{
namespace
{

using constitutive::Material;
using simulation::Snapshot;

template <typename ScenarioCase>
struct Outcome
{
  std::vector<simulation::StepRecord> history;
  typename ScenarioCase::Summary summary;
};

template <typename ScenarioCase>
Outcome<ScenarioCase> outcome(ScenarioCase c, bool symmetry)
{
  c.solver.symmetry = symmetry;
  EXPECT_EQ(simulation::plan(c).contact.is_mirrored_y, symmetry);
  Outcome<ScenarioCase> result;
  simulation::Observer<typename ScenarioCase::Record> observer;
  observer.on_step = [&](const simulation::StepRecord& r, int) { result.history.push_back(r); };
  result.summary = simulation::run(c, observer);
  EXPECT_EQ(result.summary.is_mirrored_y, symmetry);
  return result;
}

/// Largest difference of two fields over the largest value of the second one.
/// @param scale  over this at least
double difference(const std::vector<double>& a, const std::vector<double>& b, double scale = 0.0)
{
  EXPECT_EQ(a.size(), b.size());
  double change = 0.0, largest = scale;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
  {
    change = std::max(change, std::abs(a[i] - b[i]));
    largest = std::max(largest, std::abs(b[i]));
  }
  return largest > 0.0 ? change / largest : change;
}

using Tensors = std::array<std::vector<double>, 6>;

/// All components in both bodies as one field: some of them are small, down to rounding in a body without load.
std::vector<double> joined(const Snapshot& s, Tensors simulation::BodySnapshot::*tensors)
{
  std::vector<double> all;
  for (const simulation::BodySnapshot* body : {&s.lower, &s.upper})
    for (const std::vector<double>& component : body->*tensors)
      all.insert(all.end(), component.begin(), component.end());
  return all;
}

/// @param pressure  the largest of the run: in the end surfaces may just touch
double difference(const Snapshot& a, const Snapshot& b, double pressure)
{
  using Body = simulation::BodySnapshot;
  double change = std::max(difference(a.pressure, b.pressure, pressure), difference(a.shear[0], b.shear[0], pressure));
  for (Tensors Body::*tensors : {&Body::stress, &Body::plastic_strain})
    change = std::max(change, difference(joined(a, tensors), joined(b, tensors)));
  for (const auto& [with, without] : {std::pair{&a.lower, &b.lower}, {&a.upper, &b.upper}})
  {
    EXPECT_EQ(with->grid, without->grid);
    change = std::max({change, difference(with->equivalent_plastic_strain, without->equivalent_plastic_strain),
                       difference(with->residual_displacement, without->residual_displacement)});
  }
  for (std::size_t side = 0; side < 2; ++side)
    change = std::max(change, difference(a.temperature[side], b.temperature[side]));
  return change;
}

/// Of all numbers that every history has, each over its largest value in the run.
double difference(const std::vector<simulation::StepRecord>& a, const std::vector<simulation::StepRecord>& b)
{
  using R = simulation::StepRecord;
  double change = 0.0;
  const auto compare = [&](auto number)
  {
    std::vector<double> of_a, of_b;
    std::transform(a.begin(), a.end(), std::back_inserter(of_a), [&](const R& r) { return r.*number; });
    std::transform(b.begin(), b.end(), std::back_inserter(of_b), [&](const R& r) { return r.*number; });
    change = std::max(change, difference(of_a, of_b));
  };
  for (double R::*number : {&R::contact_area, &R::max_pressure, &R::F_n})
    compare(number);
  using T = simulation::RunningTotals;
  for (double T::*number :
       {&T::work, &T::dissipation_lower, &T::dissipation_upper, &T::dissipation_friction, &T::energy_residual,
        &T::energy_elastic, &T::max_residual_lower, &T::max_residual_upper, &T::max_equivalent_plastic_strain})
    compare(number);
  return change;
}

/// @param tolerated  difference of any number, over its largest value
/// @returns the summary of the run with symmetry
template <typename ScenarioCase>
typename ScenarioCase::Summary expect_close(const std::string& name, const ScenarioCase& c, double tolerated)
{
  SCOPED_TRACE(name);
  const auto with = outcome(c, true);
  const auto without = outcome(c, false);
  EXPECT_GT(without.summary.max_equivalent_plastic_strain, 0.0);
  EXPECT_EQ(with.history.size(), without.history.size());
  test::expect_within(name + ", histories", difference(with.history, without.history), 0.0, tolerated,
                      "both sides solved");
  double pressure = 0.0;
  for (const simulation::StepRecord& r : without.history)
    pressure = std::max(pressure, r.max_pressure);
  test::expect_within(name + ", fields at the end",
                      difference(with.summary.final_state, without.summary.final_state, pressure), 0.0, tolerated,
                      "both sides solved");
  return with.summary;
}

/// The plain fixed point contracts, so rounding stays rounding, if the contact is solved to rounding as well. The acceleration does
/// the same as without symmetry, but its least squares enlarge rounding up to the tolerances, that of the yield condition being
/// 1e-5 here.
/// @param rounding  of the plain fixed point
template <typename ScenarioCase>
typename ScenarioCase::Summary expect_same(const std::string& name, ScenarioCase c, double rounding = 1e-11)
{
  c.solver.yield_tolerance = 1e-5;
  c.solver.displacement_tolerance = 1e-6;
  expect_close(name + ", accelerated", c, 1e-3);
  c.solver.contact_tolerance = 1e-13;
  c.solver.anderson_depth = 0;
  c.solver.max_evaluations = 5000;
  return expect_close(name, c, rounding);
}

Material hardened(double modulus)
{
  Material m = perfect_material();
  m.hardening = constitutive::LinearHardening{yield_stress, modulus};
  return m;
}

Material kinematic_material()
{
  Material m = perfect_material();
  m.kinematic = {{20e9, 50.0}};
  return m;
}

TEST(Symmetry, Tugging)
{
  simulation::TuggingCase t = small_case(4.0);
  const auto summary = expect_same("twins", t);
  EXPECT_EQ(summary.final_state.contact.ny % 2, 1);
  t.upper = {ball(0.7), hardened(20e9)};
  expect_same("unlike bodies", t);
  t.lower.material = t.upper.material = kinematic_material();
  expect_same("kinematic hardening", t);
  t.friction.coefficient = 0.2;
  expect_same("friction", t);
}

/// Heat: what swells, what stress and softening do, and shares that come from one temperature.
TEST(Symmetry, Heat)
{
  simulation::TuggingCase t = warm_spheres(hardened(20e9), 3.0, 1.0, 4.0);
  const auto summary = expect_same("twins that heat each other", t);
  EXPECT_EQ(summary.final_state.contact.ny % 2, 1);
  EXPECT_GT(summary.max_temperature[0], 60.0);
  t.upper.shape = ball(7e-3);
  t.lower.material.softening = constitutive::LinearSoftening{20.0, 620.0};
  // Biconjugate gradients share the heat; they are no contraction, and each of their turns enlarges rounding.
  expect_same("unlike bodies, one of which softens", t, 1e-9);
}

TEST(Symmetry, TuggingOverBumps)
{
  simulation::TuggingCase t = small_case(3.0);
  const double a = simulation::plan(t).elastic_contact_radius;
  const simulation::Dent bump{.x = 0.5 * a, .y = 0.6 * a, .depth = -0.1 * t.interference, .edge_radius = 0.5 * a};
  simulation::Dent other = bump;
  other.y = -bump.y;
  t.lower.texture = std::vector<simulation::TexturePart>{bump, other};
  expect_same("two bumps side by side", t);
}

TEST(Symmetry, GrowingGrids)
{
  simulation::TuggingCase t = small_case(9.0);
  t.extent = 0.5;
  const auto summary = expect_same("grids that grow", t);
  EXPECT_FALSE(summary.grid_changes.empty());
}

/// The state is that of whole bodies: a run stored with one position of the switch goes on with the other.
TEST(Symmetry, ResumesAcrossTheSwitch)
{
  simulation::TuggingCase t = warm_spheres(perfect_material(), 3.0, 1.0, 4.0);
  t.upper.shape = ball(7e-3);
  t.upper.material = kinematic_material();
  t.upper.material.thermal = steel;
  t.solver.anderson_depth = 0;
  t.solver.max_evaluations = 5000;
  for (const bool first : {true, false})
  {
    t.solver.symmetry = first;
    const auto whole = computed(t);
    simulation::Run<simulation::TuggingCase> begun(t);
    for (std::size_t step = 0; 2 * step < whole.history.size(); ++step)
      static_cast<void>(begun.step());
    EXPECT_GT(begun.summary().max_equivalent_plastic_strain, 0.0);
    const Archive::Fields stored = begun.checkpoint();
    t.solver.symmetry = !first;
    const auto resumed = simulation::run(t, {}, &stored);
    double pressure = 0.0;
    for (const simulation::StepRecord& r : whole.history)
      pressure = std::max(pressure, r.max_pressure);
    test::expect_within(
        first ? "from one side to both, fields at the end" : "from both sides to one, fields at the end",
        difference(resumed.final_state, whole.summary.final_state, pressure), 0.0, 1e-11, "without a stop");
    EXPECT_NEAR(resumed.peak_F_X, whole.summary.peak_F_X, 1e-11 * whole.summary.peak_F_X);
    EXPECT_NEAR(resumed.work, whole.summary.work, 1e-11 * whole.summary.work);
  }
}

TEST(Symmetry, Indentation)
{
  const double first = critical().interference;
  simulation::IndentationCase c =
      pressed_spheres(perfect_material(), {approach(4.0 * first), approach(0.0), approach(3.0 * first)});
  c.steps = 4;
  c.resolution = 5.0;
  expect_same("ball", c);
  c.solver.integration = elastoplastic::Integration::backward_euler;
  c.solver.shortcuts = false;
  expect_same("ball, without shortcuts", c);
  c = pressed_spheres(hardened(5e9), {load(0.3)});
  c.lower = {simulation::Plane{}, hardened(5e9)};
  c.upper = {simulation::Pyramid{4, 68.0 * std::numbers::pi / 180.0, 10e-6}, {{1e12, 0.07}, {}}};
  c.steps = 3;
  c.resolution = 5.0;
  expect_close("Vickers", c, 1e-3); // the plain fixed point takes too long
}

TEST(Symmetry, Rolling)
{
  simulation::RollingCase c = ball_on_flat(track_steel(2e9), 5.2e9, 0.6e-3);
  c.resolution = 4.0;
  c.load_steps = 3;
  c.passes = 2;
  expect_same("ball on a flat", c);
  c.slide_to_roll = 0.25;
  c.friction.coefficient = 0.1;
  c.upper.material = track_steel(10e9);
  expect_same("with sliding and friction", c);
}

/// Waves in periods: an even number of rows, of which none is in the middle.
TEST(Symmetry, PeriodicSliding)
{
  constexpr double wavelength = 1e-3;
  simulation::SlidingCase c;
  c.lower = {simulation::Plane{}, hardened(2e9)};
  c.upper = {simulation::Plane{}, {{200e9, 0.3}, {}}};
  c.lower.texture = simulation::Sinusoid{.amplitude = 5e-6, .wavelength_x = wavelength, .wavelength_y = wavelength};
  c.upper.texture =
      simulation::Sinusoid{.amplitude = 5e-6, .wavelength_x = wavelength, .wavelength_y = 0.5 * wavelength};
  c.domain.x = {Boundary::periodic, wavelength, 16};
  c.domain.y = {Boundary::periodic, wavelength, 16};
  c.press = {contact::Drive::Kind::mean_gap, 2e-6};
  c.press_steps = 3;
  c.distance = 0.2 * wavelength;
  c.friction.coefficient = 0.1;
  expect_same("waves, 16 rows", c);
  c.domain.y.cells = 15;
  expect_same("waves, 15 rows", c);
}

} // namespace
} // namespace brinell::verification::symmetry_test
