// SPDX-License-Identifier: BSD-3-Clause
#include "random_field.hpp"
#include "record.hpp"
#include "scenario_runs.hpp"
#include "sweep.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

/// Short cuts within an increment (layers and cells left out until it is nearly solved) must not change what comes out: the
/// same runs with every layer and every cell in every evaluation, over loads, meshes, steps, laws and profiles.
namespace brinell::verification::shortcuts_test
{
namespace
{

using constitutive::DepthProfile;
using constitutive::Material;

enum class Profile
{
  none,
  hard_layer, ///< 4 mm of double yield stress: yields beneath it first
  soft_layer, ///< yields at the surface first
  soft_core,
  tension ///< initial stress in the surface
};

enum class Law
{
  perfect,
  linear,
  kinematic
};

Material material(Law law, Profile profile)
{
  Material m = perfect_material();
  if (law == Law::linear)
    m.hardening = constitutive::LinearHardening{yield_stress, 10e9};
  if (law == Law::kinematic)
    m.kinematic = {{20e9, 50.0}};
  switch (profile)
  {
  case Profile::hard_layer:
    m.yield_factor = DepthProfile({0.0, 4e-3, 6e-3}, {2.0, 2.0, 1.0});
    break;
  case Profile::soft_layer:
    m.yield_factor = DepthProfile({0.0, 2e-3, 3e-3}, {0.5, 0.5, 1.0});
    break;
  case Profile::soft_core:
    m.yield_factor = DepthProfile({0.0, 15e-3, 20e-3}, {1.0, 1.0, 0.5});
    break;
  case Profile::tension:
    m.initial_stress = DepthProfile({0.0, 6e-3, 8e-3}, {0.4 * yield_stress, 0.4 * yield_stress, 0.0});
    break;
  case Profile::none:
    break;
  }
  return m;
}

/// What must agree.
struct Outcome
{
  double plastic_strain = 0.0, dissipation = 0.0, force = 0.0, other_force = 0.0, residual = 0.0, temperature = 0.0;
  long evaluations = 0;
};

template <typename Run>
void take(const Run& run, Outcome& o)
{
  o.plastic_strain = run.summary.max_equivalent_plastic_strain;
  o.dissipation = run.summary.dissipation_lower + run.summary.dissipation_upper;
  o.residual = std::max(run.summary.max_residual_lower, run.summary.max_residual_upper);
  o.evaluations = run.summary.evaluations;
  o.temperature = std::max(run.summary.max_temperature[0], run.summary.max_temperature[1]);
  for (const auto& record : run.history)
    o.force = std::max(o.force, record.F_n);
}

template <typename ScenarioCase>
Outcome outcome(ScenarioCase c, bool shortcuts)
{
  c.solver.shortcuts = shortcuts;
  // What is compared is not to be the tolerances' doing: 1e-4 of the yield stress is 1e-3 of a strain at first flow.
  c.solver.yield_tolerance = 1e-5;
  c.solver.displacement_tolerance = 1e-6;
  const auto run = computed(c);
  Outcome o;
  take(run, o);
  if constexpr (std::is_same_v<ScenarioCase, simulation::TuggingCase>)
    o.other_force = run.summary.peak_F_X;
  return o;
}

/// Largest differences over a sweep, to be recorded at its end.
struct Worst
{
  double strain = 0.0, force = 0.0;

