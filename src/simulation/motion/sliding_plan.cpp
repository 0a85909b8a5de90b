// SPDX-License-Identifier: BSD-3-Clause
#include "sliding_plan.hpp"
#include "simulation/plan/plan_end.hpp"

#include "brinell/foundation/error.hpp"
#include "foundation/nan.hpp"
#include "period.hpp"
#include "pressing.hpp"
#include "simulation/plan/domain.hpp"
#include "simulation/plan/effects.hpp"
#include "simulation/plan/footprint.hpp"
#include "simulation/plan/friction.hpp"
#include "simulation/plan/grid_layout.hpp"
#include "simulation/plan/heat.hpp"
#include "simulation/plan/meeting.hpp"
#include "simulation/plan/symmetry.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace brinell::simulation
{

using contact::Drive;

IndentationCase pressing(const SlidingCase& sliding)
{
  IndentationCase pressed;
  static_cast<PairCase&>(pressed) = sliding;
  pressed.sequence = {sliding.press};
  return pressed;
}

namespace
{

void require_press(const SlidingCase& sliding)
{
  const auto& [kind, value] = sliding.press;
  if (sliding.press_steps < 1)
    throw PlanError("`SlidingCase::press_steps` = {}; allowed: >= 1", sliding.press_steps);
  const bool is_allowed = kind == Drive::Kind::approach || value > 0.0; // peaks may meet even at a negative approach
  if (!(is_allowed && std::isfinite(value)))
    throw InputError(fmt::format("sliding needs a load or a mean gap > 0, or a finite approach, not {:g}", value));
  if (kind == Drive::Kind::approach)
    if (const auto reason = reason_against_approach(sliding.lower, sliding.upper, value, sliding.domain, "SlidingCase"))
      throw PlanError("`SlidingCase::approach` = {:.4g} m {}", value, *reason);
}

void require_motion(const SlidingCase& sliding)
{
  if (!std::holds_alternative<Plane>(sliding.lower.shape))
    throw PlanError::at(
        member_of("lower", "shape"),
        "sliding needs a flat lower body, because the contact stays in place on the upper one; allowed: \"flat\", with "
        "the other shape for the upper body (two balls that pass each other: scenario = \"tugging\")");
  if (!(sliding.distance > 0.0 && std::isfinite(sliding.distance)))
    throw PlanError("`SlidingCase::distance` = {:g} m; allowed: > 0", sliding.distance);
  if (sliding.strokes < 1)
    throw PlanError("`SlidingCase::strokes` = {}; allowed: >= 1", sliding.strokes);
  if (sliding.strokes > 1 && !sliding.to_and_fro && !sliding.domain.x.is_periodic())
    throw PlanError("`SlidingCase::strokes` = {} would leave the track for good: without a period along x the upper "
                    "body has to come back; allowed: `SlidingCase::to_and_fro` = true, or one stroke over a longer "
                    "`SlidingCase::distance`",
                    sliding.strokes);
}

/// Length of the track on the lower body [m].
double track_length(const SlidingCase& sliding)
{
  return (sliding.to_and_fro ? 1.0 : sliding.strokes) * sliding.distance;
}

void require_touch(const Meeting& met, double approach)
{
  if (!(met.touch < approach))
    throw PlanError("`SlidingCase::approach` = {:.4g} m: on their way the undeformed surfaces first touch at {:.4g} "
                    "m; allowed: more",
                    approach, met.touch);
}

Footprint footprint_of(const SlidingCase& sliding)
{
  const ShapedBody &lower = sliding.lower, &upper = sliding.upper;
  const double friction = sliding.friction.coefficient;
  if (sliding.press.kind != Drive::Kind::approach)
    return footprint(lower, upper, largest_drive(pressing(sliding)), sliding.domain, friction);
  const double approach = sliding.press.value;
  if (are_smooth(lower, upper) && !(approach > 0.0))
    throw PlanError("`SlidingCase::approach` = {:.4g} m: smooth bodies touch above 0; allowed: "
                    "> 0, or textures whose peaks meet",
                    approach);
  const bool is_of_flats = sliding.domain.is_periodic() && are_flat(lower, upper); // see require_meeting
  if (are_smooth(lower, upper) || is_of_flats)
    return footprint(lower, upper, sliding.press, sliding.domain, friction);
  if (const auto reason = reason_against_contact(lower, upper, sliding.domain))
    throw InputError("the bodies " + *reason);
  const double half = 0.5 * sliding.distance;
  const Way way = sliding.domain.x.is_periodic() ? Way{0.0, track_length(sliding)} : Way{-half, half};
  const Meeting met = estimated_meeting(lower, upper, sliding, way, approach);
  require_touch(met, approach);
  return footprint_on_the_way(lower, upper, sliding, met, approach);
}

/// Checks that periodic bodies touch when they are pressed, or further on the way.
void require_meeting(const SlidingCase& sliding, const SlidingPlan& plan)
{
  const auto& [kind, value] = sliding.press;
  if (kind == Drive::Kind::load || (kind == Drive::Kind::mean_gap && value < plan.touching_gap))
    return;
  const double approach = kind == Drive::Kind::approach ? value : 0.0;
  const Meeting met = meeting(sliding.lower, sliding.upper, plan.contact, {0.0, track_length(sliding)}, approach);
  if (kind == Drive::Kind::approach)
    return require_touch(met, value);
  if (const double gap = met.mean - met.touch; !(value < gap))
    throw PlanError("`SlidingCase::mean_gap` = {:.4g} m: the surfaces first touch at {:.4g} m; "
                    "allowed: less",
                    value, gap);
}

halfspace::HeatTimes heat_times(const SlidingCase& sliding, const SlidingPlan& plan)
{
  const double step = plan.shift / sliding.speed.value();
  const double finest = std::min(finest_press, 0.5 * plan.contact.dx / plan.shift);
  constexpr double half = 0.5; // steps are halved until they are below 1.5 times the finest piece
  return {half * finest * step, plan.steps * plan.shift / sliding.speed.value()};
}

} // namespace

SlidingPlan plan(const SlidingCase& sliding)
{
  require_friction(sliding, "");
  require_effects(sliding, "");
  require_motion(sliding);
  require_press(sliding);
  require_heat(sliding, {.speed = sliding.speed, .speed_name = "`SlidingCase::speed`", .upper_rests = true});
  const Footprint f = footprint_of(sliding);
  SlidingPlan plan;
  plan.half_width_x = f.half_x;
  plan.half_width_y = f.half_y;
  const std::array<double, 3> cells = cell_sizes(sliding, {f.half_x, f.half_y, f.straight_y}, 1.0);
  if (const double shift = sliding.shift.value_or(cells[0]); !(shift > 0.0 && shift <= sliding.distance))
    throw PlanError("`SlidingCase::shift` = {:g} m; allowed: > 0, up to `SlidingCase::distance` = {:g} m", shift,
                    sliding.distance);
  const StepsOnWay steps =
      steps_on_way(sliding, cells, {sliding.shift}, sliding.distance, 1, "`SlidingCase::distance`");
  plan.shift = steps.shift;
  plan.sliding_steps = steps.count;
  plan.surfaces_only = needs_surfaces_only(sliding);
  lay_out(sliding, steps.cells, f, 0.5 * (plan.sliding_steps + 1) * plan.shift, 0.0, plan);
  check_grids(sliding, plan);
  plan.touching_gap = sliding.domain.is_periodic() ? touching_gap(pressing(sliding), plan.contact) : nan;
  if (sliding.domain.is_periodic())
    require_meeting(sliding, plan);
  plan.steps = step_count(2.0 * sliding.press_steps + static_cast<double>(sliding.strokes) * plan.sliding_steps,
                          "`SlidingCase::strokes`");
  mirror_grids(is_solved_by_halves(sliding, plan.contact), plan);
  end_plan(sliding, false, plan, [&] { return heat_times(sliding, plan); });
  return plan;
}

} // namespace brinell::simulation
