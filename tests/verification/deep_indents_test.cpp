// SPDX-License-Identifier: BSD-3-Clause
#include "record.hpp"
#include "scenario_runs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

/// Deep indents of soft metals, whose strains are many times the yield strain: an increment converges in one piece.
namespace brinell::verification::deep_indents_test
{
namespace
{

using simulation::IndentationCase;

constexpr double modulus = 70e9, radius = 5e-3, depth = 0.04 * radius;
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
  c.steps = 5;
  c.resolution = 4.0;
  return c;
}

TEST(DeepIndents, ConvergeInOnePiece)
{
  if (slow_build)
    GTEST_SKIP() << too_slow;
  for (const double ratio : {50.0, 500.0, 5000.0})
    for (const double hardening : {0.0, modulus / 200.0})
      for (const bool is_load : {false, true})
      {
        if (is_load && ratio > 1000.0)
          continue; // still split: bench/notebook/2026-11-28-deep-indents.md
        const IndentationRun run = computed(indented(ratio, hardening, is_load));
        int most = 0;
        for (const simulation::IndentationRecord& r : run.history)
          most = std::max(most, r.evaluations);
        const std::string label = "E / S_y = " + std::to_string(std::lround(ratio)) +
                                  (hardening > 0.0 ? ", hardening" : ", perfect") + (is_load ? ", load" : ", approach");
        const double bound = 4.0 * elastoplastic::Settings{}.max_evaluations;
        test::expect_within(label + ": most evaluations in a step", most, 2.0, bound, "bound: one attempt");
        EXPECT_EQ(run.summary.split_increments, 0) << label;
      }
}

} // namespace
} // namespace brinell::verification::deep_indents_test
