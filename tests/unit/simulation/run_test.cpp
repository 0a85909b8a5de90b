// SPDX-License-Identifier: BSD-3-Clause
// A run that its owner steps: the same as a whole one, whenever it is stored, moved or looked at.
#include "brinell/simulation/run.hpp"

#include "brinell/foundation/error.hpp"
#include "template_cases.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace brinell::simulation::run_test
{
namespace
{

const constitutive::Material steel{{210e9, 0.3}, constitutive::PerfectPlasticity{1e9}};

/// Friction and slip: they have a state of their own.
TuggingCase tugging()
{
  TuggingCase c;
  c.lower = {Paraboloid{1e-3, 1e-3}, steel};
  c.upper = {Paraboloid{1.5e-3, 1.5e-3}, steel};
  c.interference = 3e-7;
  c.resolution = 3.0;
  c.friction.coefficient = 0.2;
  return c;
}

IndentationCase indentation()
{
  IndentationCase c = test::template_case<IndentationCase>();
  c.steps = 4;
  c.places = {-20e-6, 20e-6};
  return c;
}

RollingCase rolling()
{
  RollingCase c;
  c.lower = {Plane{}, steel};
  c.upper = {Paraboloid{1e-3, 1e-3}, steel};
  c.drive = {contact::Drive::Kind::load, 2.0};
  c.distance = 60e-6;
  c.passes = 2;
  c.load_steps = 2;
  c.resolution = 3.0;
  c.slide_to_roll = 0.3;
  c.friction.coefficient = 0.2;
  return c;
}

FrettingCase fretting()
{
  FrettingCase c;
  c.lower = {Plane{}, steel};
  c.upper = {Paraboloid{1e-3, 1e-3}, {{400e9, 0.25}, {}}};
  c.press = {contact::Drive::Kind::load, 2.0};
  c.press_steps = 3;
  c.kind = FrettingCase::Kind::force;
  c.amplitude = 0.5;
  c.steps_per_cycle = 8;
  c.direction = 0.4;
  c.resolution = 4.0;
  c.friction.coefficient = 0.4;
  return c;
}

SlidingCase sliding()
{
  constexpr double period = 40e-6;
  SlidingCase c;
  c.lower = {Plane{}, steel};
  c.upper = {Plane{}, {{400e9, 0.25}, {}}};
  c.lower.texture = Sinusoid{0.2e-6, period, period};
  c.upper.texture = Sinusoid{0.1e-6, 0.5 * period, period};
  c.domain.x = c.domain.y = {Boundary::periodic, period, 16};
  c.press = {contact::Drive::Kind::mean_gap, 0.2e-6};
  c.press_steps = 2;
  c.distance = 7.5e-6;
  c.strokes = 2;
  c.to_and_fro = true;
  c.friction.coefficient = 0.2;
  return c;
}

/// A case of each scenario. One whose motion keeps more than the case of `brinell new` shows has one of its own.
template <typename Case>
Case sample()
{
  return test::template_case<Case>();
}
template <>
TuggingCase sample()
{
  return tugging();
}
template <>
IndentationCase sample()
{
  return indentation();
}
template <>
RollingCase sample()
{
  return rolling();
}
template <>
FrettingCase sample()
{
  return fretting();
}
template <>
SlidingCase sample()
{
  return sliding();
}

template <typename Case>
class RunTest : public testing::Test
{
protected:
  Case scenario = sample<Case>();

  /// Goes on to the end.
  static typename Case::Summary finish(simulation::Run<Case>& run)
  {
    while (!run.is_done())
      run.step();
    return run.summary();
  }
  static void expect_same(const typename Case::Summary& a, const typename Case::Summary& b)
  {
    EXPECT_EQ(a.steps, b.steps);
    EXPECT_EQ(a.evaluations, b.evaluations);
    EXPECT_EQ(a.work, b.work);
    EXPECT_EQ(a.energy_balance_error, b.energy_balance_error);
    EXPECT_EQ(a.dissipation_friction, b.dissipation_friction);
    EXPECT_EQ(a.last.F_n, b.last.F_n);
    EXPECT_EQ(a.final_state.lower.equivalent_plastic_strain, b.final_state.lower.equivalent_plastic_strain);
    EXPECT_EQ(a.final_state.lower.contact_x, b.final_state.lower.contact_x);
  }
};

TYPED_TEST_SUITE(RunTest, Scenarios<testing::Types>);

TYPED_TEST(RunTest, SteppedIsTheSameAsWhole)
{
  simulation::Run<TypeParam> stepped(this->scenario);
  int steps = 0;
  double dissipation = 0.0;
  while (!stepped.is_done())
  {
    const auto& record = stepped.step();
    EXPECT_EQ(record.step, steps++);
    dissipation = record.dissipation_lower;
  }
  EXPECT_GT(dissipation, 0.0); // it yields: there is a history to be told
  EXPECT_EQ(steps, stepped.step_count());
  this->expect_same(stepped.summary(), run(this->scenario));
}

TYPED_TEST(RunTest, GoesOnFromEveryCheckpointToTheSameEnd)
{
  simulation::Run<TypeParam> first(this->scenario);
  std::vector<Archive::Fields> stored{first.checkpoint()};
  while (!first.is_done())
  {
    first.step();
    stored.push_back(first.checkpoint());
  }
  const auto expected = first.summary();
  for (std::size_t i = 0; i < stored.size(); i += 5)
  {
    simulation::Run<TypeParam> second(this->scenario, {}, &stored[i]);
    this->expect_same(this->finish(second), expected);
  }
}

TYPED_TEST(RunTest, MayBeMovedBetweenSteps)
{
  simulation::Run<TypeParam> first(this->scenario);
  first.step();
  first.step();
  simulation::Run<TypeParam> second(std::move(first));
  first = std::move(second);
  this->expect_same(this->finish(first), run(this->scenario));
}

TYPED_TEST(RunTest, SnapshotsShowTheStepAndChangeNothing)
{
  simulation::Run<TypeParam> watched(this->scenario);
  while (!watched.is_done())
  {
    const auto record = watched.step();
    const Snapshot s = watched.snapshot();
    double force = 0.0;
    for (const double p : s.pressure)
      force += p * s.contact.dx * s.contact.dy;
    EXPECT_NEAR(force, record.F_n, 1e-12 * std::abs(record.F_n));
    static_cast<void>(watched.summary());
  }
  this->expect_same(watched.summary(), run(this->scenario));
}

TYPED_TEST(RunTest, RefusesStepsBeyondItsEndAndStatesOfAnotherCase)
{
  simulation::Run<TypeParam> whole(this->scenario);
  this->finish(whole);
  EXPECT_THROW(whole.step(), InternalError);

  Archive::Fields state = simulation::Run<TypeParam>(this->scenario).checkpoint();
  state.erase(state.begin());
  EXPECT_THROW(simulation::Run<TypeParam>(this->scenario, {}, &state), InputError);
}

TYPED_TEST(RunTest, GoesNoFurtherAfterAStepThatFailed)
{
  // Left halfway, a motion would go on from another place than the bodies.
  bool stops = false;
  Watch watch;
  watch.wants_stop = [&stops] { return stops; };
  simulation::Run<TypeParam> run(this->scenario, watch);
  run.step();
  stops = true;
  EXPECT_THROW(run.step(), Interrupted);
  stops = false;
  EXPECT_THROW(run.step(), InputError);
  EXPECT_THROW(static_cast<void>(run.checkpoint()), InputError);
}

/// Where textures touch follows from the case; how far earlier passes went beyond it does not.
TEST(TexturedTugging, IsTakenUpAtAnyStep)
{
  TuggingCase c = tugging();
  c.lower.shape = Paraboloid{1e-3, 2e-3};
  const RandomSurface rough({.hurst = 0.8,
                             .rms_height = 2e-8,
                             .rms_slope = {},
                             .rolloff = 6e-5,
                             .cutoff = 3e-5,
                             .size_x = 4e-4,
                             .size_y = 3e-4,
                             .seed = 4});
  c.lower.texture = std::vector<TexturePart>{Dent{.x = -1e-5, .depth = -2e-7, .edge_radius = 0.75e-5}, rough};
  c.upper.texture =
      sampled([](double x, double y) { return 5e-8 * std::cos(1e5 * x) * std::cos(1e5 * y); }, 65, 33, 2e-6, 4e-6);
  c.passes = 2;
  simulation::Run<TuggingCase> whole(c);
  std::vector<Archive::Fields> checkpoints;
  while (!whole.is_done())
  {
    whole.step();
    checkpoints.push_back(whole.checkpoint());
  }
  const TuggingSummary expected = whole.summary();
  for (const std::size_t at : {std::size_t{0}, checkpoints.size() / 3, checkpoints.size() / 2, checkpoints.size() - 2})
  {
    simulation::Run<TuggingCase> later(c, {}, &checkpoints[at]);
    while (!later.is_done())
      later.step();
    EXPECT_EQ(later.summary().steps, expected.steps) << at;
    EXPECT_EQ(later.summary().work, expected.work) << at;
    EXPECT_EQ(later.summary().last.F_n, 0.0);
  }
}

} // namespace
} // namespace brinell::simulation::run_test
