// SPDX-License-Identifier: BSD-3-Clause
#include "coverage.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>
#include <vector>

namespace brinell::simulation
{

namespace
{

/// Number of layers of a body from the first to the last one with a significant plastic strain.
int plastic_layers(const elastoplastic::Body& body)
{
  constexpr double counts = 0.01; // share of the largest strain; smaller ones are the rim of every plastic zone
  const std::vector<double> largest = body.largest_of_layers();
  if (largest.empty())
    return 0;
  const double limit = counts * *std::max_element(largest.begin(), largest.end());
  const auto holds = [limit](double value) { return value > limit; };
  const auto first = std::find_if(largest.begin(), largest.end(), holds);
  const auto last = std::find_if(largest.rbegin(), largest.rend(), holds);
  return first == largest.end() ? 0 : static_cast<int>(last.base() - first);
}

/// Pressure of the cell next to another one; 0 beyond an open boundary.
double pressure_beside(const SurfaceGrid& grid, std::span<const double> pressure, int i, int j, int di, int dj)
{
  i += di;
  j += dj;
  if ((i < 0 || i >= grid.nx) && !grid.is_periodic_x())
    return 0.0;
  if ((j < 0 || j >= grid.ny) && !grid.is_periodic_y())
    return 0.0;
  return pressure[grid.index((i + grid.nx) % grid.nx, (j + grid.ny) % grid.ny)];
}

/// Cells in contact, their extent, their ends along each axis, and the place of the largest pressure.
struct Patches
{
  int cells = 0;
  int columns = 0, rows = 0; ///< from the first to the last one with contact
  std::array<int, 2> ends{0, 0};
  int i = 0, j = 0;
  double largest = 0.0;
};

Patches patches_of(const SurfaceGrid& grid, std::span<const double> pressure)
{
  Patches p;
  int left = grid.nx, right = -1, front = grid.ny, back = -1;
  for (int j = 0; j < grid.ny; ++j)
  {
    const double* row = pressure.data() + grid.index(0, j);
    const double* next_row = row + grid.nx;
    if (j + 1 == grid.ny)
      next_row = grid.is_periodic_y() ? pressure.data() : nullptr;
    for (int i = 0; i < grid.nx; ++i)
    {
      const double here = row[i];
      if (!(here > 0.0))
        continue;
      ++p.cells;
      left = std::min(left, i);
      right = std::max(right, i);
      front = std::min(front, j);
      back = j;
      const double next = i + 1 < grid.nx ? row[i + 1] : grid.is_periodic_x() ? row[0] : 0.0;
      p.ends[0] += next > 0.0 ? 0 : 1;
      p.ends[1] += next_row != nullptr && next_row[i] > 0.0 ? 0 : 1;
      if (here > p.largest)
      {
        p.largest = here;
        p.i = i;
        p.j = j;
      }
    }
  }
  if (p.cells > 0)
  {
    p.columns = right - left + 1;
    p.rows = back - front + 1;
  }
  return p;
}

/// Coverage::patch_cells of the present state.
double patch_radius(const SurfaceGrid& grid, const Patches& p)
{
  constexpr double of_circle = 4.0 / std::numbers::pi;
  const auto half_chord = [&](int ends) { return 0.5 * p.cells / ends; };
  if (p.ends[1] == 0) // nothing ends along y
    return p.ends[0] > 0 ? half_chord(p.ends[0]) : 0.5 * grid.nx;
  if (p.ends[0] == 0)
    return half_chord(p.ends[1]);
  return of_circle * std::min(half_chord(p.ends[0]), half_chord(p.ends[1]));
}

/// Coverage::peak_cells of the present state: of a pressure p (1 - x^2/(2 n^2)) next to its peak.
double peak_radius(const SurfaceGrid& grid, std::span<const double> pressure, const Patches& p)
{
  const auto along = [&](int di, int dj)
  {
    const double beside =
        0.5 * (pressure_beside(grid, pressure, p.i, p.j, di, dj) + pressure_beside(grid, pressure, p.i, p.j, -di, -dj));
    return p.largest > beside ? std::sqrt(0.5 * p.largest / (p.largest - beside))
                              : std::numeric_limits<double>::infinity();
  };
  return std::min({along(1, 0), along(0, 1), static_cast<double>(std::max(grid.nx, grid.ny))});
}

/// Follows extent, patches and peak of pressure.
void extend_to_patches(Coverage& coverage, const SurfaceGrid& grid, std::span<const double> pressure)
{
  constexpr double grown = 1.25, like = 0.8; // of the largest contact so far
  const Patches p = patches_of(grid, pressure);
  coverage.contact_columns = std::max(coverage.contact_columns, p.columns);
  coverage.contact_rows = std::max(coverage.contact_rows, p.rows);
  if (p.cells == 0)
    return;
  if (p.cells > grown * coverage.largest_contact)
  {
    coverage.largest_contact = p.cells;
    coverage.patch_cells = patch_radius(grid, p);
  }
  else if (p.cells > like * coverage.largest_contact)
    coverage.patch_cells = std::min(coverage.patch_cells, patch_radius(grid, p));
  if (p.largest > coverage.largest_pressure)
  {
    coverage.largest_pressure = p.largest;
    coverage.peak_cells = peak_radius(grid, pressure, p);
  }
}

} // namespace

void extend(Coverage& coverage, const elastoplastic::CoupledContact& pair)
{
  extend_to_patches(coverage, pair.grid(), pair.pressure());
  // The body with the larger plastic strain has to be resolved.
  const bool lower_yields_more = pair.lower().solved().state().dissipation >= pair.upper().solved().state().dissipation;
  coverage.plastic_layers = plastic_layers(lower_yields_more ? pair.lower().solved() : pair.upper().solved());
}

} // namespace brinell::simulation
