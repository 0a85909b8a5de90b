// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/simulation/forecast.hpp"

#include "brinell/halfspace/inclusions.hpp"
#include "brinell/simulation/first_yield.hpp"
#include "constitutive/lane_return.hpp"
#include "elastoplastic/body/window.hpp"
#include "footprint.hpp"
#include "foundation/fft.hpp"
#include "heat.hpp"
#include "memory.hpp"
#include "roughness.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace brinell::simulation
{

namespace
{

/// Operations of a transform of a plane, there or back.
double transform(const SurfaceGrid& grid)
{
  const PaddedLengths padded = padded_lengths(grid);
  const double points = static_cast<double>(padded.x) * padded.y;
  return points * std::log2(points);
}

/// The grid of the evaluations that do not end an increment: of long bodies a window.
SurfaceGrid evaluated(const Numerics& numerics, const Plan& plan, const SurfaceGrid& surface)
{
  constexpr double of_contact = 0.65; // as for the memory
  SurfaceGrid part = surface;
  if (!(numerics.solver.shortcuts && numerics.solver.windows) || surface.is_periodic_x())
    return part;
  const int needed = static_cast<int>(std::ceil(of_contact * plan.contact.nx));
  if (const auto window = elastoplastic::window_for(needed, surface.nx))
    part.nx = elastoplastic::length_of_window(*window, surface.nx);
  return part;
}

/// The material that yields first, and what the evaluations depend on.
struct Softest
{
  double yield = std::numeric_limits<double>::infinity(); ///< initial yield stress [Pa]
  double over_weakest = 1.0; ///< initial yield stress relative to that at the depth where it is least
  double growth = 0.0;       ///< of the yield stress over 5 % of plastic strain, relative to it
  bool is_kinematic = false;
};

/// @param depth  at which the stress is largest [m]
Softest softest(const ShapedBody& lower, const ShapedBody& upper, double depth)
{
  Softest found;
  for (const ShapedBody* body : {&lower, &upper})
  {
    if (!body->material.is_plastic())
      continue;
    const double factor = body->material.yield_factor.at(depth, 1.0);
    const double yield = factor * constitutive::initial_yield_stress(body->material.law());
    if (!(yield < found.yield))
      continue;
    const double later =
        factor * std::visit([](const auto& law) { return law.yield_stress_at(0.05); }, body->material.law());
    found = {yield, factor / smallest_yield_factor(body->material), later / yield - 1.0,
             !body->material.kinematic.empty()};
  }
  return found;
}

/// Root mean square of the slopes of a texture.
double slope_of(const TexturePart& part)
{
  if (const auto* dent = std::get_if<Dent>(&part))
    return std::abs(dent->depth) / dent->edge_radius;
  if (const auto* map = std::get_if<HeightMap>(&part))
    return rms_slope(*map);
  if (const auto* waves = std::get_if<Sinusoid>(&part))
    return std::numbers::sqrt2 * std::numbers::pi * std::abs(waves->amplitude) *
           std::hypot(1.0 / waves->wavelength_x, 1.0 / waves->wavelength_y);
  return std::get<RandomSurface>(part).rms_slope();
}

double slope_of(const ShapedBody& lower, const ShapedBody& upper)
{
  double square = 0.0;
  for (const ShapedBody* body : {&lower, &upper})
    for (const TexturePart& part : body->texture.parts)
      square += std::pow(slope_of(part), 2);
  return std::sqrt(square);
}

/// Largest slope of the shape of a tip; 0 of other shapes.
double slope_of_tip(const Shape& shape)
{
  if (const auto* cone = std::get_if<Cone>(&shape))
    return 1.0 / std::tan(cone->half_angle);
  if (const auto* pyramid = std::get_if<Pyramid>(&shape))
    return 1.0 / std::tan(pyramid->face_angle);
  return 0.0;
}

/// Bodies, surfaces and motion of a run, from which factors and amounts follow.
struct Situation
{
  const PairCase& pair;
  const Plan& plan;
  const Course& course;
  double half_width; ///< of the contact along x [m]
  const ShapedBody &lower = pair.lower, &upper = pair.upper;
  Softest soft = softest(lower, upper, 0.5 * half_width);
  bool is_smooth = are_smooth(lower, upper);
  bool is_of_flats = plan.contact.is_periodic(); ///< rough ones
  bool is_line = is_plane(plan.contact);
  bool heats = is_heated(pair);
  double friction = pair.friction.coefficient;
  double modulus = contact_modulus(lower.material.elastic, upper.material.elastic);
  double tip = std::max(slope_of_tip(lower.shape), slope_of_tip(upper.shape)); ///< slope; 0 without one

  [[nodiscard]] bool can_yield() const { return std::isfinite(soft.yield); }
  [[nodiscard]] double severity() const;
  [[nodiscard]] double shear() const;
};

/// How far the pressure is above that at first yield: of smooth bodies, or of their roughness.
double Situation::severity() const
{
  if (!can_yield())
    return 0.0;
  if (tip > 0.0)
    return 0.5 * modulus * tip / (1.1 * soft.yield);
  // Peak pressure of waves that are just flattened (Westergaard), over that of a round contact at first yield.
  const double of_texture = 0.5 * modulus * std::numbers::sqrt2 * slope_of(lower, upper) / (1.6 * soft.yield);
  if (is_of_flats)
  {
    constexpr double flattened = 0.25; // share of contact from which on the waves press on each other
    return of_texture * std::pow(std::min(1.0, plan.contact_share / flattened), 0.4);
  }
  // Where surfaces stick, friction is not all there that would make them yield earlier.
  const double frictionless = std::sqrt(plan.first_yield / plan.scales.displacement);
  const double mobilised = std::min(1.0, course.mobilised);
  const double smooth = plan.peak_over_yield / soft.over_weakest * (frictionless + (1.0 - frictionless) * mobilised);
  if (is_smooth)
    return smooth;
  return smooth > 0.0 ? std::hypot(smooth, 0.5 * std::min(of_texture, 3.0 * smooth)) : of_texture;
}

/// Shear that acts, over the shear yield stress.
double Situation::shear() const
{
  constexpr double hardness = 2.8, most = 1.7;
  if (friction == 0.0 || !can_yield())
    return 0.0;
  const double pressure = std::min(plan.peak_pressure, hardness * soft.yield);
  return std::min(most, friction * pressure * std::numbers::sqrt3 / soft.yield) * std::min(1.0, course.mobilised);
}

/// Severities between which contacts begin to yield: nothing does below, and all do above.
constexpr double begins_to_yield = 0.8, yields = 1.25;
/// From which on increments may have to be split.
constexpr double is_deep = 8.0;

std::vector<Factor> factors_of(const Situation& s, double severity)
{
  const Course& course = s.course;
  const double steps = course.steps();
  const double over = std::log(std::max(severity, 1.0)), soft = std::exp(-2.0 * s.soft.growth), shear = s.shear();
  const auto is = [&](RunKind kind) { return course.kind == kind ? 1.0 : 0.0; };
  const double presses = is(RunKind::indentation), frets = is(RunKind::fretting),
               passes = is(RunKind::rolling) + is(RunKind::sliding), line = s.is_line ? 1.0 : 0.0,
               flats = s.is_of_flats && !s.is_smooth ? 1.0 : 0.0, tip = s.tip > 0.0 ? 1.0 : 0.0;
  const bool both =
      s.lower.material.is_plastic() && s.upper.material.is_plastic() && s.plan.twin == elastoplastic::Twin::none;
  const auto effects = elastoplastic::names_of(s.pair, {&s.lower.material, &s.upper.material});
  const auto acts = [&](std::string_view effect)
  { return std::find(effects.begin(), effects.end(), effect) != effects.end() ? 1.0 : 0.0; };
  std::vector<Factor> factors{{"indentation", presses},
                              {"rolling", is(RunKind::rolling)},
                              {"tugging", is(RunKind::tugging)},
                              {"sliding", is(RunKind::sliding)},
                              {"fretting", frets},
                              {"severity of indentation", presses * over},
                              {"severity of rolling", is(RunKind::rolling) * over},
                              {"severity of tugging", is(RunKind::tugging) * over},
                              {"severity of sliding", is(RunKind::sliding) * over},
                              {"severity of fretting", frets * over},
                              {"severity that is deep", std::log(std::max(severity / is_deep, 1.0))},
                              {"severity under a tip", tip * over},
                              {"severity without hardening", over * soft},
                              {"severity of a line", line * over},
                              {"severity of flats", flats * over},
                              {"no hardening", soft},
                              {"shear", shear},
                              {"shear near its limit", std::max(0.0, shear - 0.8)},
                              {"line", line},
                              {"tip", tip},
                              {"flats", flats},
                              {"contact of flats", flats * std::log(s.plan.contact_share / 0.1)},
                              {"rough", s.is_smooth || s.is_of_flats ? 0.0 : 1.0},
                              {"softness", s.can_yield() ? std::log(s.modulus / s.soft.yield / 250.0) : 0.0},
                              {"resolution", std::log(s.half_width / s.plan.contact.dx / 8.0)},
                              {"kinematic hardening", s.soft.is_kinematic ? 1.0 : 0.0},
                              {"both bodies", both ? 1.0 : 0.0},
                              {"wear", acts("wear")},
                              {"heat", s.heats ? 1.0 : 0.0},
                              {"steps of loading", presses * std::log(std::max(1.0, course.loading) / 8.0)},
                              {"unloading", presses * course.unloading / steps},
                              {"again", course.again / steps},
                              {"pressing before a motion", passes * (course.loading + course.unloading) / steps},
                              {"pressing before fretting", frets * course.loading / steps},
                              {"turns", passes * std::log(1.0 + course.turns * 4.0 * shear / steps)}};
  const double share = std::clamp((severity - begins_to_yield) / (yields - begins_to_yield), 0.0, 1.0);
  for (Factor& factor : factors)
    factor.value *= share;
  return factors;
}

/// Evaluations per step with inclusions, also where the body does not yield (measured, docs/theory/inclusions.md).
constexpr double evaluations_with_inclusions = 6.0;

/// Corrections of the equivalent strain of inclusions in an evaluation (measured there, too): one by a matrix, several by iterations in a part of the grid,
/// which take about as long again.
double corrections_of(const EmbeddedCells& inclusions)
{
  constexpr std::size_t per_cell = 6;
  constexpr double least = 3.0, of_contrast = 3.0;
  if (per_cell * inclusions.cells <= halfspace::Inclusions::most_of_matrix)
    return 1.0;
  return least + of_contrast * std::max(inclusions.softest, -inclusions.stiffest);
}

/// Sums over the bodies that are solved, in transforms of planes and in cells, both in units of 1e9.
struct Sizes
{
  double transforms = 0.0, cells = 0.0, nonlinear_cells = 0.0; ///< of an evaluation of bodies that may yield
  double operators = 0.0, output = 0.0, heated_layers = 0.0;
};

Sizes sizes_of(const Situation& s)
{
  const double unit = 1e-9 * (s.is_line && s.can_yield() ? growth_of_line(s.severity()) : 1.0);
  constexpr double of_correction = 1.6; // with the dilatation
  Sizes sizes;
  for (const auto& [body, grid] : {std::pair{&s.lower, &s.plan.lower}, {&s.upper, &s.plan.upper}})
  {
    if (body->material.elastic.is_rigid() || s.plan.surfaces_only)
      continue;
    const double all = unit * transform(grid->surface) * grid->nz;
    sizes.output += all;
    if (s.plan.twin != elastoplastic::Twin::none && grid == &s.plan.upper)
      continue;
    sizes.operators += all;
    if (!body->material.is_plastic())
      continue;
    const bool is_linear =
        body->material.kinematic.empty() && s.pair.solver.integration == elastoplastic::Integration::path &&
        std::visit([]<typename Law>(const Law&) { return constitutive::is_linear<Law>; }, body->material.law());
    const double cells = unit * static_cast<double>(grid->size());
    const EmbeddedCells& inclusions = s.plan.inclusions[grid == &s.plan.lower ? 0 : 1];
    const bool is_whole = inclusions.cells > 0; // no windows
    sizes.transforms +=
        unit * transform(is_whole ? grid->surface : evaluated(s.pair, s.plan, grid->surface)) * grid->nz;
    if (inclusions.cells > 0)
      sizes.transforms += unit * transform(grid->surface) * grid->nz * of_correction * corrections_of(inclusions);
    sizes.cells += cells;
    sizes.nonlinear_cells += is_linear ? 0.0 : cells;
    sizes.heated_layers += s.heats && body->material.thermal ? all : 0.0;
  }
  return sizes;
}

std::vector<Amount> amounts_of(const Situation& s, const Storage& storage)
{
  constexpr double unit = 1e-9;
  constexpr double share_of_half = 0.6; // time for one side of y = 0 over that for both
  const Sizes sizes = sizes_of(s);
  const double part = s.plan.contact.is_mirrored_y ? share_of_half : 1.0, steps = s.course.steps();
  const double line = s.is_line ? 1.0 : 0.0, shears = s.friction > 0.0 ? 1.0 : 0.0;
  const double contact = unit * transform(s.plan.contact);
  // An elastic contact is solved anew in each step, one that yields many times a step from a guess that is nearly right. Patches
  // all over a period take more iterations.
  constexpr double of_patches = 4.5;
  const double elastic = s.can_yield() ? 0.0 : contact * (s.is_of_flats && !s.is_smooth ? of_patches : 1.0);
  const bool is_steady = s.pair.heat.regime == elastoplastic::HeatRegime::steady;
  const double heat =
      s.heats ? unit * memory_parts(s.plan, s.lower.material, s.upper.material, s.pair.solver, 1, &s.pair.heat).heat
              : 0.0;
  return {{"start", 1.0, 0.0},
          {"steps", steps, 0.0},
          {"evaluations", 0.0, s.can_yield() ? 1.0 : 0.0},
          {"transforms", 0.0, part * sizes.transforms},
          {"cells", 0.0, part * sizes.cells},
          {"cells of nonlinear laws", 0.0, part * sizes.nonlinear_cells},
          {"cells of a line", 0.0, line * sizes.cells},
          {"cells of a line, of nonlinear laws", 0.0, line * sizes.nonlinear_cells},
          {"contact", 0.0, contact},
          {"contact of elastic bodies", 0.0, elastic},
          {"contact under friction", 0.0, shears * contact},
          {"contact that sticks", 0.0, s.course.sticks ? contact : 0.0},
          {"friction", 0.0, shears},
          {"operators", sizes.operators, 0.0},
          {"states", storage.states, 0.0},
          {"fields of states", storage.states * sizes.output, 0.0},
          {"bytes", unit * storage.bytes, 0.0},
          {"heat", is_steady ? 0.0 : heat * steps, 0.0},
          {"heated layers", is_steady ? 0.0 : sizes.heated_layers * steps, 0.0},
          {"steady heat", is_steady ? heat : 0.0, 0.0},
          {"steps of steady heat", is_steady ? heat * steps : 0.0, 0.0}};
}

} // namespace

Workload workload(const PairCase& c, const Plan& plan, double half_width, const Course& course, const Storage& storage)
{
  const Situation situation{c, plan, course, half_width};
  const double severity = situation.severity();
  const Certainty certainty = severity < begins_to_yield ? Certainty::elastic
                              : severity < is_deep       ? Certainty::yields
                                                         : Certainty::deep;
  const bool has_inclusions = plan.inclusions[0].cells + plan.inclusions[1].cells > 0;
  return {course.steps(), factors_of(situation, severity), amounts_of(situation, storage),
          has_inclusions && certainty == Certainty::elastic ? Certainty::yields : certainty,
          has_inclusions ? evaluations_with_inclusions : 1.0};
}

} // namespace brinell::simulation
