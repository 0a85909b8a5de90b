// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/simulation/rolling.hpp"

#include "judgement.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

/// Quality of results of rolling, before and after a run.
namespace brinell::simulation
{

namespace
{

// docs/verification.md (expected error)
constexpr Documented documented[] = {{"rut", "passes[*].rut_depth_m", 0.05, 4.0, 1.5},
                                     {"resistance", "passes[*].resistance_N", 0.08, 4.0, 1.5},
                                     {"dissipation", "passes[*].dissipation_J", 0.07, 4.0, 1.5}};
constexpr Documented creep_force = {"creep force", "passes[*].F_x_N", 0.08, 8.0, 1.0, true};
constexpr Documented documented_with_creepage[] = {creep_force, documented[0], documented[1], documented[2]};
constexpr Documented documented_with_spin[] = {
    creep_force, {"spin moment", "passes[*].M_z_Nm", 0.4, 8.0, 1.5, true}, documented[0], documented[1], documented[2]};

Facts facts(const RollingCase& c, const RollingPlan& plan)
{
  Facts f = facts_of(c, c.lower, c.upper, plan, plan.half_width_x, plan.half_width_y);
  f.documented = documented;
  if (c.creepage)
    f.documented =
        c.creepage->spin == 0.0 ? std::span<const Documented>(documented_with_creepage) : documented_with_spin;
  f.moves = true;
  f.slides = !c.creepage && c.slide_to_roll != 0.0;
  // The motion of the faster surface counts: with much sliding it moves many cells while the other one moves one cell.
  if (const double faster = plan.shift * std::max(1.0, upper_share(c)); c.shift || faster > plan.shift)
    f.shift = faster;
  if (c.speed)
    f.passing_time = 2.0 * f.half_x / (*c.speed * std::max(1.0, upper_share(c)));
  return f;
}

/// Warning about the pass with the largest unsteadiness.
std::optional<Warning> unsteadiness(const RollingCase& rolling, const std::vector<RollingPass>& passes)
{
  // Limit for the relative difference of both quarters. Each then differs from their mean by about 16 %, which is twice the usual
  // discretization error of resistance and dissipation, 8 %.
  constexpr double largest_unsteadiness = 0.3;
  const auto worst = std::max_element(passes.begin(), passes.end(),
                                      [](const RollingPass& a, const RollingPass& b)
                                      { return std::abs(a.unsteadiness) < std::abs(b.unsteadiness); });
  if (worst == passes.end() || !(std::abs(worst->unsteadiness) > largest_unsteadiness))
    return std::nullopt;
  const bool is_rough = !rolling.lower.texture.is_smooth() || !rolling.upper.texture.is_smooth();
  return Warning{
      "unsteady_track",
      fmt::format("pass {}: the energy absorbed per length differs by {} between the two quarters in the middle of the "
                  "track: resistance, friction and mean F_X hold for this part of the track only; use a longer track{}",
                  worst - passes.begin() + 1, percent_text(std::abs(worst->unsteadiness)),
                  is_rough ? ", many times longer than the texture" : "")};
}

/// Warning about the last pass, if stick and slip have not become steady.
std::optional<Warning> creep_unsteadiness(const RollingCase& rolling, const std::vector<RollingPass>& passes)
{
  if (!rolling.creepage || passes.empty() || passes.back().creeps_steadily())
    return std::nullopt;
  return Warning{"unsteady_creep",
                 fmt::format("pass {}: the tangential force differs by {} between both halves of the last quarter of "
                             "the track: stick and slip have not yet reached steady rolling; use a longer track",
                             passes.size(), percent_text(passes.back().creep_unsteadiness))};
}

} // namespace

Quality expected_quality(const RollingCase& rolling, const RollingPlan& plan)
{
  return quality_before(facts(rolling, plan));
}

Quality quality(const RollingCase& rolling, const RollingPlan& plan, const RunTotals& totals)
{
  return quality_after(facts(rolling, plan), totals);
}

Quality quality(const RollingCase& rolling, const RollingPlan& plan, const RollingSummary& summary)
{
  Quality quality = quality_after(facts(rolling, plan), summary, unsteadiness(rolling, summary.passes));
  if (const std::optional<Warning> warning = creep_unsteadiness(rolling, summary.passes))
    quality.warnings.push_back(*warning);
  return quality;
}

} // namespace brinell::simulation
