// SPDX-License-Identifier: BSD-3-Clause
#include "direct/half_space_sums.hpp"

#include "brinell/green/cuboid.hpp"
#include "brinell/green/rectangle.hpp"

#include <numbers>

namespace brinell::direct
{
namespace
{

struct Point
{
  double x, y, z;
};

/// Centre of a cell, relative to cell (0, 0) of the surface.
Point centre(const VolumeGrid& grid, std::size_t index)
{
  const auto nx = static_cast<std::size_t>(grid.surface.nx), ny = static_cast<std::size_t>(grid.surface.ny);
  return {static_cast<double>(index % nx) * grid.surface.dx, static_cast<double>(index / nx % ny) * grid.surface.dy,
          (static_cast<double>(index / nx / ny) + 0.5) * grid.dz};
}

Point centre(const SurfaceGrid& grid, std::size_t index)
{
  return centre(VolumeGrid{grid, 1, 0.0}, index);
}

void add(SymTensor& sum, double factor, const SymTensor& part)
{
  for (std::size_t c = 0; c < sum.size(); ++c)
    sum[c] += factor * part[c];
}

} // namespace

std::vector<double> pressure_to_displacement(const SurfaceGrid& grid, std::span<const double> pressure,
                                             double compliance)
{
  std::vector<double> displacement(grid.size());
  for (std::size_t i = 0; i < grid.size(); ++i)
    for (std::size_t j = 0; j < grid.size(); ++j)
    {
      const Point at = centre(grid, i), from = centre(grid, j);
      displacement[i] += compliance * std::numbers::inv_pi * pressure[j] *
                         green::rectangle_displacement(at.x - from.x, at.y - from.y, grid.dx, grid.dy);
    }
  return displacement;
}

std::vector<SymTensor> pressure_to_stress(const VolumeGrid& grid, std::span<const double> pressure,
                                          double poisson_ratio)
{
  const SurfaceGrid& s = grid.surface;
  std::vector<SymTensor> stress(grid.size(), SymTensor{});
  for (std::size_t i = 0; i < grid.size(); ++i)
    for (std::size_t j = 0; j < s.size(); ++j)
    {
      const Point at = centre(grid, i), from = centre(s, j);
      add(stress[i], pressure[j],
          green::rectangle_stress(at.x - from.x, at.y - from.y, at.z, s.dx, s.dy, poisson_ratio));
    }
  return stress;
}

std::vector<SymTensor> eigenstrain_to_stress(const VolumeGrid& grid, std::span<const SymTensor> eigenstrain,
                                             const Elastic& elastic)
{
  const SurfaceGrid& s = grid.surface;
  std::vector<SymTensor> stress(grid.size(), SymTensor{});
  for (std::size_t i = 0; i < grid.size(); ++i)
    for (std::size_t j = 0; j < grid.size(); ++j)
    {
      const Point at = centre(grid, i), from = centre(grid, j);
      add(stress[i], 1.0,
          green::cuboid_stress_half_space(at.x - from.x, at.y - from.y, at.z, from.z, s.dx, s.dy, grid.dz,
                                          eigenstrain[j], elastic));
    }
  return stress;
}

std::vector<double> eigenstrain_to_displacement(const VolumeGrid& grid, std::span<const SymTensor> eigenstrain,
                                                double poisson_ratio)
{
  const SurfaceGrid& s = grid.surface;
  std::vector<double> displacement(s.size());
  for (std::size_t i = 0; i < s.size(); ++i)
    for (std::size_t j = 0; j < grid.size(); ++j)
    {
      const Point at = centre(s, i), from = centre(grid, j);
      displacement[i] += green::cuboid_surface_displacement(at.x - from.x, at.y - from.y, from.z, s.dx, s.dy, grid.dz,
                                                            eigenstrain[j], poisson_ratio);
    }
  return displacement;
}

} // namespace brinell::direct
