// SPDX-License-Identifier: BSD-3-Clause
#include "stack_lattice.hpp"

#include "foundation/fft.hpp"

#include <algorithm>

namespace brinell::halfspace
{

using std::numbers::pi;

double reach(const ElasticStack& stack)
{
  double softest = stack.substrate.is_rigid() ? stack.top().shear_modulus() : stack.substrate.shear_modulus();
  double hardest = softest, least = 1.0;
  for (const ElasticLayer& layer : stack.layers)
  {
    softest = std::min(softest, layer.elastic.shear_modulus());
    hardest = std::max(hardest, layer.elastic.shear_modulus());
    least = std::min(least, 1.0 - 2.0 * layer.elastic.poisson_ratio);
  }
  return stack.thickness() * hardest / (softest * std::sqrt(least));
}

namespace
{

int lattice_length(int cells, double cell, Boundary boundary, double distance)
{
  if (boundary == Boundary::periodic)
    return cells;
  constexpr int grids = 4, most = 1024;
  const int least = grids * cells;
  return fast_length(std::clamp(static_cast<int>(std::min(12.0 * distance / cell, 1e6)), least, std::max(least, most)));
}

/// Waves shorter than two cells matter where the first layer is thin compared with a cell: they decay as e^{-2kh}.
int folds(double cell, const ElasticStack& stack)
{
  constexpr int most = 4;
  return std::clamp(static_cast<int>(std::ceil(cell / stack.layers.front().thickness)), 1, most);
}

} // namespace

Lattice lattice_of(const SurfaceGrid& grid, const ElasticStack& stack)
{
  const double distance = reach(stack);
  return {lattice_length(grid.nx, grid.dx, grid.boundary_x, distance),
          lattice_length(grid.ny, grid.dy, grid.boundary_y, distance), folds(grid.dx, stack), folds(grid.dy, stack)};
}

double depth_of_forms(const SurfaceGrid& grid, const ElasticStack& stack)
{
  return std::max({stack.thickness(), grid.dx, grid.ny > 1 ? grid.dy : 0.0});
}

WaveRange range_of(const SurfaceGrid& grid, const Lattice& lattice)
{
  const double x = 2.0 * pi / (lattice.px * grid.dx), y = 2.0 * pi / (lattice.py * grid.dy);
  const double smallest = lattice.py == 1 ? x : lattice.px == 1 ? y : std::min(x, y);
  return {smallest,
          std::hypot((lattice.folds_x + 0.5) * 2.0 * pi / grid.dx, (lattice.folds_y + 0.5) * 2.0 * pi / grid.dy)};
}

LongWaves extrapolated(const std::array<double, 4>& f, double step)
{
  return {4.0 * f[0] - 6.0 * f[1] + 4.0 * f[2] - f[3],
          (-26.0 * f[0] + 57.0 * f[1] - 42.0 * f[2] + 11.0 * f[3]) / (6.0 * step)};
}

} // namespace brinell::halfspace
