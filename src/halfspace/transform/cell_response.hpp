// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/grid.hpp"
#include "brinell/foundation/sym_tensor.hpp"
#include "brinell/green/surface_terms.hpp"
#include "brinell/green/traction.hpp"

#include <array>
#include <cstdlib>
#include <vector>

/// Response of all cells to a unit traction on one cell, from the closed forms of rectangle and strip. Along a periodic axis
/// the cell has copies, one per period: the nearest ones are summed, and the rest is approximated by a strip:
/// docs/theory/half-space.md (copies).
namespace brinell::halfspace
{

/// Range of offsets between cells along one axis, in cells: those that occur on an open grid, or in one period.
class Offsets
{
public:
  Offsets(int cells, Boundary boundary) : cells_(cells), is_periodic_(boundary == Boundary::periodic) {}
  [[nodiscard]] int first() const { return is_periodic_ ? -(cells_ - 1) / 2 : 1 - cells_; }
  [[nodiscard]] int last() const { return is_periodic_ ? cells_ / 2 : cells_ - 1; }
  /// Sign of a function that is odd in the offset; at an offset of half a period such a function is zero.
  [[nodiscard]] double sign(int offset) const
  {
    return offset < 0 ? -1.0 : is_periodic_ && 2 * offset == cells_ ? 0.0 : 1.0;
  }

private:
  int cells_;
  bool is_periodic_;
};

/// A value for each pair of offsets along x and y; only offsets >= 0 are stored.
template <typename Value>
struct Quadrant
{
  int nx = 0, ny = 0;
  std::vector<Value> values;

  explicit Quadrant(const SurfaceGrid& grid)
      : nx(Offsets(grid.nx, grid.boundary_x).last() + 1), ny(Offsets(grid.ny, grid.boundary_y).last() + 1),
        values(static_cast<std::size_t>(nx) * static_cast<std::size_t>(ny))
  {
  }
  [[nodiscard]] Value& at(int i, int j) { return values[static_cast<std::size_t>(std::abs(i) + nx * std::abs(j))]; }
  [[nodiscard]] const Value& at(int i, int j) const
  {
    return values[static_cast<std::size_t>(std::abs(i) + nx * std::abs(j))];
  }
};

/// Integral of 1/r over the cell [m].
/// @param reference  with one periodic axis, the distance from a line load at which its displacement is taken as zero [m].
[[nodiscard]] Quadrant<double> cell_displacement(const SurfaceGrid& grid, double reference);

/// Integral over the cell of 1/R, and of depth/R^3, for points at a distance `depth` > 0 below the plane of the cell: the fields
/// of waves e^{-k depth} 2 pi / k and 2 pi e^{-k depth} [m, 1]. As smooth as the distance is large.
/// @param reference  as for `cell_displacement`
[[nodiscard]] Quadrant<std::array<double, 2>> buried_cell(const SurfaceGrid& grid, double depth, double reference);

/// Surface displacement by a unit traction on the cell, as `green::SurfaceTerms`.
/// @param reference  as for `cell_displacement`, for the displacements in all directions
[[nodiscard]] Quadrant<green::SurfaceTerms> cell_surface_terms(const SurfaceGrid& grid, double reference);

/// Stress at one depth by a unit traction on the cell [-].
[[nodiscard]] Quadrant<SymTensor> cell_stress(const SurfaceGrid& grid, double depth, double poisson_ratio,
                                              Traction traction);

} // namespace brinell::halfspace
