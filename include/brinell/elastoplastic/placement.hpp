// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/grid.hpp"

#include <span>
#include <vector>

namespace brinell::elastoplastic
{

/// Where the contact grid lies on a material grid: contact column i is at material column i + column + fraction.
struct Place
{
  int column = 0;
  double fraction = 0.0; ///< [0, 1)

  bool operator==(const Place&) const = default;
};

struct Placement
{
  Place lower, upper;
};

/// Adds the depth of a body's surface, displacement plus texture, to the cells of the contact grid above it. Between the columns
/// of the body the depth is interpolated (cubic, Lagrange); outside the grid it is zero, and a periodic grid is continued.
/// @param displacement  on the body's surface grid [m]
/// @param texture       on the body's surface grid [m], or empty
/// @param out           on the contact grid, which has the same cells and rows [m]
void add_depth(const SurfaceGrid& body, std::span<const double> displacement, std::span<const double> texture,
               const Place& place, const SurfaceGrid& contact, std::span<double> out);

/// Transfers a pressure or shear from the contact grid to the cells of a body. This is the transpose of the interpolation in
/// `add_depth`, so that the work of the traction is conserved.
/// @param out  on the body's surface grid; overwritten
/// @returns whether all of the traction lies on the body's grid; the part beyond is left out.
bool spread_traction(const SurfaceGrid& contact, std::span<const double> traction, const Place& place,
                     const SurfaceGrid& body, std::vector<double>& out);

/// Adds a depth in the cells of the contact grid, times a factor, to the cells of a body. The depth is distributed linearly
/// between the two nearest columns: this conserves volume and keeps the sign.
/// @param out  on the body's surface grid
/// @returns whether all of the depth lies on the body's grid; the part beyond is left out.
bool spread_volume(const SurfaceGrid& contact, std::span<const double> depth, double factor, const Place& place,
                   const SurfaceGrid& body, std::span<double> out);

} // namespace brinell::elastoplastic
