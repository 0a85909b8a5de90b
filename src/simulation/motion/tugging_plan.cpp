// SPDX-License-Identifier: BSD-3-Clause
#include "tugging_plan.hpp"

#include "brinell/foundation/error.hpp"
#include "brinell/reference/hertz.hpp"
#include "brinell/simulation/first_yield.hpp"
#include "simulation/plan/domain.hpp"
#include "simulation/plan/effects.hpp"
#include "simulation/plan/embedding.hpp"
#include "simulation/plan/footprint.hpp"
#include "simulation/plan/friction.hpp"
#include "simulation/plan/grid_layout.hpp"
#include "simulation/plan/heat.hpp"
#include "simulation/plan/plan_end.hpp"
#include "simulation/plan/symmetry.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace brinell::simulation
{

namespace
{

// Extent of the grids in elastic contact radii. It suffices up to nine times the interference of first yield; beyond that,
// contact and plastic zone grow faster than the elastic contact radius.
constexpr double contact_extent_x = 2.0;
constexpr double contact_extent_y = 1.5;
constexpr double track_extent = 1.6;

/// Radius of a body across the motion, which it needs to be passed beside its top.
double rounding_across(const char* body, const Shape& shape)
{
  const auto* paraboloid = std::get_if<Paraboloid>(&shape);
  if (!paraboloid || !(paraboloid->radius_y > 0.0) || !std::isfinite(paraboloid->radius_y))
    throw PlanError("`TuggingCase::offset`: {} is not rounded across the motion, so that "
                    "nothing passes beside its top; allowed with an offset: spheres, and "
                    "ellipsoids with radius_y > 0",
                    member_of(body, "shape"));
  return paraboloid->radius_y;
}

/// Quantities of the pair of bodies that the plan needs.
struct Pair
{
  ClosestApproach closest;
  ContactSize contact;               ///< elastic, of the smooth bodies at alignment
  double peak_pressure = 0.0;        ///< of that contact [Pa]
  double peak_over_yield = 0.0;      ///< see Plan
  double first_yield = 0.0;          ///< interference at first yield, at most the full interference [m]
  double frictionless_yield = 0.0;   ///< interference at first yield without friction [m]
  std::array<double, 2> curvature{}; ///< relative [1/m]
  TextureReach texture;              ///< of both bodies together
};

/// @param interference  along the line of centres [m]
void require_touch(const TuggingCase& tugging, double interference)
{
  if (interference > 0.0 || tugging.offset == 0.0)
    return;
  const double overlap = tugging.interference;
  const double sum = rounding_across("lower", tugging.lower.shape) + rounding_across("upper", tugging.upper.shape);
  throw PlanError("`TuggingCase::offset` amounts to {:.6g} m, at which the bodies pass without touching; allowed "
                  "with an interference of {:.4g} m: between -{:.6g} and {:.6g} m",
                  tugging.offset, overlap, std::sqrt(overlap * (2.0 * sum - overlap)),
                  std::sqrt(overlap * (2.0 * sum - overlap)));
}

Pair pair_of(const TuggingCase& tugging)
{
  const ShapedBody& lower = tugging.lower;
  const ShapedBody& upper = tugging.upper;
  const double friction = tugging.friction.coefficient;
  if (const auto reason = reason_against_contact(lower, upper, tugging.domain))
    throw InputError("the bodies " + *reason);
  Pair pair;
  pair.closest = closest_approach(tugging);
  const double interference = pair.closest.interference;
  require_touch(tugging, interference);
  pair.curvature = relative_curvature(lower.shape, upper.shape).value();
  const TextureReach of_lower = reach(lower.texture);
  const TextureReach of_upper = reach(upper.texture);
  pair.texture = {of_lower.height + of_upper.height, std::max(of_lower.half_width_y + std::abs(pair.closest.y_lower),
                                                              of_upper.half_width_y + std::abs(pair.closest.y_upper))};
  pair.first_yield = pair.frictionless_yield = interference;
  if (const std::optional<double> radius = equivalent_radius(lower.shape, upper.shape))
  {
    const double a = std::sqrt(*radius * interference);
    pair.contact = {a, a};
    const double modulus = contact_modulus(lower.material.elastic, upper.material.elastic);
    pair.peak_pressure = reference::point_contact_at_approach(*radius, modulus, interference).peak_pressure;
    require_within_reference(a, a, lower, upper, tugging.domain);
    const auto first_yield = [&](double coefficient)
    {
      const auto yield = earliest_first_yield(lower, upper, tugging.domain, coefficient);
      return yield ? std::min(interference, yield->critical.interference) : interference;
    };
    pair.first_yield = first_yield(friction);
    if (pair.first_yield > 0.0) // the peak pressure grows as the root of the interference
      pair.peak_over_yield = std::sqrt(interference / pair.first_yield);
    pair.frictionless_yield = first_yield(0.0);
    return pair;
  }
  const Footprint f =
      smooth_footprint(lower, upper, {contact::Drive::Kind::approach, interference}, tugging.domain, friction);
  pair.contact = {f.elastic_x, f.elastic_y, f.straight_y};
  pair.peak_pressure = f.peak_pressure;
  pair.peak_over_yield = f.peak_ratio;
  pair.first_yield = std::min(interference, f.first_yield_approach);
  pair.frictionless_yield = std::min(interference, f.frictionless_yield_approach);
  return pair;
}

double plastic_growth(const TuggingCase& tugging, const Pair& pair)
{
  constexpr double covered = 9.0;
  // If the bodies differ, the weaker one takes most of the plastic strain; under a load, plastic flow increases the approach
  // along the whole track. Both count as twice the interference.
  const bool is_doubled = !(tugging.lower == tugging.upper) || tugging.load;
  const double ratio = pair.closest.interference / pair.first_yield * (is_doubled ? 2.0 : 1.0);
  return std::pow(std::max(1.0, ratio / covered), 0.4);
}

/// Distance from the middle of the contact at which surfaces with a relative curvature overlap by geometry: an upper bound for
/// the size of an elastic contact [m].
double overlap_reach(double curvature, double depth)
{
  return std::sqrt(2.0 * std::max(0.0, depth) / curvature);
}

/// Largest distance of the contact's edge from the top of a body, from first touch to alignment [m].
double track_half_length(const TuggingCase& tugging, const Pair& pair, const Passing& passing, double radius,
                         double scale)
{
  const double sum = passing.radius_lower() + passing.radius_upper();
  const double height = pair.texture.height;
  const double angle_at_touch =
      height > 0.0 ? std::acos(passing.separation() / (sum + height)) : passing.angle_at_touch();
  double farthest = 0.0;
  constexpr double samples = 200.0;
  for (int i = 0; i <= samples; ++i)
  {
    const double theta = angle_at_touch * i / samples;
    // Under a load the approach rises with the load, which is applied within a quarter of this half of the pass.
    const double interference = tugging.load ? pair.closest.interference * std::min(1.0, 4.0 * (samples - i) / samples)
                                             : sum - passing.separation() / std::cos(theta);
    double edge =
        scale * track_extent * pair.contact.half_x * std::sqrt(std::max(0.0, interference / pair.closest.interference));
    if (height > 0.0) // includes all places where textures may touch
      edge = std::max(edge, tugging.extent * overlap_reach(pair.curvature[0], interference + height));
    farthest = std::max(farthest, radius * theta + edge);
  }
  return farthest;
}

Extents extents_of(const TuggingCase& tugging, const Pair& pair, const Passing& passing)
{
  const double scale = tugging.extent * plastic_growth(tugging, pair);
  const auto [half_x, half_y, straight_y] = pair.contact;
  Extents e;
  e.contact_x = contact_extent_x * scale * half_x;
  // As much margin beyond the ends of a roller as beside a point contact.
  e.contact_y = straight_y ? half_y + (contact_extent_y * scale - 1.0) * half_x : contact_extent_y * scale * half_y;
  if (const double height = pair.texture.height; height > 0.0)
  {
    const double overlap = pair.closest.interference + height;
    e.contact_x = std::max(e.contact_x, tugging.extent * overlap_reach(pair.curvature[0], overlap));
    if (!straight_y)
      e.contact_y = std::max(
          e.contact_y, tugging.extent * std::min(overlap_reach(pair.curvature[1], overlap), pair.texture.half_width_y));
  }
  e.lower_x = track_half_length(tugging, pair, passing, passing.radius_lower(), scale);
  e.upper_x = track_half_length(tugging, pair, passing, passing.radius_upper(), scale);
  const bool endless = touch_all_along_y(tugging.lower.shape, tugging.upper.shape, tugging.domain);
  e.depth = scale * stressed_depth(half_x, endless ? std::numeric_limits<double>::infinity() : half_y);
  e.depth = depth_with_inclusions(tugging.lower, tugging.upper, e.depth);
  cover(tugging.heat.source, e);
  return e;
}

/// Whether the bodies are alike and their cells always coincide with mirror images of cells of the other body.
bool is_mirrored(const TuggingCase& tugging, const Position& p, double cells, double dx)
{
  constexpr double rounding = 1e-9;
  const double columns = (p.arc_lower - p.arc_upper) / dx;
  return tugging.solver.mirror && tugging.are_alike() && shares_alike(tugging) &&
         tugging.lower.shape == tugging.upper.shape && alike(tugging.lower, tugging.upper) &&
         cells == std::round(cells) && std::abs(columns - std::round(columns)) < rounding &&
         std::abs(p.arc_lower + p.arc_upper) < rounding * dx;
}

/// Shortest and total durations, with a reserve.
/// @param cells  by which the contact moves over both bodies together in a step
halfspace::HeatTimes heat_times(const TuggingCase& tugging, const TuggingPlan& plan, double cells)
{
  const double step = cells * plan.contact.dx / tugging.speed.value();
  constexpr double further_steps = 50.0;
  return {step * std::min(1.0, 0.5 / cells),
          step * tugging.passes * (reserve_of_heated_pass * plan.steps_per_pass + further_steps)};
}

double required_radius(const char* body, const Shape& shape)
{
  const std::optional<double> radius = passing_radius(shape);
  if (!radius)
    throw InputError(fmt::format("{} has no radius > 0 in the plane of motion and cannot pass another body; "
                                 "allowed in tugging: spheres, ellipsoids with radius_x > 0, and cylinders",
                                 member_of(body, "shape")));
  return *radius;
}

/// Cells, and the mean arc of a step on the bodies [m].
struct StepsOfPass
{
  std::array<double, 3> cells{};
  double shift = 0.0;
};

/// Under a load a pass is as long as rigid bodies would touch, and the load rises and falls by place: steps end where it does.
/// docs/theory/simulation.md (steps that fit the way)
StepsOfPass steps_of_pass(const TuggingCase& tugging, const std::array<double, 3>& cells)
{
  const double shift = tugging.shift.value_or(cells[0]);
  const Passing wanted = passing(tugging, shift, cells[0]);
  if (!tugging.load)
    return {cells, shift};
  // Of both bodies together, from first touch to alignment; so is what a step moves.
  const double arc = wanted.angle_at_touch() * (wanted.radius_lower() + wanted.radius_upper());
  const std::optional<double> both = tugging.shift ? std::optional(2.0 * shift) : std::nullopt;
  const StepsOnWay steps = steps_on_way(tugging, cells, {.shift = both}, arc, 1, "`TuggingCase::load`");
  return {steps.cells, both ? 0.5 * steps.shift : steps.cells[0]};
}

} // namespace

std::optional<double> passing_radius(const Shape& shape)
{
  const auto k = curvature(shape);
  if (!k || !((*k)[0] > 0.0) || !std::isfinite((*k)[0]))
    return std::nullopt;
  if (const auto* paraboloid = std::get_if<Paraboloid>(&shape))
    return paraboloid->radius_x; // exactly as given, without the rounding of its inverse
  return std::get<Roller>(shape).radius;
}

ClosestApproach closest_approach(const TuggingCase& tugging)
{
  if (tugging.offset == 0.0)
    return {tugging.interference, 0.0, 0.0, 0.0};
  const auto lower = rounding_across("lower", tugging.lower.shape);
  const auto upper = rounding_across("upper", tugging.upper.shape);
  const double height = lower + upper - tugging.interference;
  const double tilt = std::atan2(tugging.offset, height);
  return {lower + upper - std::hypot(height, tugging.offset), tilt, lower * tilt, -upper * tilt};
}

double elastic_approach(const ShapedBody& lower, const ShapedBody& upper, double load, const Domain& domain)
{
  const double modulus = contact_modulus(lower.material.elastic, upper.material.elastic);
  if (const std::optional<double> radius = equivalent_radius(lower.shape, upper.shape))
    return reference::point_contact_at_load(*radius, modulus, load).approach;
  return smooth_footprint(lower, upper, {contact::Drive::Kind::load, load}, domain).approach;
}

double relative_cells(double shift, double dx)
{
  constexpr double rounding = 1e-6;
  const double cells = 2.0 * shift / dx;
  const double whole = std::round(cells);
  if (!(cells > 0.0))
    throw InputError(fmt::format("`TuggingCase::shift` = {:g} m; allowed: > 0", cells * 0.5 * dx));
  return std::abs(cells - whole) <= rounding * cells ? whole : cells;
}

Passing passing(const TuggingCase& tugging, double shift, double dx)
{
  return {required_radius("lower", tugging.lower.shape),
          required_radius("upper", tugging.upper.shape),
          closest_approach(tugging).interference,
          relative_cells(shift, dx),
          dx,
          tugging.kinematics};
}

TuggingPlan plan(const TuggingCase& tugging)
{
  require_friction(tugging, "");
  require_effects(tugging, "");
  require_heat(tugging, {.speed = tugging.speed, .speed_name = "`TuggingCase::speed`"});
  for (const auto& [name, body] : {std::pair{"lower", &tugging.lower}, {"upper", &tugging.upper}})
    static_cast<void>(required_radius(name, body->shape));
  const Pair pair = pair_of(tugging);
  constexpr double aspect = 2.0; // cells may be longer across the motion: this costs half a percent of the net energy
  const auto [cell, shift] = steps_of_pass(tugging, cell_sizes(tugging, pair.contact, aspect));
  const double dx = cell[0];
  const Passing pass = passing(tugging, shift, dx);
  if (!(pair.texture.height < std::min(pass.radius_lower(), pass.radius_upper())))
    throw InputError(fmt::format("the textures are together {:g} m high on bodies of {:g} and {:g} m radius; allowed: "
                                 "less than either",
                                 pair.texture.height, pass.radius_lower(), pass.radius_upper()));
  TuggingPlan plan;
  plan.surfaces_only = needs_surfaces_only(tugging);
  lay_out(cell, extents_of(tugging, pair, pass), tugging.domain, plan);
  check_grids(tugging, plan);
  plan.closest = pair.closest;
  plan.elastic_contact_radius = pair.contact.half_x;
  plan.elastic_contact_radius_y = pair.contact.half_y;
  plan.texture_height = pair.texture.height;
  plan.steps_per_pass = pass.step_count();
  plan.steps = tugging.passes * (plan.steps_per_pass + 1);
  const double cells = relative_cells(shift, dx);
  plan.twin =
      is_mirrored(tugging, pass.start(0), cells, dx) ? elastoplastic::Twin::mirror_image : elastoplastic::Twin::none;
  mirror_grids(is_solved_by_halves(tugging, plan.contact, tugging.offset != 0.0), plan);
  // Lower limit: smaller changes of displacement would be lost in the tolerance of the contact.
  const double smallest = 1e-2 * pair.closest.interference;
  plan.scales = {std::max(pair.frictionless_yield, smallest), pair.closest.interference};
  plan.first_yield = std::max(pair.first_yield, smallest);
  plan.peak_pressure = pair.peak_pressure;
  plan.peak_over_yield = pair.peak_over_yield;
  plan.shift = 0.5 * cells * dx;
  plan.start_distance = pass.start_distance();
  end_plan(tugging, false, plan, [&] { return heat_times(tugging, plan, cells); },
           {plan.closest.y_lower, plan.closest.y_upper});
  return plan;
}

} // namespace brinell::simulation
