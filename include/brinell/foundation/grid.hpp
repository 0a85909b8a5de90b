// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

namespace brinell
{

/// Regular cell-centred grid of a surface; x runs fastest in memory: index = i + nx * j. Cell (i, j) is a rectangle dx * dy.
/// The grid does not know where its cell (0, 0) lies: its owner does. Axes and signs: docs/theory/frame.md.
struct SurfaceGrid
{
  int nx = 0;      ///< cells along x (rolling or sliding direction)
  int ny = 0;      ///< cells along y
  double dx = 0.0; ///< cell size along x [m]
  double dy = 0.0; ///< cell size along y [m]

  [[nodiscard]] std::size_t size() const { return static_cast<std::size_t>(nx) * static_cast<std::size_t>(ny); }
  [[nodiscard]] double cell_area() const { return dx * dy; }
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
  [[nodiscard]] double cell_volume() const { return surface.cell_area() * dz; }
  bool operator==(const VolumeGrid&) const = default;
};

} // namespace brinell
