// SPDX-License-Identifier: BSD-3-Clause
#include "direct/smooth_strain.hpp"

#include "brinell/green/cuboid.hpp"

#include <array>
#include <cmath>

namespace brinell::direct
{

SymTensor layered_strain_stress(const VolumeGrid& grid, const LayeredStrain& strain, int i, int j, int k, int parts,
                                const Elastic& elastic)
{
  const double root = std::sqrt(0.15);
  const std::array<double, 3> gauss_point{-root, 0.0, root};
  const std::array<double, 3> gauss_weight{5.0 / 18.0, 8.0 / 18.0, 5.0 / 18.0};
  const SurfaceGrid& s = grid.surface;
  const double dx = s.dx / parts;
  const double dy = s.dy / parts;
  SymTensor sum{};
  for (int layer = 0; layer < grid.nz; ++layer)
    for (int b = 0; b < parts * s.ny; ++b)
      for (int a = 0; a < parts * s.nx; ++a)
      {
        const double x = (a + 0.5) * dx - 0.5 * s.dx;
        const double y = (b + 0.5) * dy - 0.5 * s.dy;
        const SymTensor eigenstrain = strain(x, y, layer);
        if (double_contraction(eigenstrain, eigenstrain) == 0.0)
          continue;
        for (std::size_t g = 0; g < 3; ++g)
        {
          const SymTensor part =
              green::cuboid_stress_half_space(i * s.dx - x, j * s.dy - y, (k + 0.5 + gauss_point[g]) * grid.dz,
                                              (layer + 0.5) * grid.dz, dx, dy, grid.dz, eigenstrain, elastic);
          for (std::size_t c = 0; c < 6; ++c)
            sum[c] += gauss_weight[g] * part[c];
        }
      }
  return sum;
}

SymTensor extrapolated_strain_stress(const VolumeGrid& grid, const LayeredStrain& strain, int i, int j, int k,
                                     int parts, const Elastic& elastic)
{
  const int fewer = parts - 2;
  const SymTensor coarse = layered_strain_stress(grid, strain, i, j, k, fewer, elastic);
  SymTensor result = layered_strain_stress(grid, strain, i, j, k, parts, elastic);
  const double weight = fewer * fewer / static_cast<double>(parts * parts - fewer * fewer);
  for (std::size_t c = 0; c < 6; ++c)
    result[c] += weight * (result[c] - coarse[c]);
  return result;
}

} // namespace brinell::direct
