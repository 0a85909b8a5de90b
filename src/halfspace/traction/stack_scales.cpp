// SPDX-License-Identifier: BSD-3-Clause
#include "stack_scales.hpp"

#include <algorithm>
#include <cmath>

namespace brinell::halfspace
{

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

WaveScales surface_scales(const ElasticStack& stack)
{
  return {.decay = 2.0 * stack.layers.front().thickness, .reach = reach(stack)};
}

namespace
{

/// Largest length of a cell along an axis that is not a single row of uniform fields.
double cell_length(const SurfaceGrid& grid)
{
  const bool is_row = grid.ny == 1 && grid.is_periodic_y(), is_column = grid.nx == 1 && grid.is_periodic_x();
  return is_row ? grid.dx : is_column ? grid.dy : std::max(grid.dx, grid.dy);
}

} // namespace

WaveScales stress_scales(const VolumeGrid& grid, const ElasticStack& stack)
{
  constexpr double rounding = 1e-6; // of a layer of cells
  double decay = stack.layers.front().thickness, depth = 0.0;
  for (const ElasticLayer& layer : stack.layers)
  {
    depth += layer.thickness;
    const double cells = depth / grid.dz, above = std::floor(cells + rounding);
    if (cells - above > rounding && above < grid.nz)
      decay = std::min(decay, above * grid.dz);
  }
  const double least = 0.125 * cell_length(grid.surface);
  return {.decay = std::max(decay, least), .reach = reach(stack), .is_cut_off = decay < least};
}

} // namespace brinell::halfspace
