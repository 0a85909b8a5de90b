// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/grid.hpp"

#include <span>
#include <vector>

namespace brinell::elastoplastic
{

/// Where the contact grid lies on a material grid: contact column i is at column i + column + fraction.
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

/// Adds the depth of a body's surface, displacement and texture, to the cells of the contact grid above it. Between the columns
/// of the body it is interpolated (cubic, Lagrange); outside its grid it is zero, and a periodic grid goes on.
/// @param displacement  on the body's surface grid [m]
/// @param texture       likewise, or empty
/// @param out           on the contact grid, which has the same cells and rows [m]
void add_depth(const SurfaceGrid& body, std::span<const double> displacement, std::span<const double> texture,
               const Place& place, const SurfaceGrid& contact, std::span<double> out);

/// The way back, transposed, so that no work is lost in between: pressure or shear of the contact grid to the cells of a body.
/// @param out  on the body's surface grid; overwritten
/// @returns whether all of it lies on the body's grid; what does not is left out.
bool spread_traction(const SurfaceGrid& contact, std::span<const double> traction, const Place& place,
                     const SurfaceGrid& body, std::vector<double>& out);

/// Adds a depth in the cells of the contact grid, times a factor, to the cells of a body. Between the columns of the body it is
/// shared out linearly: the volume stays, and no cell gets less than nothing.
/// @param out  on the body's surface grid
/// @returns whether all of it lies on the body's grid; what does not is left out.
bool spread_volume(const SurfaceGrid& contact, std::span<const double> depth, double factor, const Place& place,
                   const SurfaceGrid& body, std::span<double> out);

/// Copies a field of a grid into the middle of a larger one.
void embed_field(const SurfaceGrid& small, std::span<const double> from, const SurfaceGrid& large,
                 std::span<double> to);

} // namespace brinell::elastoplastic
