// SPDX-License-Identifier: BSD-3-Clause
#include "record.hpp"
#include "scenario_runs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <tuple>
#include <vector>

/// Deep indents of soft metals, whose strains are many times the yield strain: an increment converges in one piece, to the result of
/// far smaller tolerances.
namespace brinell::verification::deep_indents_test
{
namespace
{

using simulation::IndentationCase;

constexpr double modulus = 70e9, radius = 5e-3, depth = 0.04 * radius;
constexpr std::size_t pressing_steps = 5;
constexpr const char* too_slow = "many evaluations: too slow in this build";

constitutive::Material soft_metal(double ratio, double hardening)
{
  constitutive::Material m{{modulus, 0.3}, {}};
  if (hardening > 0.0)
    m.hardening = constitutive::LinearHardening{modulus / ratio, hardening};
  else
    m.hardening = constitutive::PerfectPlasticity{modulus / ratio};
  return m;
}

/// A rigid ball pressed into a flat, a twenty-fifth of its radius deep or with the load for this depth, and lifted off.
IndentationCase indented(double ratio, double hardening, bool is_load)
{
  IndentationCase c;
  c.lower = {simulation::Plane{}, soft_metal(ratio, hardening)};
  c.upper = {ball(radius), {{std::numeric_limits<double>::infinity(), 0.0}, {}}};
  const double yield = modulus / ratio;
  const double force = 3.0 * yield * 2.0 * std::numbers::pi * radius * depth; // 3 S_y over the circle of that depth
  c.sequence = {is_load ? load(force) : approach(depth), is_load ? load(0.0) : approach(0.0)};
  c.steps = static_cast<int>(pressing_steps);
  c.resolution = 4.0;
  return c;
}

TEST(DeepIndents, ConvergeInOnePiece)
{
  if (slow_build)
    GTEST_SKIP() << too_slow;
  for (const double ratio : {50.0, 500.0, 1500.0, 2500.0, 5000.0})
    for (const double hardening : {0.0, modulus / 200.0})
      for (const bool is_load : {false, true})
      {
        if (is_load && ratio > 1000.0)
          continue; // still split: bench/notebook/2026-11-28-deep-indents.md
        const IndentationRun run = computed(indented(ratio, hardening, is_load));
        int most = 0, most_of_lifting = 0;
        for (std::size_t step = 0; step < run.history.size(); ++step)
        {
          int& of_part = step < pressing_steps ? most : most_of_lifting;
          of_part = std::max(of_part, run.history[step].evaluations);
        }
        const std::string label = "E / S_y = " + std::to_string(std::lround(ratio)) +
                                  (hardening > 0.0 ? ", hardening" : ", perfect") + (is_load ? ", load" : ", approach");
        const int of_attempt = elastoplastic::Settings{}.max_evaluations;
        const double bound = ratio > 1000.0 && hardening == 0.0 ? 2.5 * of_attempt : 1.5 * of_attempt;
        test::expect_within(label + ": most evaluations in a step", most, 2.0, bound, "bound: one attempt");
        // Lifting is elastic but for some reversed flow, however deep the indent is.
        test::expect_within(label + ": most evaluations in a lifting step", most_of_lifting, 1.0, 0.5 * of_attempt,
                            "bound: half an attempt");
        EXPECT_EQ(run.summary.split_increments, 0) << label;
      }
}

// The yield error is relative to the yield stress, of which the load is a multiple; the displacement of an increment has a smaller one.
TEST(DeepIndents, HaveTheResultOfFarSmallerTolerances)
{
  if (slow_build)
    GTEST_SKIP() << too_slow;
  IndentationCase c = indented(500.0, 0.0, false);
  const double tolerance = c.solver.yield_tolerance;
  const simulation::Indent found = computed(c).summary.indents.front();
  for (double* one : {&c.solver.yield_tolerance, &c.solver.displacement_tolerance, &c.solver.contact_tolerance})
    *one *= 1e-2;
  c.solver.max_evaluations = 600;
  const simulation::Indent exact = computed(c).summary.indents.front();
  for (const auto& [what, a, b] : {std::tuple{"largest load", found.max_load, exact.max_load},
                                   {"residual depth", found.residual_depth, exact.residual_depth},
                                   {"pile-up", found.pile_up, exact.pile_up}})
    test::expect_within(std::string(what) + " over that of tolerances a hundred times smaller", a / b, 1.0 - tolerance,
                        1.0 + tolerance, "theory: the yield tolerance");
}

} // namespace
} // namespace brinell::verification::deep_indents_test
