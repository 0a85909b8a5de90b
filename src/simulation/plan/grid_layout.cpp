// SPDX-License-Identifier: BSD-3-Clause
#include "grid_layout.hpp"

#include "brinell/foundation/error.hpp"
#include "brinell/halfspace/half_space.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <tuple>
#include <vector>

namespace brinell::simulation
{

namespace
{

/// Number of cells on either side of a central cell that cover a half-length.
int half_cells(double length, double cell)
{
  return std::max(2, static_cast<int>(std::ceil(length / cell - 0.5 - 1e-9)));
}

int odd_cells(double half_length, double cell, int margin = 0)
{
  return 2 * (half_cells(half_length, cell) + margin) + 1;
}

/// Number of cells of a period, and the remainder.
double periods_cells(const Domain::Axis& axis, double spacing)
{
  return axis.cells > 0 ? axis.cells : axis.size / spacing;
}

/// Adapts the cell sizes to the periods of periodic axes.
/// @param spacing_given  whether the cells are given, so that the period must be a whole number of them
void fit_periods(const Domain& domain, bool spacing_given, std::array<double, 3>& spacing)
{
  for (const auto& [name, axis, cell] :
       {std::tuple{"x", &domain.x, &spacing[0]}, std::tuple{"y", &domain.y, &spacing[1]}})
  {
    if (!axis->is_periodic())
      continue;
    const double cells = periods_cells(*axis, *cell);
    if (spacing_given && axis->cells == 0 && std::abs(cells - std::round(cells)) > 1e-6 * cells)
      throw PlanError("`Domain::size` = {:g} m along {} is {:.6g} cells of `Numerics::spacing` = {:g} m; "
                      "allowed: a whole number of cells",
                      axis->size, name, cells, *cell);
    *cell = axis->size / std::max(1.0, std::round(cells));
  }
}

/// Whether dx follows from a resolution.
bool chooses_dx(const Numerics& numerics)
{
  return !numerics.spacing && !numerics.domain.x.is_periodic();
}

/// The least whole number, but for rounding, that is not below a value; at least one.
double whole_above(double value)
{
  constexpr double rounding = 1e-9;
  return std::max(1.0, std::ceil(value - rounding));
}

/// Cell sizes with which a way is an even number of cells along x: dx becomes shorter, unless the case gives the cells or a
/// period determines them. dy and the layers stay.
std::array<double, 3> fitted_to_way(const Numerics& numerics, std::array<double, 3> cells, double way)
{
  if (chooses_dx(numerics))
    cells[0] = way / (2.0 * whole_above(way / (2.0 * cells[0])));
  return cells;
}

/// Cell sizes of which a shift is a whole number along x, likewise; not of a shift that is shorter than half of a cell, for which
/// they would become much finer than the resolution. The first runs of a series have cells twice as large.
std::array<double, 3> fitted_to_shift(const Numerics& numerics, std::array<double, 3> cells, double shift)
{
  constexpr double shortest = 0.5 * (1.0 - 1e-4); // of a cell
  if (chooses_dx(numerics) && shift >= shortest * cells[0])
    cells[0] = shift / whole_above(shift / cells[0]);
  return cells;
}

int cells_in(const Domain::Axis& axis, double cell)
{
  return static_cast<int>(std::lround(axis.size / cell));
}

/// Whether the length of the single row of a period is arbitrary, as in plane strain.
bool is_one_row(const Domain& domain, double dy)
{
  return domain.y.is_periodic() && cells_in(domain.y, dy) == 1;
}

/// Thickness of the layers: as given, or half the smaller cell size; half of dx if dy is arbitrary.
double layer_thickness(const Domain& domain, double dx, double dy)
{
  if (domain.layer > 0.0)
    return domain.layer;
  return 0.5 * (is_one_row(domain, dy) ? dx : std::min(dx, dy));
}

/// Thickness of layers of cells that end at the interfaces of coated bodies that need it: the given one, or the next smaller one that
/// divides the uppermost coat. The given one where that would be less than a quarter of it.
double fitted_to_coats(const PairCase& pair, double dz)
{
  std::vector<ElasticStack> stacks;
  for (const ShapedBody* body : {&pair.lower, &pair.upper})
    if (needs_aligned_cells(*body))
      stacks.push_back(body->material.stack());
  if (stacks.empty())
    return dz;
  constexpr double finest = 0.25;
  constexpr int deep = 1 << 30; // all interfaces are within such a grid
  const double first = stacks.front().layers.front().thickness;
  for (double count = whole_above(first / dz); first / count >= finest * dz; ++count)
  {
    VolumeGrid grid{{}, deep, first / count};
    if (std::all_of(stacks.begin(), stacks.end(),
                    [&](const ElasticStack& stack) { return halfspace::is_aligned(grid, stack); }))
      return grid.dz;
  }
  return dz;
}

/// Adapts dy so that the ends of a cylinder coincide with edges of cells: the cylinder is an odd number of cells long if there is
/// a row in the middle, and an even number in a period with an even number of rows.
void require_ends_at_cells(const Domain& domain, double length, double dy)
{
  const bool is_even = domain.y.is_periodic() && cells_in(domain.y, dy) % 2 == 0;
  const double rows = length / dy;
  if (std::abs(std::remainder(rows - (is_even ? 0.0 : 1.0), 2.0)) > 1e-6 * rows)
    throw GridError(
        fmt::format("grid: the cylinder is {:.6g} cells of dy long; allowed: an {} whole number, so that its ends are "
                    "those of cells",
                    rows, is_even ? "even" : "odd"));
}

} // namespace

bool needs_aligned_cells(const ShapedBody& body)
{
  return !body.material.layers.empty() && (body.material.is_plastic() || body.fatigue);
}

std::array<double, 3> cell_sizes(const PairCase& pair, const ContactSize& contact, double aspect)
{
  const Numerics& numerics = pair;
  if (!(numerics.resolution > 0.0))
    throw PlanError("`Numerics::resolution` = {:g}; allowed: > 0", numerics.resolution);
  if (!(numerics.extent > 0.0))
    throw PlanError("`Numerics::extent` = {:g}; allowed: > 0", numerics.extent);
  if (numerics.spacing &&
      !std::all_of(numerics.spacing->begin(), numerics.spacing->end(), [](double d) { return d > 0.0; }))
    throw PlanError("`Numerics::spacing` must be three lengths > 0");
  const double dx = contact.half_x / numerics.resolution;
  double dy = aspect * dx * std::clamp(contact.half_y / contact.half_x, 0.25, 4.0);
  if (contact.straight_y) // the length is a whole number of cells, with one cell in the middle
    dy = 2.0 * contact.half_y / (2.0 * std::round(contact.half_y / dy - 0.5) + 1.0);
  std::array<double, 3> spacing = numerics.spacing.value_or(std::array{dx, dy, 0.0});
  fit_periods(numerics.domain, numerics.spacing.has_value(), spacing);
  if (!numerics.spacing)
    spacing[2] = layer_thickness(numerics.domain, spacing[0], spacing[1]);
  if (!numerics.spacing && !(numerics.domain.layer > 0.0))
    spacing[2] = fitted_to_coats(pair, spacing[2]);
  if (contact.straight_y && !is_one_row(numerics.domain, spacing[1]))
    require_ends_at_cells(numerics.domain, 2.0 * contact.half_y, spacing[1]);
  constexpr double most_cells = 1e5;
  const double finest = *std::min_element(spacing.begin(), spacing.end());
  const double longest =
      is_one_row(numerics.domain, spacing[1]) ? contact.half_x : std::max(contact.half_x, contact.half_y);
  if (!(longest / finest < most_cells))
    throw GridError(fmt::format("grid: cells of {:g} m are too small for a contact of {:g} m", finest, longest));
  return spacing;
}

StepsOnWay steps_on_way(const Numerics& numerics, const std::array<double, 3>& cells, const WantedShift& wanted,
                        double way, int multiple, const std::string& key)
{
  const std::optional<double>& shift = wanted.shift;
  StepsOnWay on_way{fitted_to_way(numerics, cells, way)};
  if (shift && !whole_cells(*shift, on_way.cells[0]))
    on_way.cells = !wanted.is_whole || whole_cells(*shift, cells[0]) ? cells : fitted_to_shift(numerics, cells, *shift);
  const double dx = on_way.cells[0];
  const std::optional<double> whole = whole_cells(shift.value_or(dx), dx);
  on_way.shift = whole ? *whole * dx : *shift;
  on_way.count = multiple * std::max(1, step_count(std::round(way / (multiple * on_way.shift)), key));
  if (!whole) // the surfaces are interpolated in any case
    on_way.shift = way / on_way.count;
  return on_way;
}

std::optional<double> whole_cells(double shift, double cell)
{
  constexpr double rounding = 1e-4; // of a shift that was written with four digits or more
  const double cells = shift / cell, whole = std::round(cells);
  return whole > 0.0 && std::abs(cells - whole) <= rounding * cells ? std::optional(whole) : std::nullopt;
}

void cover(const elastoplastic::HeatSource& source, Extents& e)
{
  const elastoplastic::SourceReach most = elastoplastic::reach(source);
  const double further = std::max(0.0, most.x - e.contact_x); // the track needs as much more on both bodies
  e.contact_x += further;
  e.lower_x += further;
  e.upper_x += further;
  e.contact_y = std::max(e.contact_y, most.y);
}

void lay_out(const std::array<double, 3>& cells, const Extents& extents, const Domain& domain, Plan& plan)
{
  const auto [dx, dy, dz] = cells;
  constexpr int margin = 4;          // further cells for material that is pushed ahead
  constexpr double most_cells = 2e9; // with more, indices would overflow; far beyond any machine
  const auto half_length = [](const Domain::Axis& axis, double extent)
  { return axis.is_periodic() ? 0.5 * axis.size : extent; };
  const double longest = half_length(domain.x, std::max({extents.contact_x, extents.lower_x, extents.upper_x}));
  const double widest = half_length(domain.y, extents.contact_y);
  const double count = 4.0 * longest / dx * (widest / dy) * (plan.surfaces_only ? 1.0 : extents.depth / dz);
  if (!(count < most_cells))
    throw GridError(fmt::format("grid: {:.1e} cells for a track of {:.3g} x {:.3g} m with a plastic zone of {:.3g} m; "
                                "allowed: fewer than {:.0e}, so larger cells or a shorter track",
                                count, 2.0 * longest, 2.0 * widest, extents.depth, most_cells));
  const auto cells_along = [](const Domain::Axis& axis, double extent, double cell, int more)
  { return axis.is_periodic() ? cells_in(axis, cell) : odd_cells(extent, cell, more); };
  plan.layers = std::max(2, static_cast<int>(std::ceil(extents.depth / dz - 1e-9)));
  plan.contact = {cells_along(domain.x, extents.contact_x, dx, 0),
                  cells_along(domain.y, extents.contact_y, dy, 0),
                  dx,
                  dy,
                  domain.x.boundary,
                  domain.y.boundary};
  for (const auto& [grid, extent] : {std::pair{&plan.lower, extents.lower_x}, {&plan.upper, extents.upper_x}})
  {
    grid->surface = plan.contact;
    grid->surface.nx = std::max(plan.contact.nx, cells_along(domain.x, extent, dx, margin));
    grid->nz = plan.surfaces_only ? 1 : plan.layers;
    grid->dz = dz;
  }
}

int grown(int cells)
{
  return 2 * static_cast<int>(std::ceil(cells / 6.0 + 1.0)) + cells;
}

int grown_by_heat(int rows)
{
  return 2 * static_cast<int>(std::ceil(rows / 12.0)) + rows;
}

int step_count(double steps, const std::string& member)
{
  constexpr double most = 1e9;
  if (!(steps >= 1.0 && steps <= most))
    throw PlanError("{} makes {:.1e} steps; allowed: from 1 to {:.0e}", member, steps, most);
  return static_cast<int>(steps);
}

} // namespace brinell::simulation
