// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/contact/constriction.hpp"

#include "brinell/foundation/symmetry.hpp"
#include "foundation/nan.hpp"
#include "foundation/require_size.hpp"
#include "foundation/sharing.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace brinell::contact
{

namespace
{

/// Behaviour of the cells at an edge at which the density is singular, found with discs and strips of 3 to 500 cells
/// (docs/theory/electrical.md, edge).
struct EdgeRule
{
  double inset; ///< distance of the edge of the numerical solution within that of the cells [cell]
  double gain;  ///< gain of current by advance of the edge, over S (density)^2 (size of the cell)
};

/// @param by_waves  whether the density is a sum of waves, as on grids with two periods, and not constant in each cell
EdgeRule rule_of_edge(bool by_waves, bool is_straight)
{
  if (is_straight)
    return {by_waves ? 0.190 : 0.175, 0.865};
  return {by_waves ? 0.130 : 0.1156, by_waves ? 0.505 : 0.52};
}

/// Edge of a patch: the faces of its cells towards cells that are not in contact.
struct PatchEdge
{
  std::array<double, 2> faces{}; ///< length of those normal to x, and to y [m]
  double cells = 0.0;            ///< area of its cells [m^2]

  [[nodiscard]] bool is_straight() const { return faces[0] == 0.0 || faces[1] == 0.0; }
  [[nodiscard]] double length() const { return faces[0] + faces[1]; } ///< of the stairs
  /// Perimeter of the ellipse with the same faces (Ramanujan 1914), or of a strip.
  [[nodiscard]] double perimeter() const
  {
    const double a = faces[0] / 4.0, b = faces[1] / 4.0;
    return is_straight() ? length() : std::numbers::pi * (3.0 * (a + b) - std::sqrt((3.0 * a + b) * (a + 3.0 * b)));
  }
};

/// Calls visit(cell, axis) for each face between a cell of the area and one outside. At the end of an open grid there is no
/// contact beyond.
template <typename Visit>
void for_faces(const SurfaceGrid& grid, std::span<const double> area, const Visit& visit)
{
  const auto in_contact = [&](int i, int j)
  {
    if (grid.is_periodic_x())
      i = (i + grid.nx) % grid.nx;
    if (grid.is_periodic_y())
      j = (j + grid.ny) % grid.ny;
    return i >= 0 && j >= 0 && i < grid.nx && j < grid.ny && area[grid.index(i, j)] > 0.0;
  };
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i)
    {
      const std::size_t cell = grid.index(i, j);
      if (!(area[cell] > 0.0))
        continue;
      for (const int step : {-1, 1})
      {
        if (!in_contact(i + step, j))
          visit(cell, 0);
        if (!in_contact(i, j + step))
          visit(cell, 1);
      }
    }
}

} // namespace

std::vector<double> Flow::whole_density(double cell_area) const
{
  std::vector<double> of_cells(of_patch.size()), whole(density);
  for (std::size_t i = 0; i < whole.size(); ++i)
    if (patches.label[i] >= 0)
      of_cells[static_cast<std::size_t>(patches.label[i])] += density[i] * cell_area;
  for (std::size_t i = 0; i < whole.size(); ++i)
    if (patches.label[i] >= 0)
    {
      const auto patch = static_cast<std::size_t>(patches.label[i]);
      whole[i] *= of_patch[patch] / of_cells[patch];
    }
  return whole;
}

Constriction::Constriction(const halfspace::SurfaceCompliance& compliance, double modulus, double modulus_of_contact)
    : compliance_(compliance), scratch_(compliance.make_scratch()), modulus_(modulus),
      modulus_of_contact_(modulus_of_contact), punch_(compliance)
{
}

std::vector<double> Constriction::spread(std::span<const double> flux)
{
  const SurfaceGrid& grid = compliance_.grid();
  std::vector<double> potential(grid.size());
  compliance_.apply({.pressure = flux}, {.z = potential}, scratch_);
  for (double& value : potential)
    value *= 0.5 * modulus_;
  if (grid.is_mirrored_y)
    complete_in_y(grid, 1.0, potential.data(), potential.size());
  return potential;
}

Flow Constriction::flow(const Contact& contact, double spreading, std::span<const double> film,
                        std::vector<double> density)
{
  const SurfaceGrid& grid = compliance_.grid();
  if (!film.empty())
    require_size("Constriction::flow: the film", film, grid.size());
  Flow flow;
  flow.patches = patches(grid, contact.pressure, contact.gap, modulus_of_contact_);
  if (flow.patches.area.empty())
    return flow;
  const bool is_full = std::all_of(contact.pressure.begin(), contact.pressure.end(), [](double p) { return p > 0.0; });
  if (is_full && grid.is_periodic() && std::none_of(film.begin(), film.end(), [](double s) { return s > 0.0; }))
  {
    flow.conductance = std::numeric_limits<double>::infinity();
    return flow;
  }
  // As the pressure of a punch: (A + 2 film/(S E')) p = 1, with j = 2 p/(S E').
  const double scale = 2.0 / (spreading * modulus_);
  std::vector<double> layer(film.begin(), film.end());
  for (double& value : layer)
    value *= scale;
  if (density.size() != grid.size())
    density.assign(grid.size(), 0.0);
  for (double& value : density)
    value /= scale;
  const Punch::Report report = punch_.press(contact.pressure, std::vector<double>(grid.size(), 1.0), density, layer);
  for (double& value : density)
    value *= scale;
  flow.density = std::move(density);
  correct(flow, contact.pressure, spreading, film);
  if (!report.converged)
    flow.conductance = nan;
  return flow;
}

