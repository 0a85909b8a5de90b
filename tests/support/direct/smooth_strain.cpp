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
        SymTensor eigenstrain = strain(x, y, layer);
        if (double_contraction(eigenstrain, eigenstrain) == 0.0)
          continue;
        const SymTensor east = strain(x + dx, y, layer), west = strain(x - dx, y, layer);
        const SymTensor north = strain(x, y + dy, layer), south = strain(x, y - dy, layer);
        for (std::size_t c = 0; c < 6; ++c) // undo the smearing by constant pieces, 1/24, and by three points, 1/27
          eigenstrain[c] -= 17.0 / 216.0 * (east[c] + west[c] + north[c] + south[c] - 4.0 * eigenstrain[c]);
        for (int p = 0; p < 27; ++p)
        {
          const auto g = static_cast<std::size_t>(p % 3);
          const SymTensor part = green::cuboid_stress_half_space(
              i * s.dx - x + (p / 3 % 3 - 1) * dx / 3.0, j * s.dy - y + (p / 9 - 1) * dy / 3.0,
              (k + 0.5 + gauss_point[g]) * grid.dz, (layer + 0.5) * grid.dz, dx, dy, grid.dz, eigenstrain, elastic);
          for (std::size_t c = 0; c < 6; ++c)
            sum[c] += gauss_weight[g] / 9.0 * part[c];
        }
      }
  return sum;
}

} // namespace brinell::direct
