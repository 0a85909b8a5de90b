// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/foundation/error.hpp"
#include "brinell/simulation/fretting.hpp"
#include "pressing.hpp"
#include "simulation/plan/domain.hpp"
#include "simulation/plan/effects.hpp"
#include "simulation/plan/footprint.hpp"
#include "simulation/plan/friction.hpp"
#include "simulation/plan/grid_layout.hpp"
#include "simulation/plan/heat.hpp"
#include "simulation/plan/plan_end.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace brinell::simulation
{

namespace
{

using contact::Drive;

void require_press(const Drive& press, int steps)
{
  const bool by_load = press.kind == Drive::Kind::load;
  const char* key = by_load ? "`FrettingCase::load`" : "`FrettingCase::approach`";
  if (press.kind == Drive::Kind::mean_gap)
    throw PlanError::at("`FrettingCase::load`", "fretting needs a load or an approach");
  if (!(press.value > 0.0 && std::isfinite(press.value)))
    throw PlanError("{} = {:g} {}; allowed: > 0", key, press.value, by_load ? "N" : "m");
  if (steps < 1)
    throw PlanError("`FrettingCase::press_steps` = {}; allowed: >= 1", steps);
}

void require_cycles(const FrettingCase& fretting)
{
  if (fretting.cycles < 0)
    throw PlanError("`FrettingCase::cycles` = {}; allowed: >= 0", fretting.cycles);
  if (fretting.steps_per_cycle < 4 || fretting.steps_per_cycle % 4 != 0)
    throw PlanError("`FrettingCase::steps_per_cycle` = {}; allowed: multiples of 4", fretting.steps_per_cycle);
  if (!std::isfinite(fretting.direction))
    throw PlanError("`FrettingCase::direction` = {:g}; allowed: finite", fretting.direction);
}

/// Upper bound of the load [N]. Under an approach it is the load of the elastic bodies, if these are smooth, increased for
/// sticking: surfaces that do not slip are stiffer, most of all against a rigid body (Spence 1968).
double largest_load(const FrettingCase& fretting, const Footprint& footprint)
{
  if (fretting.press.kind == Drive::Kind::load)
    return fretting.press.value;
  if (!are_smooth(fretting.lower, fretting.upper))
    return std::numeric_limits<double>::infinity();
  double stuck = 1.0;
  for (const Elastic& body : {fretting.lower.material.elastic, fretting.upper.material.elastic})
    if (const double nu = body.poisson_ratio; !body.is_rigid() && nu < 0.499) // there the ratio is 1
      stuck = std::max(stuck, (1.0 - nu) * std::log(3.0 - 4.0 * nu) / (1.0 - 2.0 * nu));
  constexpr double error_of_cells = 0.1; // relative error with coarse cells
  return (1.0 + error_of_cells) * stuck * footprint.elastic_load;
}

void require_held(const FrettingCase& fretting, const std::string& given, double load)
{
  const double most = fretting.friction.coefficient * load;
  if (fretting.amplitude < most)
    return;
  const std::string carried =
      fretting.press.kind == Drive::Kind::load
          ? "friction times load"
          : fmt::format("friction times the largest load under `FrettingCase::approach` = {:g} m",
                        fretting.press.value);
  throw PlanError("{}; allowed: below {:g} N ({}), because at that force the whole "
                  "contact slides; for sliding, give `FrettingCase::displacement` instead",
                  given, most, carried);
}

/// Checks that the slip of a step exceeds the errors of the approach: pressing leaves an error of the size of its tolerance,
/// which is smaller with little friction.
void require_above_errors(const FrettingCase& fretting, const std::string& given, const Footprint& footprint)
{
  constexpr double least_friction = 1e-10, little = 1e-3;
  const double mu = fretting.friction.coefficient;
  if (mu > 0.0 && mu < least_friction)
    throw PlanError("`Friction::coefficient` = {:g}; allowed: 0, or at least {:g}, because with less friction "
                    "the slip is lost in the rounding errors of the approach",
                    mu, least_friction);
  const bool by_force = fretting.kind == FrettingCase::Kind::force;
  const double step = fretting.solver.contact_tolerance * std::min(1.0, mu / little) *
                      (by_force ? largest_load(fretting, footprint) : footprint.approach);
  const double least = 0.25 * fretting.steps_per_cycle * step;
  if (fretting.amplitude > 0.0 && std::isfinite(least) && fretting.amplitude < least)
    throw PlanError("{}; allowed: 0, or at least {:.3g} {}, because smaller steps are lost in the "
                    "error of the approach (`Settings::contact_tolerance` = {:g})",
                    given, least, by_force ? "N" : "m", fretting.solver.contact_tolerance);
}

/// Checks that friction can carry the imposed force, and that the amplitude is small enough for the contact to stay in place.
void require_amplitude(const FrettingCase& fretting, const Footprint& footprint)
{
  const bool by_force = fretting.kind == FrettingCase::Kind::force;
  const std::string key = by_force ? "`FrettingCase::force`" : "`FrettingCase::displacement`";
  const std::string given = fmt::format("{} = {:g} {}", key, fretting.amplitude, by_force ? "N" : "m");
  if (!(fretting.amplitude >= 0.0 && std::isfinite(fretting.amplitude)))
    throw PlanError("{}; allowed: >= 0", given);
  if (fretting.amplitude > 0.0 && fretting.friction.coefficient == 0.0)
    throw PlanError("`Friction::coefficient` = 0 with {}: without friction the surfaces cannot stick; allowed: > 0",
                    given);
  if (by_force && fretting.amplitude > 0.0)
    require_held(fretting, given, largest_load(fretting, footprint));
  if (!by_force && !(fretting.amplitude <= footprint.half_x))
    throw PlanError("{}; allowed: up to {:.3g} m, the radius of the contact, because the contact is "
                    "treated as staying in place",
                    given, footprint.half_x);
  require_above_errors(fretting, given, footprint);
}

/// Displacement at which a round contact begins to slide everywhere (Mindlin 1949) [m].
double sliding_displacement(const FrettingCase& fretting, double approach)
{
  double compliance = 0.0;
  for (const Elastic& body : {fretting.lower.material.elastic, fretting.upper.material.elastic})
    compliance += body.is_rigid() ? 0.0 : (2.0 - body.poisson_ratio) / body.shear_modulus();
  const double modulus = contact_modulus(fretting.lower.material.elastic, fretting.upper.material.elastic);
  return 0.25 * fretting.friction.coefficient * approach * modulus * compliance;
}

halfspace::HeatTimes heat_times(const FrettingCase& fretting, const FrettingPlan& plan)
{
  const double steps_per_second = fretting.steps_per_cycle * fretting.frequency.value();
  return {0.5 * finest_press / steps_per_second, (plan.steps + 1.0) / steps_per_second};
}

/// Whether the upper body is always the mirror image in x of the lower one: both move in opposite directions along x under a
/// pressure that is even in x.
bool are_twins(const FrettingCase& fretting, const FrettingPlan& plan)
{
  const bool is_along_x = std::abs(std::sin(fretting.direction)) < 1e-15;
  return fretting.solver.mirror && fretting.are_alike() && shares_alike(fretting) && is_along_x &&
         !fretting.domain.x.is_periodic() && plan.lower == plan.upper && alike(fretting.lower, fretting.upper);
}

} // namespace

FrettingPlan plan(const FrettingCase& fretting)
{
  require_friction(fretting, "");
  require_press(fretting.press, fretting.press_steps);
  require_cycles(fretting);
  require_heat(fretting, {.speed = fretting.frequency,
                          .speed_name = "`FrettingCase::frequency`",
                          .upper_rests = true,
                          .sticks = true,
                          .name = "frequency",
                          .unit = "Hz"});
  // Without motion there is no shear that makes the bodies yield earlier.
  const double friction = fretting.amplitude > 0.0 ? fretting.friction.coefficient : 0.0;
  const Footprint f = footprint(fretting.lower, fretting.upper, fretting.press, fretting.domain, friction);
  require_amplitude(fretting, f);
  require_effects(
      fretting, fretting.amplitude > 0.0 && fretting.cycles > 0
                    ? ""
                    : "the surfaces do not slide without a cycle, or with an amplitude of 0; allowed: 0, or a motion");
  FrettingPlan plan;
  plan.surfaces_only = needs_surfaces_only(fretting);
  lay_out(fretting, f, 0.0, 0.0, plan);
  check_grids(fretting, plan);
  plan.contact_radius = f.half_x;
  plan.contact_radius_y = f.half_y;
  plan.sliding_displacement = sliding_displacement(fretting, f.approach);
  plan.steps = step_count(fretting.press_steps + static_cast<double>(fretting.cycles) * fretting.steps_per_cycle,
                          "`FrettingCase::cycles`");
  plan.twin = are_twins(fretting, plan) ? elastoplastic::Twin::mirror_image : elastoplastic::Twin::none;
  end_plan(fretting, true, plan, [&] { return heat_times(fretting, plan); });
  return plan;
}

} // namespace brinell::simulation