/// Sums the current of each patch, with the gain of current by the advance of its edge from where that of the numerical solution
/// lies to where that of the contact does.
void Constriction::correct(Flow& flow, std::span<const double> pressure, double spreading,
                           std::span<const double> film) const
{
  const SurfaceGrid& grid = compliance_.grid();
  const std::vector<int>& label = flow.patches.label;
  std::vector<PatchEdge> edges(flow.patches.area.size());
  flow.of_patch.assign(edges.size(), 0.0);
  for (std::size_t i = 0; i < label.size(); ++i)
    if (label[i] >= 0)
    {
      edges[static_cast<std::size_t>(label[i])].cells += grid.cell_area();
      flow.of_patch[static_cast<std::size_t>(label[i])] += flow.density[i] * grid.cell_area();
    }
  const std::array<double, 2> across{grid.dx, grid.dy};
  for_faces(grid, pressure,
            [&](std::size_t cell, std::size_t axis)
            { edges[static_cast<std::size_t>(label[cell])].faces[axis] += across[1 - axis]; });
  for_faces(grid, pressure,
            [&](std::size_t cell, std::size_t axis)
            {
              const auto patch = static_cast<std::size_t>(label[cell]);
              const PatchEdge& edge = edges[patch];
              const EdgeRule rule = rule_of_edge(grid.is_periodic(), edge.is_straight());
              const double beyond = (flow.patches.area[patch] - edge.cells) / edge.perimeter();
              const double singular = rule.gain * spreading * across[axis];
              const double regular = film.empty() ? 0.0 : film[cell] * edge.perimeter() / edge.length();
              flow.of_patch[patch] += std::pow(flow.density[cell], 2) * across[1 - axis] *
                                      ((singular + regular) * beyond + singular * rule.inset * across[axis]);
            });
  for (const double current : flow.of_patch)
    flow.conductance += current;
}

Constriction::Heat Constriction::heat(std::span<const double> pressure, std::span<const double> density,
                                      std::span<const double> source, const std::array<Conductor, 2>& bodies)
{
  // In each body T + phi^2/(2 rho k) is harmonic, with the flux q + phi j from the surface, phi the potential against the body far
  // away and q the heat that enters it: T = T_0 - phi^2/(2 rho k) + B (q + phi j)/k.
  const std::vector<double> potential = spread(density); // per resistivity
  const std::size_t cells = density.size();
  std::vector<double> generated(cells);
  for (std::size_t i = 0; i < cells; ++i)
    generated[i] = potential[i] * density[i];
  const std::vector<double> by_generated = spread(generated), by_source = spread(source);
  const auto [lower, upper] = bodies;
  const auto without_source = [&](const Conductor& body, std::size_t i)
  {
    return body.temperature +
           body.resistivity / body.conductivity * (by_generated[i] - 0.5 * std::pow(potential[i], 2));
  };
  // The heat that enters the lower body makes both temperatures equal: B q (1/k_1 + 1/k_2) = T_2 - T_1 without it.
  std::vector<double> difference(cells);
  for (std::size_t i = 0; i < cells; ++i)
    difference[i] = without_source(upper, i) + by_source[i] / upper.conductivity - without_source(lower, i);
  // Not from the last contact, which a run that goes on from a checkpoint does not know.
  heat_into_lower_.assign(cells, 0.0);
  const double scale = 0.5 * modulus_ * (1.0 / lower.conductivity + 1.0 / upper.conductivity);
  for (double& value : difference)
    value /= scale;
  punch_.press(pressure, difference, heat_into_lower_);
  const std::vector<double> by_heat = spread(heat_into_lower_);
  Heat result{std::vector<double>(cells), {std::vector<double>(cells), std::vector<double>(cells)}};
  for (std::size_t i = 0; i < cells; ++i)
  {
    if (pressure[i] > 0.0)
      result.temperature[i] = without_source(lower, i) + by_heat[i] / lower.conductivity;
    result.flux[0][i] = heat_into_lower_[i] + lower.resistivity * generated[i];
    result.flux[1][i] = source[i] - heat_into_lower_[i] + upper.resistivity * generated[i];
  }
  return result;
}

} // namespace brinell::contact
