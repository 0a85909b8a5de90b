// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

namespace brinell
{

/// Boundary of a grid along one axis. Open: beyond the grid the body continues with a smooth, unloaded surface. Periodic: the
/// surface repeats.
enum class Boundary
{
  open,
  periodic
};

/// Regular cell-centred grid of a surface; x runs fastest in memory: index = i + nx * j. Cell (i, j) is a rectangle dx * dy.
/// The grid does not store the position of its cell (0, 0); the owner of the grid does. Axes and signs: docs/theory/frame.md.
struct SurfaceGrid
{
  int nx = 0;      ///< cells along x (rolling or sliding direction)
  int ny = 0;      ///< cells along y
  double dx = 0.0; ///< cell size along x [m]
  double dy = 0.0; ///< cell size along y [m]
  Boundary boundary_x = Boundary::open;
  Boundary boundary_y = Boundary::open;
  /// Whether the two sides of the plane y = 0 in the middle of the grid, rows j and ny - 1 - j, are mirror images of each other.
  /// Then the rows up to the middle one determine all fields: docs/theory/half-space.md (symmetry).
  bool is_mirrored_y = false;

  [[nodiscard]] bool is_periodic_x() const { return boundary_x == Boundary::periodic; }
  [[nodiscard]] bool is_periodic_y() const { return boundary_y == Boundary::periodic; }
  /// Whether both axes are periodic: the grid is one period of bodies of infinite extent.
  [[nodiscard]] bool is_periodic() const { return is_periodic_x() && is_periodic_y(); }
  [[nodiscard]] std::size_t size() const { return static_cast<std::size_t>(nx) * static_cast<std::size_t>(ny); }
  /// Position of cell (i, j) in memory; 64 bits, like all counts of cells.
  [[nodiscard]] std::size_t index(int i, int j) const
  {
    return static_cast<std::size_t>(i) + static_cast<std::size_t>(nx) * static_cast<std::size_t>(j);
  }
  /// Coordinate of the centre of column i (row j), relative to the middle of the grid [m].
  [[nodiscard]] double x(int i) const { return (i - 0.5 * (nx - 1)) * dx; }
  [[nodiscard]] double y(int j) const { return (j - 0.5 * (ny - 1)) * dy; }
  [[nodiscard]] double cell_area() const { return dx * dy; }
  /// Number of rows, from the first one, that determine a field: those of one side and, if the number of rows is odd, the middle
  /// one.
  [[nodiscard]] int independent_rows() const { return is_mirrored_y ? (ny + 1) / 2 : ny; }
  [[nodiscard]] std::size_t independent_cells() const { return index(0, independent_rows()); }
  /// Number of rows that an independent row represents, including itself: 2, or 1 for the middle row and without mirror images.
  [[nodiscard]] int copies_of_row(int row) const { return !is_mirrored_y || 2 * row + 1 == ny ? 1 : 2; }
  /// The grid without the knowledge that its sides are mirror images.
  [[nodiscard]] SurfaceGrid whole() const
  {
    SurfaceGrid grid = *this;
    grid.is_mirrored_y = false;
    return grid;
  }
  bool operator==(const SurfaceGrid&) const = default;
};

/// Regular grid of cuboids dx * dy * dz under a surface. Layer k spans the depths [k dz, (k + 1) dz];
/// index = i + nx * (j + ny * k).
struct VolumeGrid
{
  SurfaceGrid surface;
  int nz = 0;      ///< layers
  double dz = 0.0; ///< layer thickness [m]

  [[nodiscard]] std::size_t size() const { return surface.size() * static_cast<std::size_t>(nz); }
  [[nodiscard]] std::size_t index(int i, int j, int k) const
  {
    return surface.index(i, j) + static_cast<std::size_t>(k) * surface.size();
  }
  [[nodiscard]] double cell_volume() const { return surface.cell_area() * dz; }
  bool operator==(const VolumeGrid&) const = default;
};

} // namespace brinell
