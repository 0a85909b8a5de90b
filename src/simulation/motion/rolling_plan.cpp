// SPDX-License-Identifier: BSD-3-Clause
#include "rolling_plan.hpp"

#include "brinell/foundation/error.hpp"
#include "pressing.hpp"
#include "simulation/plan/domain.hpp"
#include "simulation/plan/effects.hpp"
#include "simulation/plan/footprint.hpp"
#include "simulation/plan/friction.hpp"
#include "simulation/plan/grid_layout.hpp"
#include "simulation/plan/heat.hpp"
#include "simulation/plan/plan_end.hpp"
#include "simulation/plan/symmetry.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

/// Grids and steps of rolling, and checks of what cannot be computed.
namespace brinell::simulation
{

namespace
{

/// Whether both bodies always have the same history, so that only one is solved and its residual displacement counts twice.
bool are_twins(const RollingCase& rolling, const RollingPlan& plan)
{
  return rolling.solver.mirror && rolling.slide_to_roll == 0.0 && !rolling.creepage && !rolling.heat.source.exists() &&
         plan.lower == plan.upper && alike(rolling.lower, rolling.upper);
}

/// Checks that the creepage is allowed with the rest of the case.
/// @param half  larger half-length of the contact [m]
void require_creepage(const RollingCase& rolling, double half)
{
  if (!rolling.creepage)
    return;
  const auto& [longitudinal, lateral, spin] = *rolling.creepage;
  const bool only_spins = longitudinal == 0.0 && lateral == 0.0 && spin != 0.0;
  const std::string creepage = fmt::format("`RollingCase::creepage` = [{:g}, {:g}]", longitudinal, lateral);
  const std::string given = only_spins ? fmt::format("`RollingCase::spin` = {:g} rad/m", spin) : creepage;
  for (const double part : {longitudinal, lateral})
    if (!(std::abs(part) <= largest_creepage))
      throw PlanError("{}; allowed: each from -{} to {}. For surfaces that slide everywhere there is "
                      "`RollingCase::slide_to_roll`",
                      creepage, largest_creepage, largest_creepage);
  if (!(std::abs(spin) * half <= largest_creepage))
    throw PlanError("`RollingCase::spin` = {:g} rad/m; allowed: up to {:.3g} rad/m, {} over the half-length of the "
                    "contact",
                    spin, largest_creepage / half, largest_creepage);
  if (rolling.slide_to_roll != 0.0)
    throw PlanError("{} with `RollingCase::slide_to_roll` = {:g}, which makes the surfaces slide everywhere; allowed: "
                    "slide_to_roll = 0. With stick and slip, the longitudinal creepage takes its place",
                    given, rolling.slide_to_roll);
  if (rolling.friction.coefficient == 0.0)
    throw PlanError("{} with `Friction::coefficient` = 0: without friction the surfaces cannot stick; allowed: > 0",
                    given);
  if (spin != 0.0 && (rolling.domain.x.is_periodic() || rolling.domain.y.is_periodic()))
    throw PlanError("`RollingCase::spin` = {:g} rad/m between surfaces without ends, which cannot turn; allowed: 0, "
                    "or `Domain::boundary` = \"open\"",
                    spin);
}

/// Checks that the shift of a run with creepage is whole cells, by which the history of stick and slip is moved.
void require_whole_shift(const RollingCase& rolling, double cell)
{
  if (rolling.creepage && rolling.shift && !whole_cells(*rolling.shift, cell))
    throw PlanError("`RollingCase::shift` = {:g} m with creepage; allowed: whole multiples of the cell, {:g} m",
                    *rolling.shift, cell);
}

halfspace::HeatTimes heat_times(const RollingCase& rolling, const RollingPlan& plan)
{
  const double shortest = plan.shift * std::min(0.5 * finest_press, 0.25 * plan.contact.dx / plan.shift);
  return {shortest / rolling.speed.value(),
          (rolling.passes * way_of_pass(rolling, plan) + plan.shift) / rolling.speed.value()};
}

} // namespace

double way_of_load_step(const RollingCase& rolling, const RollingPlan& plan)
{
  return rolling.creepage ? std::max(plan.shift, 2.0 * plan.half_width_x / rolling.load_steps) : plan.shift;
}

double way_of_pass(const RollingCase& rolling, const RollingPlan& plan)
{
  return 2.0 * (rolling.load_steps * way_of_load_step(rolling, plan) + plan.way());
}

double upper_share(const RollingCase& rolling)
{
  return (2.0 - rolling.slide_to_roll) / (2.0 + rolling.slide_to_roll);
}

RollingPlan plan(const RollingCase& rolling)
{
  const std::string why_not =
      rolling.slide_to_roll == 0.0 && !rolling.creepage
          ? "the surfaces do not slide with `RollingCase::slide_to_roll` = 0; allowed: 0, or another slide_to_roll, or "
            "`RollingCase::creepage`"
          : "";
  require_friction(rolling, why_not);
  require_effects(rolling, why_not);
  require_heat(rolling, {.speed = rolling.speed,
                         .speed_name = "`RollingCase::speed`",
                         .upper_rests = rolling.slide_to_roll == 2.0,
                         .sticks = rolling.creepage.has_value()});
  if (!(rolling.drive.value > 0.0))
    throw InputError("rolling needs a load or an approach > 0");
  const Footprint f =
      footprint(rolling.lower, rolling.upper, rolling.drive, rolling.domain, rolling.friction.coefficient);
  require_creepage(rolling, f.endless_y ? f.half_x : std::max(f.half_x, f.half_y));
  RollingPlan plan;
  plan.half_width_x = f.half_x;
  plan.half_width_y = f.half_y;
  const std::array<double, 3> cells = cell_sizes(rolling, {f.half_x, f.half_y, f.straight_y}, 1.0);
  if (const double shift = rolling.shift.value_or(cells[0]); !(shift <= 0.5 * rolling.distance))
    throw InputError(
        fmt::format("a shift of {:g} m in {:g} m; allowed: up to half of the distance", shift, rolling.distance));
  constexpr int even = 2; // so that a step ends at the middle of the track
  const StepsOnWay steps =
      steps_on_way(rolling, cells, {.shift = rolling.shift, .is_whole = rolling.creepage.has_value()}, rolling.distance,
                   even, "`RollingCase::distance`");
  plan.shift = steps.shift;
  plan.rolling_steps = steps.count;
  const double track = 0.5 * plan.way();
  plan.surfaces_only = needs_surfaces_only(rolling);
  lay_out(rolling, steps.cells, f, track, upper_share(rolling) * track, plan);
  check_grids(rolling, plan);
  require_whole_shift(rolling, plan.contact.dx);
  plan.steps = step_count(static_cast<double>(rolling.passes) * (plan.rolling_steps + 2.0 * rolling.load_steps),
                          "`RollingCase::passes`");
  plan.twin = are_twins(rolling, plan) ? elastoplastic::Twin::alike : elastoplastic::Twin::none;
  mirror_grids(is_solved_by_halves(rolling, plan.contact, rolling.creepage.has_value()), plan);
  end_plan(rolling, rolling.creepage.has_value(), plan, [&] { return heat_times(rolling, plan); });
  return plan;
}

} // namespace brinell::simulation
