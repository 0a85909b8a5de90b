// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/simulation/rolling.hpp"

#include "judgement.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <iterator>
#include <string_view>

/// Quality of results of rolling, before and after a run.
namespace brinell::simulation
{

namespace
{

// docs/verification/accuracy.md (expected error)
constexpr Documented rut{"rut", "passes[*].rut_depth_m", 0.05, 4.0, 1.5, Documented::Of::contact, 0.3, true, 0.0, 3.0};
/// The rut of a line contact is the small difference of large strains, of first order: the more so the larger the shear.
constexpr Documented rut_of_line{
    "rut", "passes[*].rut_depth_m", 0.07, 8.0, 1.0, Documented::Of::contact, 0.3, true, 0.0, 3.0};
constexpr Documented rut_of_sliding_line{
    "rut", "passes[*].rut_depth_m", 0.16, 8.0, 1.0, Documented::Of::contact, 0.3, true, 0.0, 3.0};
constexpr Documented resistance_to_rolling{
    "resistance", "passes[*].resistance_N", 0.08, 4.0, 1.5, Documented::Of::contact, 1.0, false, 0.0, 1.3};
constexpr Documented dissipation{
    "dissipation", "passes[*].dissipation_J", 0.09, 4.0, 1.5, Documented::Of::contact, 1.0, false, 0.0, 1.2};
/// Of point contacts.
constexpr Documented of_rolled_points[] = {
    {"shoulder", "passes[*].shoulder_height_m", 0.08, 8.0, 1.0, Documented::Of::contact, 0.3, true},
    {"strain under the track", "passes[*].track_plastic_strain", 0.035, 8.0, 1.0, Documented::Of::contact, 0.3, false,
     0.0, 2.0},
    {"contact area", "passes[*].contact_area_m2", 0.018, 8.0, 1.0, Documented::Of::elastic_contact, 0.02, false, 0.0,
     2.0},
    {"largest pressure", "passes[*].max_pressure_Pa", 0.012, 8.0, 1.0, Documented::Of::elastic_contact, 0.02, false,
     0.0, 2.0}};
constexpr Documented creep_force{
    "creep force", "passes[*].F_x_N", 0.08, 8.0, 1.0, Documented::Of::elastic_contact, 1.0};
/// The moment of a spin on a circle; on an ellipse longer along the motion the lateral force, which lags by half a cell, has a
/// larger share of it.
Documented error_of_spin_moment(const RollingPlan& plan)
{
  const double length = plan.half_width_x / plan.half_width_y;
  const double error = 0.4 * std::max(1.0, 0.5 * std::pow(length, 1.5));
  return {"spin moment", "passes[*].M_z_Nm", error, 8.0, 1.0, Documented::Of::elastic_contact};
}

/// Error of the creep force of the last pass. It is relative to the resultant, unless this is small: then it is that of a force of
/// 0.3 of the largest possible one, as the shears of bodies that differ are large even if their sum is not.
Documented error_of_creep_force(const RollingCase& c, const std::vector<RollingPass>& passes)
{
  Documented error = creep_force;
  if (passes.empty())
    return error;
  const RollingPass& last = passes.back();
  if (std::abs(last.F_y) > std::abs(last.F_x))
    error.name = "passes[*].F_y_N";
  const double force = std::hypot(last.F_x, last.F_y);
  if (c.drive.kind == contact::Drive::Kind::load)
    error.error *= std::max(1.0, 0.3 * c.friction.coefficient * c.drive.value / force);
  return error;
}

/// Whether the bodies absorb nothing worth an error of its own.
bool hardly_resists(const RollingCase& c, const std::vector<RollingPass>& passes)
{
  constexpr double least = 1e-5; // over the load
  return c.drive.kind == contact::Drive::Kind::load && !passes.empty() &&
         std::all_of(passes.begin(), passes.end(),
                     [&](const RollingPass& p) { return std::abs(p.resistance) < least * c.drive.value; });
}

/// @param passes  finished passes; none before the run
std::vector<Documented> documented_of_passes(const RollingCase& c, const RollingPlan& plan, bool is_plane,
                                             const std::vector<RollingPass>& passes)
{
  std::vector<Documented> errors;
  if (c.creepage)
    errors.push_back(error_of_creep_force(c, passes));
  if (c.creepage && c.creepage->spin != 0.0)
    errors.push_back(error_of_spin_moment(plan));
  errors.push_back(!is_plane ? rut : c.friction.coefficient > 0.0 ? rut_of_sliding_line : rut_of_line);
  if (!hardly_resists(c, passes))
    errors.push_back(resistance_to_rolling);
  errors.push_back(dissipation);
  errors.back().further = std::abs(plan.rolling_steps * plan.shift / c.distance - 1.0); // length of the track
  if (!is_plane)
    errors.insert(errors.end(), std::begin(of_rolled_points), std::end(of_rolled_points));
  return errors;
}

Facts facts(const RollingCase& c, const RollingPlan& plan, const std::vector<RollingPass>& passes = {})
{
  Facts f = facts_of(c, c.lower, c.upper, plan, plan.half_width_x, plan.half_width_y);
  f.documented = documented_of_passes(c, plan, f.is_plane, passes);
  f.moves = true;
  f.slides = !c.creepage && c.slide_to_roll != 0.0;
  if (c.creepage)
  {
    f.temperature_rise.error = temperature_error_of_sticking;
    f.worn_depth.error = creep_force.error; // it goes with the work of the creep force
  }
  // The motion of the faster surface counts: with much sliding it moves many cells while the other one moves one cell.
  if (const double faster = plan.shift * std::max(1.0, upper_share(c)); c.shift || faster > plan.shift)
    f.shift = faster;
  if (c.speed)
    f.heating_time = 2.0 * f.half_x / (*c.speed * std::max(1.0, upper_share(c)));
  return f;
}

/// Whether the rut, the residual displacement in the middle of the track, is so small beside what is left elsewhere, as in the
/// middle of a dent, that its relative error says nothing.
bool hardly_sinks(const RollingSummary& summary)
{
  constexpr double least = 0.05;
  return !summary.passes.empty() &&
         std::all_of(summary.passes.begin(), summary.passes.end(),
                     [&](const RollingPass& p) { return std::abs(p.rut_depth) < least * summary.max_residual_lower; });
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
  Facts f = facts(rolling, plan, summary.passes);
  if (hardly_sinks(summary))
    std::erase_if(f.documented, [](const Documented& d) { return std::string_view(d.quantity) == rut.quantity; });
  Quality quality = quality_after(f, summary, unsteadiness(rolling, summary.passes));
  if (const std::optional<Warning> warning = creep_unsteadiness(rolling, summary.passes))
    quality.warnings.push_back(*warning);
  return quality;
}

} // namespace brinell::simulation