  void tell(const std::string& sweep, const test::Sweep& cases = test::Sweep(0)) const
  {
    cases.expect_within(sweep + ", largest difference of the plastic strain", strain, 0.0, 1e-3,
                        "every layer and cell in every evaluation");
    cases.expect_within(sweep + ", largest difference of a force", force, 0.0, 1e-3,
                        "every layer and cell in every evaluation");
  }
};

template <typename ScenarioCase>
void expect_same(const std::string& name, const ScenarioCase& c, Worst& worst)
{
  SCOPED_TRACE(name);
  const Outcome with = outcome(c, true);
  const Outcome without = outcome(c, false);
  const auto difference = [](double a, double b) { return b == 0.0 ? std::abs(a) : std::abs(a / b - 1.0); };
  const double yield_strain = yield_stress / elastic.young_modulus;
  // Where hardly anything has yielded the strain is as uncertain as the tolerances, so it is measured against a tenth of the
  // strain at yield at least.
  const double strain =
      std::abs(with.plastic_strain - without.plastic_strain) / std::max(without.plastic_strain, 0.1 * yield_strain);
  const double force =
      std::max(difference(with.force, without.force), difference(with.other_force, without.other_force));
  EXPECT_LE(strain, 1e-3) << with.plastic_strain << " " << without.plastic_strain;
  worst.strain = std::max(worst.strain, strain);
  worst.force = std::max(worst.force, force);
  EXPECT_LE(force, 1e-3);
  EXPECT_EQ(with.plastic_strain > 0.0, without.plastic_strain > 0.0);
  EXPECT_LE(difference(with.temperature, without.temperature), 1e-3);
}

struct Press
{
  double load; ///< approach over that of first yield
  double resolution;
  int steps;
  Profile profile = Profile::none;
  Law law = Law::perfect;
};

simulation::IndentationCase pressed(const Press& press)
{
  const double largest = press.load * critical().interference;
  simulation::IndentationCase c =
      pressed_spheres(material(press.law, press.profile), {approach(largest), approach(0.0)});
  c.steps = press.steps;
  c.resolution = press.resolution;
  c.extent = 0.7;
  return c;
}

TEST(ShortCuts, IndentationsAtChosenPlaces)
{
  if (slow_build)
    GTEST_SKIP() << "fine meshes";
  Worst worst;
  int number = 0;
  for (const Press& press :
       {Press{0.9, 8, 10}, Press{1.02, 4, 1}, Press{1.1, 14, 20}, Press{1.5, 20, 10},
        Press{2.0, 8, 20, Profile::hard_layer}, Press{2.0, 12, 5, Profile::hard_layer, Law::linear}, Press{1.2, 32, 1},
        Press{1.5, 6, 40, Profile::tension}, Press{3.0, 5, 1, Profile::none, Law::kinematic},
        Press{1.3, 10, 10, Profile::soft_core, Law::kinematic}, Press{0.9, 8, 5, Profile::soft_layer},
        Press{1.4, 16, 4, Profile::soft_core}})
    expect_same("chosen press " + std::to_string(number++), pressed(press), worst);
  worst.tell("presses at chosen places");
}

TEST(ShortCuts, RandomIndentations)
{
  std::mt19937_64 engine(20061);
  const auto between = [&](double a, double b) { return test::uniform(engine, a, b); };
  Worst worst;
  const int count = slow_build ? 3 : 24;
  const test::Sweep cases(count);
  for (int number = 0; number < count; ++number)
  {
    const Press press{between(0.9, 3.0), between(4.0, 8.0), static_cast<int>(std::exp(between(0.0, std::log(40.0)))),
                      static_cast<Profile>(static_cast<int>(between(0.0, 5.0))),
                      static_cast<Law>(static_cast<int>(between(0.0, 3.0)))};
    if (!cases.has(number))
      continue;
    expect_same("random press " + std::to_string(number), pressed(press), worst);
  }
  worst.tell("random presses", cases);
}

TEST(ShortCuts, Rolling)
{
  std::mt19937_64 engine(20062);
  const auto between = [&](double a, double b) { return test::uniform(engine, a, b); };
  Worst worst;
  const int count = slow_build ? 1 : 8;
  const test::Sweep cases(count);
  for (int number = 0; number < count; ++number)
  {
    const double load = between(0.95, 3.0); // approach over that of first yield
    const Profile profile = static_cast<Profile>(number % 5);
    const double a = std::sqrt(0.5 * load * critical().interference);
    simulation::RollingCase c;
    c.lower = {ball(1.0), material(static_cast<Law>(number % 3), profile)};
    c.upper = {ball(1.0), number % 2 == 0 ? elastic_material() : material(Law::linear, Profile::none)};
    c.drive = approach(load * critical().interference);
    c.distance = 2.0 * a;
    c.passes = 2;
    c.slide_to_roll = number % 4 == 3 ? 0.5 : 0.0;
    c.load_steps = 3;
    c.resolution = between(4.0, number == 0 ? 12.0 : 6.0);
    c.extent = 0.7;
    if (cases.has(number))
      expect_same("rolling " + std::to_string(number), c, worst);
  }
  worst.tell("rolling", cases);
}

TEST(ShortCuts, Tugging)
{
  struct Tug
  {
    double load, resolution, cells_per_step;
    Profile profile = Profile::none;
  };
  Worst worst;
  int number = 0;
  for (const Tug& tug : {Tug{0.9, 6, 1}, Tug{1.2, 16, 1}, Tug{1.2, 5, 0.5}, Tug{2, 8, 2, Profile::hard_layer},
                         Tug{3, 6, 1, Profile::tension}, Tug{1.5, 5, 1, Profile::soft_core}})
  {
    if (slow_build && tug.resolution > 5)
      continue;
    simulation::TuggingCase t = equal_spheres(tug.load, material(Law::perfect, tug.profile));
    t.resolution = tug.resolution;
    t.shift = tug.cells_per_step * simulation::plan(t).elastic_contact_radius / tug.resolution;
    t.extent = 0.7;
    expect_same("tugging " + std::to_string(number++), t, worst);
  }
  worst.tell("tugging");
}

/// Largest differences between runs with windows and runs that compute all columns in every evaluation.
struct WorstOfWindows
{
  double strain = 0.0, residual = 0.0, force = 0.0; ///< relative

