// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/simulation/forecast.hpp"

#include "brinell/simulation/first_yield.hpp"
#include "elastoplastic/window.hpp"
#include "footprint.hpp"
#include "foundation/fft.hpp"
#include "heat.hpp"
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

Softest softest(const ShapedBody& lower, const ShapedBody& upper)
{
  Softest found;
  for (const ShapedBody* body : {&lower, &upper})
  {
    if (!body->material.is_plastic())
      continue;
    const double factor = smallest_yield_factor(body->material);
    const double yield = factor * constitutive::initial_yield_stress(*body->material.hardening);
    if (!(yield < found.yield))
      continue;
    const double later =
        factor * std::visit([](const auto& law) { return law.yield_stress_at(0.05); }, *body->material.hardening);
    found = {yield, later / yield - 1.0, !body->material.kinematic.empty()};
  }
  return found;
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

  const Softest soft = softest(lower, upper);
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
                  {"depth", plan.lower.nz * plan.lower.dz / half_width}};
  return work;
}

} // namespace brinell::simulation
