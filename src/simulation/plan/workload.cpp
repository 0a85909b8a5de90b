// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/simulation/forecast.hpp"

#include "brinell/simulation/first_yield.hpp"
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

/// The softer material, and what its yield depends on.
struct Softest
{
  double yield = std::numeric_limits<double>::infinity(); ///< initial yield stress [Pa]
  double growth = 0.0; ///< of the yield stress over 5 % of plastic strain, relative to it
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
    const double yield = factor * constitutive::initial_yield_stress(*body->material.hardening);
    if (!(yield < found.yield))
      continue;
    const double later =
        factor * std::visit([](const auto& law) { return law.yield_stress_at(0.05); }, *body->material.hardening);
    found = {yield, later / yield - 1.0, !body->material.kinematic.empty()};
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

} // namespace

Workload workload(const Numerics& numerics, const ShapedBody& lower, const ShapedBody& upper, const Plan& plan,
                  double half_width, const Course& course, const Storage& storage)
{
  Workload work;
  work.course = course;
  work.can_yield = lower.material.is_plastic() || upper.material.is_plastic();
  const double friction = numerics.friction.coefficient;
  const bool heats = is_heated(numerics, lower, upper);

  double whole = 0.0, window = 0.0, cells = 0.0, operators = 0.0, output = 0.0, heated = 0.0, heated_layers = 0.0;
  double plastic_bodies = 0.0;
  for (const auto& [body, grid] : {std::pair{&lower, &plan.lower}, {&upper, &plan.upper}})
  {
    if (body->material.elastic.is_rigid())
    {
      if (heats && body->material.thermal)
        heated += transform(grid->surface);
      continue;
    }
    const double per_layer = transform(grid->surface);
    output += per_layer * grid->nz;
    const bool is_twin = plan.twin != elastoplastic::Twin::none && grid == &plan.upper;
    if (!is_twin)
      operators += per_layer * grid->nz;
    if (is_twin)
      continue;
    if (heats && body->material.thermal)
    {
      heated += per_layer;
      heated_layers += body->material.is_plastic() ? per_layer * grid->nz : 0.0;
    }
    if (!body->material.is_plastic())
      continue;
    plastic_bodies += 1.0;
    whole += per_layer * grid->nz;
    window += transform(evaluated(numerics, plan, grid->surface)) * grid->nz;
    cells += static_cast<double>(grid->size());
  }
  const double half = plan.symmetry == Symmetry::none ? 0.0 : 1.0;
  work.amounts = {{"whole", whole},
                  {"window", window},
                  {"symmetric", half},
                  {"cells", cells},
                  {"contact", transform(plan.contact)},
                  {"operators", operators},
                  {"output", output},
                  {"states", storage.states},
                  {"bytes", storage.bytes},
                  {"heated", heated},
                  {"heated_layers", heated_layers},
                  {"steady", heats && numerics.heat.regime == elastoplastic::HeatRegime::steady ? 1.0 : 0.0},
                  {"shears", friction > 0.0 ? 1.0 : 0.0},
                  {"first_yield_share", plan.scales.gap > 0.0 ? plan.first_yield / plan.scales.gap : 1.0},
                  {"contact_share", plan.contact_share}};

  const MemoryParts memory = memory_parts(plan, lower.material, upper.material, numerics.solver,
                                          friction > 0.0 || heats ? 1 : 0, heats ? &numerics.heat : nullptr);
  for (const auto& [name, value] : {Factor{"m_contact", memory.contact},
                                    {"m_operators", memory.operators},
                                    {"m_bodies", memory.bodies},
                                    {"m_windows", memory.windows},
                                    {"m_heat", memory.heat},
                                    {"m_trials", memory.trials},
                                    {"m_output", memory.output},
                                    {"m_checkpoint", memory.checkpoint}})
    work.amounts.push_back({name, value});

  const Softest soft = softest(lower, upper, 0.5 * half_width);
  const double weakest = std::min(
      lower.material.is_plastic()
          ? smallest_yield_factor(lower.material) * constitutive::initial_yield_stress(*lower.material.hardening)
          : 1e300,
      upper.material.is_plastic()
          ? smallest_yield_factor(upper.material) * constitutive::initial_yield_stress(*upper.material.hardening)
          : 1e300);
  const double modulus = contact_modulus(lower.material.elastic, upper.material.elastic);
  const double slope = std::max(slope_of_tip(lower.shape), slope_of_tip(upper.shape));
  const double mean_pressure_at_yield = 1.1 * soft.yield;
  double over_yield = plan.peak_over_yield;
  if (slope > 0.0)
    over_yield = 0.5 * modulus * slope / mean_pressure_at_yield;
  const double pressure = std::min(plan.peak_pressure, 2.8 * soft.yield);
  const auto waves = cells_per_shortest_wave(lower, upper, plan.contact.dx, plan.contact.dy);
  const bool is_smooth = are_smooth(lower, upper);
  work.factors = {{"over_yield", over_yield},
                  {"softness", modulus / soft.yield},
                  {"growth", soft.growth},
                  {"kinematic", soft.is_kinematic ? 1.0 : 0.0},
                  {"friction", friction},
                  {"shear", friction * pressure / (soft.yield / std::numbers::sqrt3)},
                  {"tip", slope > 0.0 ? 1.0 : 0.0},
                  {"rough", is_smooth ? 0.0 : 1.0},
                  {"waves", waves.value_or(0.0)},
                  {"plane", is_plane(plan.contact) ? 1.0 : 0.0},
                  {"periodic", plan.contact.is_periodic() ? 1.0 : 0.0},
                  {"resolution", half_width / plan.contact.dx},
                  {"loading", course.loading},
                  {"by_load", course.by_load ? 1.0 : 0.0},
                  {"plastic_bodies", plastic_bodies},
                  {"wear", numerics.wear.wears() ? 1.0 : 0.0},
                  {"heat", heats ? 1.0 : 0.0},
                  {"tolerance", numerics.solver.yield_tolerance},
                  {"sticks", course.sticks ? 1.0 : 0.0},
                  {"mobilised", course.mobilised},
                  {"frictionless", std::sqrt(plan.first_yield / plan.scales.displacement)},
                  {"profile", weakest / soft.yield},
                  {"texture", 0.5 * modulus * std::numbers::sqrt2 * slope_of(lower, upper) / (1.6 * soft.yield)},
                  {"contact_share", plan.contact_share},
                  {"depth", plan.lower.nz * plan.lower.dz / half_width}};
  return work;
}

} // namespace brinell::simulation