  template <typename Case>
  void compare(Case c)
  {
    c.solver.yield_tolerance = 1e-5;
    c.solver.displacement_tolerance = 1e-6;
    Outcome with, without;
    for (Outcome* o : {&with, &without})
    {
      c.solver.windows = o == &with;
      take(computed(c), *o);
    }
    const double yield_strain = yield_stress / elastic.young_modulus;
    EXPECT_NE(with.dissipation, without.dissipation) << "no window has been used";
    strain = std::max(strain, std::abs(with.plastic_strain - without.plastic_strain) /
                                  std::max(without.plastic_strain, 0.1 * yield_strain));
    residual = std::max(residual, std::abs(with.residual / without.residual - 1.0));
    force = std::max(force, std::abs(with.force / without.force - 1.0));
  }

  void tell(const std::string& what) const
  {
    test::expect_within(what + " in windows, largest difference of the plastic strain", strain, 0.0, 1e-3,
                        "all columns in every evaluation");
    test::expect_within(what + " in windows, largest difference of the residual displacement", residual, 0.0, 1e-3,
                        "all columns in every evaluation");
    EXPECT_LE(force, 1e-3); // of rolling it is that of pressing, mostly before any window
  }
};

/// The balls roll far, so that their tracks are several times as long as the contact.
TEST(ShortCuts, Windows)
{
  std::mt19937_64 engine(20063);
  const auto between = [&](double a, double b) { return test::uniform(engine, a, b); };
  WorstOfWindows worst;
  const int count = slow_build ? 1 : 5;
  for (int number = 0; number < count; ++number)
  {
    SCOPED_TRACE(number);
    const double load = between(1.2, 4.0); // approach over that of first yield
    const double a = std::sqrt(0.5 * load * critical().interference);
    simulation::RollingCase c;
    c.lower = {ball(1.0), material(static_cast<Law>(number % 3), static_cast<Profile>(number % 5))};
    c.upper = {ball(1.0), number % 2 == 0 ? elastic_material() : material(Law::linear, Profile::none)};
    c.drive = approach(load * critical().interference);
    c.distance = between(11.0, 14.0) * a;
    c.passes = 2;
    c.slide_to_roll = number % 4 == 3 ? 0.5 : 0.0;
    c.load_steps = 3;
    c.resolution = between(4.0, 5.0);
    c.solver.symmetry = number % 3 != 1;
    worst.compare(c);
  }
  worst.tell("rolling");
}

/// Hard on soft layers on a body, and soft ones on a hard body, which roll far: with and without windows, and with and without all
/// layers and cells in every evaluation.
TEST(ShortCuts, CoatedRolling)
{
  const double load = 3.0, a = std::sqrt(0.5 * load * critical().interference);
  const constitutive::HardeningLaw strong = constitutive::LinearHardening{2.0 * yield_stress, 20e9};
  const constitutive::HardeningLaw weak = constitutive::LinearHardening{0.6 * yield_stress, 5e9};
  WorstOfWindows worst;
  Worst cells;
  for (const bool hard : {true, false})
  {
    SCOPED_TRACE(hard);
    simulation::RollingCase c;
    c.lower = {ball(1.0), material(Law::linear, Profile::none)};
    c.upper = {ball(1.0), elastic_material()};
    const Elastic stiff{2.0 * elastic.young_modulus, 0.22}, soft{0.5 * elastic.young_modulus, 0.35};
    c.lower.material.layers = {{0.4 * a, hard ? stiff : soft, hard ? strong : weak},
                               {0.4 * a, hard ? soft : stiff, hard ? weak : strong}};
    c.drive = approach(load * critical().interference);
    c.distance = 12.0 * a;
    c.load_steps = 3;
    c.resolution = 4.5;
    worst.compare(c);
    c.distance = 3.0 * a;
    expect_same(hard ? "hard" : "soft", c, cells);
  }
  EXPECT_LE(worst.strain, 1e-3);
  EXPECT_LE(worst.residual, 1e-3);
  EXPECT_LE(worst.force, 1e-3);
  std::printf("windows: strain %.1e, residual %.1e, force %.1e; cells: strain %.1e, force %.1e\n", worst.strain,
              worst.residual, worst.force, cells.strain, cells.force);
}

/// The contact grows until the windows are the longest ones, and shrinks again.
TEST(ShortCuts, WindowsOfTugging)
{
  WorstOfWindows worst;
  int number = 0;
  for (const double load : {2.0, 4.0, 6.0, 9.0})
  {
    if (slow_build && load > 2.0)
      continue;
    SCOPED_TRACE(load);
    simulation::TuggingCase t = equal_spheres(load, material(static_cast<Law>(number % 3), Profile::none));
    t.upper.material.hardening = number % 2 == 0 ? t.lower.material.hardening : elastic_material().hardening;
    t.resolution = 6.0;
    ++number;
    worst.compare(t);
  }
  worst.tell("tugging");
}

/// Those of heat: images on coarse cells, shares that are rough until an increment is nearly solved, heat that follows a turn
/// behind. Without them it is computed as exactly as it can be, along grids long enough for all of them.
TEST(ShortCuts, Heat)
{
  struct Rub
  {
    double load, speed, resolution;
    Law law;
    bool softens;
  };
  Worst worst;
  int number = 0;
  for (const Rub& rub : {Rub{2.0, 1.0, 5.0, Law::perfect, false}, Rub{4.0, 0.02, 6.0, Law::linear, false},
                         Rub{3.0, 10.0, 5.0, Law::kinematic, false}, Rub{3.0, 1.0, 6.0, Law::linear, true}})
  {
    if (slow_build && rub.resolution > 5.0)
      continue;
    simulation::TuggingCase t = warm_spheres(material(rub.law, Profile::none), rub.load, rub.speed, rub.resolution);
    if (rub.softens)
      for (simulation::ShapedBody* body : {&t.lower, &t.upper})
        body->material.softening = constitutive::LinearSoftening{20.0, 1000.0};
    expect_same("rub " + std::to_string(number++), t, worst);
  }
  worst.tell("heat");
}

} // namespace
} // namespace brinell::verification::shortcuts_test
