// SPDX-License-Identifier: BSD-3-Clause
// One increment of two elastic-plastic bodies: the conditions its result must meet.
#include "elastoplastic/increment/stop_rules.hpp"
#include "elastoplastic/increment/window_error.hpp"
#include "sphere_press.hpp"
#include "state_comparison.hpp"

#include "brinell/foundation/error.hpp"
#include "order.hpp"
#include "refusal.hpp"
#include "volume_fields.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace brinell::elastoplastic::increment_test
{
namespace
{

TEST(IncrementTest, ConvergedStateIsAdmissibleAndBalanced)
{
  for (const double modulus : {0.0, 20e9})
  {
    PressOptions options;
    options.hardening_modulus = modulus;
    SpherePress press(options);
    for (const double interference : {2.0, 4.0, 6.0, 3.0}) // the last one unloads
    {
      const IncrementReport report = press.press(interference);
      ASSERT_TRUE(report.converged);
      EXPECT_LE(report.yield_error, options.settings.yield_tolerance);

      // The stress anew, from the committed strain and the pressure: it is admissible everywhere, to the tolerance.
      const std::vector<double> pressure = copy(press.contact().pressure());
      std::vector<double> gap = press.rigid_gap(interference);
      for (const BodyView& body : {press.contact().lower(), press.contact().upper()})
      {
        const BodyState state = body.state();
        const halfspace::HalfSpace half_space(body.grid(), body.material().elastic);
        const test::StressField stress(half_space, pressure, state.plastic_strain);
        for (std::size_t cell = 0; cell < body.grid().size(); ++cell)
        {
          const double yield = SpherePress::yield_stress + modulus * state.equivalent[cell];
          ASSERT_LE(von_mises(test::deviator_at(stress.deviator, cell)),
                    yield * (1.0 + options.settings.yield_tolerance));
        }
        halfspace::HalfSpace::Work work = half_space.make_work();
        std::vector<double> u(gap.size());
        half_space.load(state.plastic_strain, body.grid().nz, work).displacement({.z = u});
        expect_near(u, state.residual_displacement, 1e-10, "residual displacement"); // round-off
        for (std::size_t i = 0; i < gap.size(); ++i)
          gap[i] += u[i];
      }
      // The gap anew: no pressure where it is open, none closed beyond the tolerance.
      const halfspace::SurfaceCompliance compliance(
          press.contact().grid(),
          contact_modulus(press.contact().lower().material().elastic, press.contact().upper().material().elastic));
      std::vector<double> u(gap.size());
      halfspace::SurfaceCompliance::Scratch scratch = compliance.make_scratch();
      compliance.apply({.pressure = pressure}, {.z = u}, scratch);
      const double tolerance = 1.001 * options.settings.contact_tolerance * 6.0 * SpherePress::alpha_c;
      for (std::size_t i = 0; i < gap.size(); ++i)
      {
        gap[i] += u[i];
        EXPECT_GE(pressure[i], 0.0);
        EXPECT_GE(gap[i], -tolerance);
        EXPECT_TRUE(pressure[i] == 0.0 || std::abs(gap[i]) <= tolerance) << gap[i];
      }
    }
    EXPECT_GT(largest(press.contact().lower().state().equivalent), 1e-3); // the press did yield
  }
}

TEST(IncrementTest, TheContactDoesNotHoldUpTightTolerances)
{
  // Whatever the contact leaves unsolved changes from evaluation to evaluation: with the default tolerance of the contact it would
  // be as large as these tolerances of yield and displacement.
  for (const double tolerance : {1e-7, 1e-8, 1e-9})
  {
    PressOptions options;
    options.settings.yield_tolerance = options.settings.displacement_tolerance = tolerance;
    SpherePress press(options);
    const IncrementReport report = press.press(6.0);
    EXPECT_TRUE(report.converged);
    EXPECT_LE(report.gap_error, 1e-3 * tolerance * 6.0 * SpherePress::alpha_c);
  }
}

TEST(IncrementTest, ErrorsOfAWindowDoNotMakeLaterOnesStall)
{
  // An evaluation of all columns after those of a window may have an error that is larger by orders of magnitude, from which it
  // falls as before.
  const auto stalls = [](bool begins_anew)
  {
    StallRule rule;
    bool stalled = rule.stalls(1e-8, false);
    double error = 1e-3;
    for (int evaluation = 0; evaluation < 30; ++evaluation, error *= 0.7)
      stalled = rule.stalls(error, begins_anew && evaluation == 0) || stalled;
    return stalled;
  };
  EXPECT_TRUE(stalls(false));
  EXPECT_FALSE(stalls(true));
}

TEST(IncrementTest, EvaluationsOfAWindowEndWhereItsErrorIsAsLargeAsTheRest)
{
  // A model of the increment: each evaluation halves what is left to solve, and all columns find the error of the window on top.
  const auto last_of_window = [](double error_of_window)
  {
    WindowError estimate;
    double last = 0.0;
    for (int increment = 0; increment < 20; ++increment) // the estimate falls by half or more at each
    {
      for (last = 0.4; last > estimate.limit() && last > 1e-9; last *= 0.5)
      {
      }
      estimate.compare(last, 0.5 * last + error_of_window);
    }
    return last;
  };
  for (const double error : {1e-8, 1e-6, 1e-4, 1e-2})
  {
    EXPECT_GT(last_of_window(error), 0.5 * error) << "evaluations were lost";
    EXPECT_LT(last_of_window(error), 20.0 * error) << "the window was left too early";
  }
}

TEST(IncrementTest, WorkOfTheLoadIsStoredOrDissipated)
{
  // By the trapezoidal rule from just below first yield, where all is elastic: its error is of second order in the step,
  // as is that of the path integration. Pressed straight on, the flow hardly turns, so that backward Euler does as well.
  const auto balance = [](Integration integration, int steps)
  {
    SpherePress press;
    const double begin = 0.9, end = 6.0;
    EXPECT_TRUE(press.press(begin, integration).converged);
    const double energy = press.stored_and_dissipated();
    double work = 0.0, load = press.load();
    for (int step = 1; step <= steps; ++step)
    {
      EXPECT_TRUE(press.press(begin + (end - begin) * step / steps, integration).converged);
      work += 0.5 * (load + press.load()) * (end - begin) / steps * SpherePress::alpha_c;
      load = press.load();
    }
    return (press.stored_and_dissipated() - energy) / work - 1.0;
  };
  std::vector<double> path, euler;
  for (const int steps : {3, 6, 12})
  {
    path.push_back(balance(Integration::path, steps));
    euler.push_back(balance(Integration::backward_euler, steps));
  }
  EXPECT_GT(test::Orders("energy balance, path", path).overall, 1.6);
  EXPECT_GT(test::Orders("energy balance, backward Euler", euler).overall, 0.8);
  EXPECT_LT(std::abs(path.back()), 2e-3);
}

/// Everything that a caller can see of the state, and what a checkpoint holds.
struct Seen
{
  Archive::Fields stored;
  std::vector<double> pressure, gap, lower_displacement, upper_displacement, lower_depth, upper_depth;
  double approach = 0.0, load = 0.0, elastic_energy = 0.0;
  bool reaches_edge = false;
  bool operator==(const Seen&) const = default;
};

Seen seen(SpherePress& press)
{
  CoupledContact& c = press.contact();
  Seen s{{},
         copy(c.pressure()),
         copy(c.gap()),
         copy(c.lower().residual_displacement()),
         copy(c.upper().residual_displacement()),
         std::vector<double>(c.grid().size()),
         std::vector<double>(c.grid().size()),
         c.approach(),
         c.load(),
         c.elastic_energy(),
         c.reaches_edge()};
  c.add_depth(0, {}, s.lower_depth);
  c.add_depth(1, {}, s.upper_depth);
  Archive archive;
  c.exchange(archive);
  s.stored = std::move(archive).fields();
  return s;
}

/// An increment that is not to succeed, and why.
struct Failure
{
  const char* reason;
  Strategy strategy;
  double interference = 6.0;
  int offset = 0; ///< columns by which the contact moves
};

/// @param questions_left  until `wants_stop` says so.
std::vector<Failure> failures(int& questions_left)
{
  const Strategy few{.max_evaluations = 3};
  const Strategy enough{.max_evaluations = 2000, .anderson_depth = 0, .stiffness_share = 1.0};
  Strategy soft = enough;
  soft.stiffness_share = 0.05; // steps so long that they go uphill
  soft.integration = Integration::backward_euler;
  soft.watch_energy = true;
  Strategy stopped = enough;
  stopped.wants_stop = [&] { return --questions_left < 0; };
  Strategy within = enough;
  within.stay_within_grids = true;
  return {{"too few evaluations", few},
          {"too few evaluations", few, 5.0, 2},
          {"the energy rose", soft},
          {"stopped", stopped},
          {"the contact left the material", enough, 6.0, 9},
          {"a grid is too small", within, 30.0},
          {"no number", enough, std::numeric_limits<double>::quiet_NaN()}};
}

/// How the increment ended.
std::string outcome(SpherePress& press, const Failure& failure)
{
  try
  {
    const IncrementReport report = press.press(failure.interference, failure.strategy, failure.offset);
    if (report.converged)
      return "converged";
    if (report.energy_rose)
      return "the energy rose";
    if (report.outgrown.any())
      return "a grid is too small";
    return std::isfinite(report.gap_error) ? "too few evaluations" : "no number";
  }
  catch (const Interrupted&)
  {
    return "stopped";
  }
  catch (const GridError&)
  {
    return "the contact left the material";
  }
}

TEST(IncrementTest, FailedIncrementLeavesEverythingAsItWas)
{
  // One pair fails in all these ways, the other never tries: to the last digit they are the same, also after the next
  // increments.
  for (const bool both : {true, false}) // bodies plastic, or only the lower one
  {
    PressOptions options;
    options.upper_plastic = both;
    options.spare_columns = 4;
    options.hardening_modulus = 20e9;
    options.settings.max_evaluations = 400;
    SpherePress press(options), other(options);
    ASSERT_TRUE(press.press(3.0).converged && other.press(3.0).converged);
    int questions_left = 0;
    for (const Failure& failure : failures(questions_left))
    {
      SCOPED_TRACE(failure.reason);
      questions_left = 4;
      const Seen before = seen(press);
      EXPECT_EQ(outcome(press, failure), failure.reason);
      EXPECT_TRUE(seen(press) == before);
    }
    for (const double interference : {6.0, 4.0})
    {
      ASSERT_TRUE(press.press(interference).converged && other.press(interference).converged);
      EXPECT_TRUE(seen(press) == seen(other));
    }
    EXPECT_GT(largest(press.contact().lower().state().equivalent), 1e-3);
  }
}

TEST(IncrementTest, ThePlainIterationIsGivenTheEvaluationsItNeeds)
{
  // Its steps are short, so that its error takes many evaluations to halve: that is no reason to end it.
  PressOptions options;
  options.hardening_modulus = 2e9;
  SpherePress press(options);
  ASSERT_TRUE(press.press(2.0).converged);
  Strategy plain;
  plain.integration = Integration::backward_euler;
  plain.anderson_depth = 0;
  plain.stiffness_share = 40.0;
  plain.max_evaluations = 5000;
  const IncrementReport report = press.press(4.0, plain);
  EXPECT_TRUE(report.converged) << report.evaluations << " evaluations, yield error " << report.yield_error;
  EXPECT_GT(report.evaluations, 100);
}

TEST(IncrementTest, SameGapAgainChangesNothing)
{
  PressOptions options;
  options.settings = tight_settings();
  SpherePress press(options);
  ASSERT_TRUE(press.press(5.0).converged);
  const BodyState before = press.contact().lower().state();
  ASSERT_TRUE(press.press(5.0).converged);
  expect_same_state(press.contact().lower().state(), before, 1e-6);
}

TEST(IncrementTest, ElasticBodyStaysElastic)
{
  PressOptions options;
  options.upper_plastic = false;
  options.settings.max_evaluations = 200; // a sharp contrast, in two large steps
  SpherePress press(options);
  ASSERT_TRUE(press.press(3.0).converged && press.press(6.0).converged);
  EXPECT_GT(largest(press.contact().lower().state().equivalent), 1e-3);
  const BodyState& upper = press.contact().upper().state();
  EXPECT_EQ(largest(upper.plastic_strain), 0.0);
  EXPECT_EQ(largest(upper.residual_displacement), 0.0);
  EXPECT_EQ(upper.dissipation, 0.0);
  EXPECT_EQ(upper.locked_in_energy, 0.0);
}

TEST(IncrementTest, TwoElasticBodiesNeedOneEvaluation)
{
  PressOptions options;
  options.lower_plastic = options.upper_plastic = false;
  SpherePress press(options);
  const IncrementReport report = press.press(6.0);
  ASSERT_TRUE(report.converged);
  EXPECT_EQ(report.evaluations, 1);
  // Hertz, 4/3 E' sqrt(R) alpha^1.5 with R = 1/2, E' = E/(2 (1 - nu^2)); the rim on 13 cells errs by (h/a)^1.5 or so.
  const double modulus = 200e9 / (2.0 * (1.0 - 0.32 * 0.32));
  const double hertz = 4.0 / 3.0 * modulus * std::sqrt(0.5) * std::pow(6.0 * SpherePress::alpha_c, 1.5);
  EXPECT_NEAR(press.load(), hertz, 0.01 * hertz);
}

TEST(IncrementTest, TwinsDeformAlikeAndMirrorImagesToo)
{
  PressOptions options;
  options.settings = tight_settings();
  SpherePress press(options);
  ASSERT_TRUE(press.press(3.0).converged && press.press(6.0).converged);
  const BodyState& state = press.contact().lower().state();
  expect_same_state(press.contact().upper().state(), state, 0.0);
  constexpr int n = SpherePress::n;
  const double scale = largest(state.residual_displacement);
  for (int j = 0; j < n; ++j) // four-fold symmetry, to the tolerance
    for (int i = 0; i < n; ++i)
    {
      const auto at = [&](int a, int b) { return state.residual_displacement[static_cast<std::size_t>(a + n * b)]; };
      EXPECT_NEAR(at(i, j), at(n - 1 - i, j), 1e-6 * scale);
      EXPECT_NEAR(at(i, j), at(j, i), 1e-6 * scale);
    }
}

TEST(IncrementDoorTest, RefusesGridsThatDoNotMatchAndAContactBeyondTheBody)
{
  const SurfaceGrid g{5, 5, 1.0, 1.0};
  const VolumeGrid v{g, 2, 1.0};
  VolumeGrid other = v;
  other.surface.dx = 2.0;
  const constitutive::Material m{{1.0, 0.3}, constitutive::PerfectPlasticity{0.01}};
  EXPECT_THROW(CoupledContact(g, v, other, m, m, Scales{1.0, 1.0}, Settings{}), InternalError);
  CoupledContact contact(g, v, v, m, m, Scales{1.0, 1.0}, Settings{});
  const std::vector<double> gap(g.size(), -0.001);
  EXPECT_THROW(static_cast<void>(contact.advance(gap, {}, Placement{{3}, {0}}, Strategy{})), InputError);
  for (const std::size_t size : {24, 26})
    test::expect_refused("CoupledContact::advance: the distance", size, 25,
                         [&]
                         {
                           const std::vector<double> wrong(size, -0.001);
                           static_cast<void>(contact.advance(wrong, {}, Placement{}, Strategy{}));
                         });
  std::vector<double> depth(24);
  test::expect_refused("CoupledContact: the depth", 24, 25, [&] { contact.add_depth(0, {}, depth); });
  test::expect_refused("CoupledContact: the texture", 24, 25,
                       [&] {
                         CoupledContact(g, v, v, m, m, Scales{1.0, 1.0}, Settings{}, Twin::none, {depth, {}});
                       });
}

} // namespace
} // namespace brinell::elastoplastic::increment_test
