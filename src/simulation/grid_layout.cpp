// SPDX-License-Identifier: BSD-3-Clause
#include "grid_layout.hpp"

#include "brinell/foundation/error.hpp"
#include "foundation/fft.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <tuple>

namespace brinell::simulation
{

namespace
{

/// Half-width in whole cells around a central one that covers `length`.
int half_cells(double length, double cell)
{
  return std::max(2, static_cast<int>(std::ceil(length / cell - 0.5 - 1e-9)));
}

int odd_cells(double half_length, double cell, int margin = 0)
{
  return 2 * (half_cells(half_length, cell) + margin) + 1;
}

/// Real padded planes of all layers [bytes].
double padded_bytes(const VolumeGrid& grid)
{
  const PaddedLengths padded = padded_lengths(grid.surface);
  return static_cast<double>(padded.x) * padded.y * grid.nz * sizeof(double);
}

/// Spectra of fields, and their rows, which are transformed along x alone and have no padding along y.
double spectra_bytes(const VolumeGrid& grid, int components)
{
  return components * padded_bytes(grid) *
         (1.0 + static_cast<double>(grid.surface.ny) / padded_lengths(grid.surface).y);
}

double field_bytes(const VolumeGrid& grid, double fields)
{
  return fields * sizeof(double) * static_cast<double>(grid.size());
}

/// One body that is computed: kernels and state; if it is plastic, the trial, its spectra and the accelerator, too.
double body_bytes(const VolumeGrid& grid, int anderson_depth, bool is_plastic, int shears)
{
  // Six, real, a quarter of the plane each; of pressure, and of each shear.
  const double kernels = 6.0 * (1.0 + shears) / 4.0 * padded_bytes(grid);
  constexpr double state = 5.0 + 1.0 + 5.0; // plastic strain, its equivalent, stress
  if (!is_plastic)
    return kernels + field_bytes(grid, state);
  constexpr double trial = 5.0;
  // Of the cells in the fixed point: a plastic zone fills less of a box than of its section, in which it fills half; their
  // number is not known before, and packed fields grow by doubling.
  const double active_share = is_plane(grid.surface) ? 1.0 : 0.25;
  const double accelerator = active_share * 5.0 * (2.0 * anderson_depth + 4.0);
  return kernels + field_bytes(grid, state + trial + accelerator) + spectra_bytes(grid, 5);
}

/// The heat of a body, on a grid a third longer and wider than its own: some sixty waves in depth, on lattices that take
/// together three and a half times the first one; all of it twice, for when an increment fails; and stress, now and before.
double heat_bytes(const VolumeGrid& grid)
{
  constexpr double waves = 60.0, lattices = 3.5, copies = 2.0, wider = 4.0 / 3.0;
  SurfaceGrid surface = grid.surface;
  surface.nx = static_cast<int>(surface.is_periodic_x() ? surface.nx : wider * surface.nx);
  surface.ny = static_cast<int>(surface.is_periodic_y() ? surface.ny : wider * surface.ny);
  return waves * lattices * copies * padded_bytes({surface, 1, grid.dz}) + field_bytes(grid, 15.0);
}

/// The final state always is stored: tensors and equivalents of both bodies, the last of which come to be while the others are
/// there; or all of it as a file in memory, and as that file's image. The stress of a body that stays elastic takes spectra
/// for the time being.
double snapshot_bytes(const VolumeGrid& lower, const VolumeGrid& upper)
{
  const VolumeGrid& larger = lower.size() > upper.size() ? lower : upper;
  const double computed = spectra_bytes(larger, 6) + field_bytes(larger, 6.0);
  const double file = field_bytes(lower, 14.0) + field_bytes(upper, 14.0);
  return field_bytes(lower, 13.0) + field_bytes(upper, 13.0) + std::max(computed, 2.0 * file);
}

/// A copy of the state, as numbers, as a file in memory, and as that file's image.
double checkpoint_bytes(const VolumeGrid& grid, bool is_plastic)
{
  return is_plastic ? field_bytes(grid, 3.0 * 16.0) : 0.0;
}

/// Cells of a period, and what is left over.
double periods_cells(const Domain::Axis& axis, double spacing)
{
  return axis.cells > 0 ? axis.cells : axis.size / spacing;
}

/// The cell sizes of periodic axes, instead of those that the contact's size makes.
/// @param spacing_given  then the period must be a whole number of cells
void fit_periods(const Domain& domain, bool spacing_given, std::array<double, 3>& spacing)
{
  for (const auto& [name, axis, cell] :
       {std::tuple{"x", &domain.x, &spacing[0]}, std::tuple{"y", &domain.y, &spacing[1]}})
  {
    if (!axis->is_periodic())
      continue;
    const double cells = periods_cells(*axis, *cell);
    if (spacing_given && axis->cells == 0 && std::abs(cells - std::round(cells)) > 1e-6 * cells)
      throw KeyError("grid.size", fmt::format("grid.size = {:g} m along {} is {:.6g} cells of grid.spacing = {:g} m; "
                                              "allowed: a whole number of cells",
                                              axis->size, name, cells, *cell));
    *cell = axis->size / std::max(1.0, std::round(cells));
  }
}

int cells_in(const Domain::Axis& axis, double cell)
{
  return static_cast<int>(std::lround(axis.size / cell));
}

/// Whether the one row of a period has any length, as in plane strain.
bool is_one_row(const Domain& domain, double dy)
{
  return domain.y.is_periodic() && cells_in(domain.y, dy) == 1;
}

/// Thickness of the layers: as given, or half the smaller cell; half of dx where dy means nothing.
double layer_thickness(const Domain& domain, double dx, double dy)
{
  if (domain.layer > 0.0)
    return domain.layer;
  return 0.5 * (is_one_row(domain, dy) ? dx : std::min(dx, dy));
}

/// The ends of a cylinder have to be those of cells: an odd number of them around a row in the middle, an even one around the
/// middle of a period with an even number of rows.
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

std::array<double, 3> cell_sizes(const Numerics& numerics, const ContactSize& contact, double aspect)
{
  if (!(numerics.resolution > 0.0))
    throw KeyError("grid.resolution", fmt::format("grid.resolution = {:g}; allowed: > 0", numerics.resolution));
  if (!(numerics.extent > 0.0))
    throw KeyError("grid.extent", fmt::format("grid.extent = {:g}; allowed: > 0", numerics.extent));
  if (numerics.spacing &&
      !std::all_of(numerics.spacing->begin(), numerics.spacing->end(), [](double d) { return d > 0.0; }))
    throw KeyError("grid.spacing", "grid.spacing must be three lengths > 0");
  const double dx = contact.half_x / numerics.resolution;
  double dy = aspect * dx * std::clamp(contact.half_y / contact.half_x, 0.25, 4.0);
  if (contact.straight_y) // the length is a whole number of cells, one of them in the middle
    dy = 2.0 * contact.half_y / (2.0 * std::round(contact.half_y / dy - 0.5) + 1.0);
  std::array<double, 3> spacing = numerics.spacing.value_or(std::array{dx, dy, 0.0});
  fit_periods(numerics.domain, numerics.spacing.has_value(), spacing);
  if (!numerics.spacing)
    spacing[2] = layer_thickness(numerics.domain, spacing[0], spacing[1]);
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

void lay_out(const std::array<double, 3>& cells, const Extents& extents, const Domain& domain, Plan& plan)
{
  const auto [dx, dy, dz] = cells;
  constexpr int margin = 4;          // cells: material pushed ahead
  constexpr double most_cells = 2e9; // beyond it indices would overflow; far beyond any machine
  const auto half_length = [](const Domain::Axis& axis, double extent)
  { return axis.is_periodic() ? 0.5 * axis.size : extent; };
  const double longest = half_length(domain.x, std::max({extents.contact_x, extents.lower_x, extents.upper_x}));
  const double widest = half_length(domain.y, extents.contact_y);
  const double count = 4.0 * longest / dx * (widest / dy) * (extents.depth / dz);
  if (!(count < most_cells))
    throw GridError(fmt::format("grid: {:.1e} cells for a track of {:.3g} x {:.3g} m with a plastic zone of {:.3g} m; "
                                "allowed: fewer than {:.0e}, so larger cells or a shorter track",
                                count, 2.0 * longest, 2.0 * widest, extents.depth, most_cells));
  const auto cells_along = [](const Domain::Axis& axis, double extent, double cell, int more)
  { return axis.is_periodic() ? cells_in(axis, cell) : odd_cells(extent, cell, more); };
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
    grid->nz = std::max(2, static_cast<int>(std::ceil(extents.depth / dz - 1e-9)));
    grid->dz = dz;
  }
}

int grown(int cells)
{
  return 2 * static_cast<int>(std::ceil(cells / 6.0 + 1.0)) + cells;
}

int step_count(double steps, const std::string& key)
{
  constexpr double most = 1e9;
  if (!(steps >= 1.0 && steps <= most))
    throw KeyError(key, fmt::format("{} makes {:.1e} steps; allowed: from 1 to {:.0e}", key, steps, most));
  return static_cast<int>(steps);
}

double memory_bytes(const Plan& plan, bool lower_is_plastic, bool upper_is_plastic, int anderson_depth, int shears,
                    bool lower_is_heated, bool upper_is_heated)
{
  const bool has_twin = plan.twin != elastoplastic::Twin::none; // then the upper body is a view of the lower one
  const double upper = has_twin ? 0.0 : body_bytes(plan.upper, anderson_depth, upper_is_plastic, shears);
  const double heat =
      (lower_is_heated ? heat_bytes(plan.lower) : 0.0) + (upper_is_heated && !has_twin ? heat_bytes(plan.upper) : 0.0);
  return body_bytes(plan.lower, anderson_depth, lower_is_plastic, shears) + upper + heat +
         std::max(snapshot_bytes(plan.lower, plan.upper),
                  checkpoint_bytes(plan.lower, lower_is_plastic) +
                      checkpoint_bytes(plan.upper, upper_is_plastic && !has_twin));
}

} // namespace brinell::simulation
