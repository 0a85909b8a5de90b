// SPDX-License-Identifier: BSD-3-Clause
#include "of_scenario.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <iterator>
#include <string_view>

/// Quality of results of rolling, before and after a run.
namespace brinell::quality
{

namespace
{

// docs/verification/accuracy.md (expected error)
constexpr Documented rut{.quantity = "rut",
                         .name = "passes[*].rut_depth_m",
                         .error = 0.085,
                         .cells = 4.0,
                         .order = 1.5,
                         .of = Documented::Of::contact,
                         .of_steps = 0.3,
                         .is_of_lower = true,
                         .on_textures = 1.8};
/// The rut of a line contact is the small difference of large strains, of first order: the more so the larger the shear.
constexpr Documented rut_of_line{.quantity = "rut",
                                 .name = "passes[*].rut_depth_m",
                                 .error = 0.07,
                                 .cells = 8.0,
                                 .order = 1.0,
                                 .of = Documented::Of::contact,
                                 .of_steps = 0.3,
                                 .is_of_lower = true,
                                 .on_textures = 3.0};
constexpr Documented rut_of_sliding_line{.quantity = "rut",
                                         .name = "passes[*].rut_depth_m",
                                         .error = 0.16,
                                         .cells = 8.0,
                                         .order = 1.0,
                                         .of = Documented::Of::contact,
                                         .of_steps = 0.3,
                                         .is_of_lower = true,
                                         .on_textures = 3.0};
constexpr Documented resistance_to_rolling{.quantity = "resistance",
                                           .name = "passes[*].resistance_N",
                                           .error = 0.165,
                                           .cells = 4.0,
                                           .order = 1.5,
                                           .of = Documented::Of::contact,
                                           .of_steps = 1.0};
constexpr Documented dissipation{.quantity = "dissipation",
                                 .name = "passes[*].dissipation_J",
                                 .error = 0.09,
                                 .cells = 4.0,
                                 .order = 1.5,
                                 .of = Documented::Of::contact,
                                 .of_steps = 1.0,
                                 .on_textures = 1.2};
/// Of point contacts.
constexpr double error_of_rubbed_shoulder = 0.17; ///< of the first of these, under sliding friction
constexpr Documented of_rolled_points[] = {{.quantity = "shoulder",
                                            .name = "passes[*].shoulder_height_m",
                                            .error = 0.08,
                                            .cells = 8.0,
                                            .order = 1.0,
                                            .of = Documented::Of::contact,
                                            .of_steps = 0.3,
                                            .is_of_lower = true,
                                            .on_textures = 1.4},
                                           {.quantity = "strain under the track",
                                            .name = "passes[*].track_plastic_strain",
                                            .error = 0.035,
                                            .cells = 8.0,
                                            .order = 1.0,
                                            .of = Documented::Of::contact,
                                            .of_steps = 0.3,
                                            .on_textures = 2.0},
                                           {.quantity = "contact area",
                                            .name = "passes[*].contact_area_m2",
                                            .error = 0.018,
                                            .cells = 8.0,
                                            .order = 1.0,
                                            .of = Documented::Of::elastic_contact,
                                            .of_steps = 0.02,
                                            .on_textures = 2.0},
                                           {.quantity = "largest pressure",
                                            .name = "passes[*].max_pressure_Pa",
                                            .error = 0.012,
                                            .cells = 8.0,
                                            .order = 1.0,
                                            .of = Documented::Of::elastic_contact,
                                            .of_steps = 0.02,
                                            .on_textures = 2.0}};
/// Of elastic bodies, except where nearly all of the contact sticks: there the shear grows without limit at the trailing edge.
constexpr Documented creep_force{.quantity = "creep force",
                                 .name = "passes[*].F_x_N",
                                 .error = 0.012,
                                 .cells = 8.0,
                                 .order = 1.5,
                                 .of = Documented::Of::elastic_contact,
                                 .of_steps = 0.15};
constexpr double error_of_sticking = 0.04, nearly_all = 0.97;
/// The edge of a plastic contact is not that of an elastic one, on which the entry of points relies.
constexpr double error_of_plastic_creep = 0.06;
constexpr Documented spin_moment{.quantity = "spin moment",
                                 .name = "passes[*].M_z_Nm",
                                 .error = 0.06,
                                 .cells = 8.0,
                                 .order = 1.5,
                                 .of = Documented::Of::elastic_contact,
                                 .of_steps = 1.0};
/// Relative to the area of the contact: a row of cells at the edge of the part that sticks.
constexpr Documented stick_share{.quantity = "stick share",
                                 .name = "passes[*].stick_share",
                                 .error = 0.03,
                                 .cells = 8.0,
                                 .order = 1.0,
                                 .of = Documented::Of::elastic_contact,
                                 .of_steps = 1.0};

/// Force and moment that lateral creepage and spin alone would cause by the linear theory. Both may nearly cancel, but their
/// errors do not.
struct LateralParts
{
  double force_of_creepage = 0.0, force_of_spin = 0.0; ///< [N]
  double moment_of_creepage = 0.0;                     ///< [N m]
};

/// With coefficients of Kalker (1967) for nu = 1/4, to a sixth.
LateralParts lateral_parts(const RollingCase& c, const RollingPlan& plan)
{
  const double area = plan.half_width_x * plan.half_width_y, length = plan.half_width_x / plan.half_width_y;
  const auto compliance = [](const ShapedBody& body)
  { return body.material.elastic.is_rigid() ? 0.0 : 1.0 / body.material.elastic.shear_modulus(); };
  const double unit = 2.0 / (compliance(c.lower) + compliance(c.upper)) * area, size = std::sqrt(area);
  const double C22 = 2.5 + 1.1 * length, C23 = 0.35 + 1.25 * length;
  const double lateral = std::abs(c.creepage->lateral), spin = std::abs(c.creepage->spin);
  return {unit * C22 * lateral, unit * C23 * size * spin, unit * C23 * size * lateral};
}

/// Error of the creep force of the last pass. It is relative to the resultant, unless this is small beside its parts: forces of
/// lateral creepage and spin that nearly cancel, or the shears of bodies that differ, which are large even if their sum is not.
Documented error_of_creep_force(const RollingCase& c, const RollingPlan& plan, const std::vector<RollingPass>& passes)
{
  Documented error = creep_force;
  const bool is_plastic = c.lower.material.is_plastic() || c.upper.material.is_plastic();
  if (passes.empty() || passes.back().stick_share > nearly_all)
    error.error = error_of_sticking;
  if (is_plastic)
    error.error = error_of_plastic_creep;
  if (passes.empty())
    return error;
  const RollingPass& last = passes.back();
  if (std::abs(last.F_y) > std::abs(last.F_x))
    error.name = "passes[*].F_y_N";
  const double force = std::hypot(last.F_x, last.F_y);
  if (c.drive.kind != contact::Drive::Kind::load)
    return error;
  const double most = c.friction.coefficient * c.drive.value;
  const Elastic &lower = c.lower.material.elastic, &upper = c.upper.material.elastic;
  double parts = 0.0;
  if (c.creepage->spin != 0.0)
  {
    const LateralParts alone = lateral_parts(c, plan);
    parts = std::min(most, alone.force_of_creepage + alone.force_of_spin);
  }
  if (!(lower == upper))
    parts = std::max(parts, 0.3 * most);
  error.error *=
      force > 0.0 ? std::max(1.0, parts / force) : 1.0 / error.error; // of no force there is no relative error
  return error;
}

/// Error of the moment of a spin, with that of a lateral creepage, which it may nearly cancel.
Documented error_of_spin_moment(const RollingCase& c, const RollingPlan& plan, const std::vector<RollingPass>& passes)
{
  constexpr double of_lateral = 0.09; // of its moment
  Documented error = spin_moment;
  if (!passes.empty() && passes.back().M_z != 0.0)
    error.error += of_lateral * lateral_parts(c, plan).moment_of_creepage / std::abs(passes.back().M_z);
  return error;
}

/// Error of the share of the last pass that sticks; it is absolute, a row of cells.
std::optional<Documented> error_of_stick_share(const std::vector<RollingPass>& passes)
{
  if (passes.empty() || !(passes.back().stick_share > 0.0))
    return std::nullopt;
  Documented error = stick_share;
  error.error /= passes.back().stick_share;
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
    errors.push_back(error_of_creep_force(c, plan, passes));
  if (c.creepage && c.creepage->spin != 0.0)
    errors.push_back(error_of_spin_moment(c, plan, passes));
  if (const auto share = c.creepage ? error_of_stick_share(passes) : std::nullopt)
    errors.push_back(*share);
  errors.push_back(!is_plane ? rut : c.friction.coefficient > 0.0 ? rut_of_sliding_line : rut_of_line);
  if (!hardly_resists(c, passes))
    errors.push_back(resistance_to_rolling);
  errors.push_back(dissipation);
  errors.back().further = std::abs(plan.way() / c.distance - 1.0); // length of the track
  if (!is_plane)
  {
    errors.insert(errors.end(), std::begin(of_rolled_points), std::end(of_rolled_points));
    if (c.friction.coefficient > 0.0 && !c.creepage)
      errors[errors.size() - std::size(of_rolled_points)].error = error_of_rubbed_shoulder;
  }
  return errors;
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
  // discretization error of the dissipation, 8 %.
  constexpr double largest_unsteadiness = 0.3;
  const auto worst = std::max_element(passes.begin(), passes.end(),
                                      [](const RollingPass& a, const RollingPass& b)
                                      { return std::abs(a.unsteadiness) < std::abs(b.unsteadiness); });
  if (worst == passes.end() || !(std::abs(worst->unsteadiness) > largest_unsteadiness))
    return std::nullopt;
  const bool is_rough = !rolling.lower.texture.is_smooth() || !rolling.upper.texture.is_smooth();
  const bool has_inclusions = !rolling.lower.inclusions.empty() || !rolling.upper.inclusions.empty();
  return Warning{
      "unsteady_track",
      fmt::format("pass {}: the energy absorbed per length differs by {} between the two quarters in the middle of the "
                  "track: resistance, friction and mean F_X hold for this part of the track only; use a longer track{}",
                  worst - passes.begin() + 1, percent_text(std::abs(worst->unsteadiness)),
                  is_rough         ? ", many times longer than the texture"
                  : has_inclusions ? ", many times longer than the distance of the inclusions"
                                   : "")};
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

template <>
Facts facts(const RollingCase& c, const RollingPlan& plan, const Seen<RollingCase>& seen)
{
  const std::vector<RollingPass> passes = seen.summary ? seen.summary->passes : std::vector<RollingPass>();
  Facts f = facts_of(c, plan, plan.half_width_x, plan.half_width_y);
  f.documented = documented_of_passes(c, plan, f.is_plane, passes);
  f.moves = true;
  f.slides = !c.creepage && c.slide_to_roll != 0.0;
  f.may_stick = c.creepage.has_value();
  if (c.creepage)
  {
    f.temperature_rise.error = temperature_error_of_sticking;
    f.slip.error = creep_force.error; // it goes with the work of the creep force
  }
  // The motion of the faster surface counts: with much sliding it moves many cells while the other one moves one cell.
  if (const double faster = plan.shift * std::max(1.0, upper_share(c)); c.shift || faster > plan.shift)
    f.shift = faster;
  if (c.speed)
    f.heating_time = 2.0 * f.half_x / (*c.speed * std::max(1.0, upper_share(c)));
  if (seen.summary && hardly_sinks(*seen.summary))
    std::erase_if(f.documented, [](const Documented& d) { return std::string_view(d.quantity) == rut.quantity; });
  f.warning = unsteadiness(c, passes);
  if (const std::optional<Warning> warning = creep_unsteadiness(c, passes))
    f.further_warnings.push_back(*warning);
  return f;
}

template Quality expected(const RollingCase&, const RollingPlan&);
template Quality judged(const RollingCase&, const RollingPlan&, const RunTotals&);
template Quality judged(const RollingCase&, const RollingPlan&, const RollingSummary&);

} // namespace brinell::quality
