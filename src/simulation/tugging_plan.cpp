// SPDX-License-Identifier: BSD-3-Clause
#include "tugging_plan.hpp"

#include "brinell/foundation/error.hpp"
#include "brinell/reference/critical.hpp"
#include "footprint.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace brinell::simulation
{

namespace
{

// Extent of the grids in elastic contact radii, enough up to nine times the interference of first yield; beyond, contact
// and plastic zone grow faster than the elastic contact radius.
constexpr double contact_extent_x = 2.0;
constexpr double contact_extent_y = 1.5;
constexpr double depth_extent = 1.85;
constexpr double track_extent = 1.6;
constexpr int track_margin = 4; ///< cells: material pushed ahead

double plastic_growth(const TuggingCase& tugging)
{
  constexpr double covered = 9.0;
  // Of two bodies that are not alike, the weaker one takes most of the plastic strain; under a load plasticity adds to the
  // approach, and the whole track bears it: as if pressed twice as far.
  const bool more = !(tugging.lower == tugging.upper) || tugging.load;
  const double ratio = tugging.interference / yield_interference(tugging) * (more ? 2.0 : 1.0);
  return std::pow(std::max(1.0, ratio / covered), 0.4);
}

double equivalent_radius(const TuggingCase& tugging)
{
  return 1.0 / (1.0 / tugging.lower.radius + 1.0 / tugging.upper.radius);
}

/// Farthest place from the top of a body that the contact's edge passes, from first touch to alignment.
double track_half_length(const TuggingCase& tugging, double radius, double angle_at_touch, double scale)
{
  const double sum = tugging.lower.radius + tugging.upper.radius;
  const double separation = sum - tugging.interference;
  double farthest = 0.0;
  constexpr double samples = 200.0;
  for (int i = 0; i <= samples; ++i)
  {
    const double theta = angle_at_touch * i / samples;
    // Under a load as much as it has come up: it does in a quarter of this way.
    const double interference = tugging.load ? tugging.interference * std::min(1.0, 4.0 * (samples - i) / samples)
                                             : std::max(0.0, sum - separation / std::cos(theta));
    farthest = std::max(farthest,
                        radius * theta + scale * track_extent * std::sqrt(equivalent_radius(tugging) * interference));
  }
  return farthest;
}

VolumeGrid material_grid(const TuggingCase& tugging, const SurfaceGrid& contact, double radius, double angle, double dz,
                         double scaled_radius)
{
  const double scale = tugging.extent * plastic_growth(tugging);
  VolumeGrid grid;
  grid.surface = contact;
  grid.surface.nx = 2 * (half_cells(track_half_length(tugging, radius, angle, scale), contact.dx) + track_margin) + 1;
  grid.nz = static_cast<int>(std::ceil(depth_extent * scaled_radius / dz - 1e-9));
  grid.dz = dz;
  return grid;
}

/// Whether the bodies are alike and pass each other so that a cell of one always has its mirror image in the other.
bool is_mirrored(const TuggingCase& tugging, const Position& p, double cells, double dx)
{
  constexpr double rounding = 1e-9;
  const double columns = (p.arc_lower - p.arc_upper) / dx;
  return tugging.solver.mirror && tugging.lower == tugging.upper && tugging.lower.material.is_plastic() &&
         cells == std::round(cells) && std::abs(columns - std::round(columns)) < rounding &&
         std::abs(p.arc_lower + p.arc_upper) < rounding * dx;
}

} // namespace

double yield_interference(const TuggingCase& tugging)
{
  double smallest = tugging.interference;
  const double modulus = contact_modulus(tugging.lower.material.elastic, tugging.upper.material.elastic);
  for (const Asperity* asperity : {&tugging.lower, &tugging.upper})
    if (asperity->material.is_plastic())
    {
      const double C = reference::critical_pressure_ratio(asperity->material.elastic.poisson_ratio);
      const double yield = constitutive::initial_yield_stress(*asperity->material.hardening);
      smallest =
          std::min(smallest, reference::critical_values(equivalent_radius(tugging), modulus, C, yield).interference);
    }
  return smallest;
}

double relative_cells(const TuggingCase& tugging, double dx)
{
  constexpr double rounding = 1e-6;
  const double cells = 2.0 * tugging.shift.value_or(dx) / dx;
  const double whole = std::round(cells);
  if (!(cells > 0.0))
    throw InputError(fmt::format("tugging.shift = {:g} m; allowed: > 0", cells * 0.5 * dx));
  return std::abs(cells - whole) <= rounding * cells ? whole : cells;
}

TuggingPlan plan(const TuggingCase& tugging)
{
  TuggingPlan plan;
  plan.elastic_contact_radius = std::sqrt(equivalent_radius(tugging) * tugging.interference);
  const double a = plan.elastic_contact_radius;
  const double cell = a / tugging.resolution;
  const std::array<double, 3> spacing = tugging.spacing.value_or(std::array<double, 3>{cell, 2.0 * cell, 0.5 * cell});
  const auto [dx, dy, dz] = spacing;
  constexpr double most_cells = 1e5;
  if (const double finest = std::min({dx, dy, dz}); a / finest > most_cells)
    throw GridError(fmt::format("grid: cells of {:g} m are too small for a contact radius of {:g} m", finest, a));
  const double scaled = a * tugging.extent * plastic_growth(tugging);
  plan.contact = {2 * half_cells(contact_extent_x * scaled, dx) + 1, 2 * half_cells(contact_extent_y * scaled, dy) + 1,
                  dx, dy};
  const double cells = relative_cells(tugging, dx);
  const Passing passing(tugging.lower.radius, tugging.upper.radius, tugging.interference, cells, dx,
                        tugging.kinematics);
  plan.lower = material_grid(tugging, plan.contact, tugging.lower.radius, passing.angle_at_touch(), dz, scaled);
  plan.upper = material_grid(tugging, plan.contact, tugging.upper.radius, passing.angle_at_touch(), dz, scaled);
  plan.steps_per_pass = passing.step_count();
  plan.steps = tugging.passes * (plan.steps_per_pass + 1);
  plan.twin =
      is_mirrored(tugging, passing.start(0), cells, dx) ? elastoplastic::Twin::mirror_image : elastoplastic::Twin::none;
  plan.scales = {yield_interference(tugging), tugging.interference};
  plan.shift = 0.5 * cells * dx;
  plan.start_distance = passing.start_distance();
  plan.memory_bytes = memory_bytes(plan, tugging.lower.material.is_plastic(), tugging.upper.material.is_plastic(),
                                   tugging.solver.anderson_depth);
  return plan;
}

} // namespace brinell::simulation
