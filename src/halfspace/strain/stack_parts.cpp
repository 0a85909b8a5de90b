// SPDX-License-Identifier: BSD-3-Clause
#include "stack_parts.hpp"

#include "brinell/foundation/error.hpp"
#include "brinell/halfspace/half_space.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace brinell::halfspace
{

std::vector<StackPart> stack_parts(const VolumeGrid& grid, const ElasticStack& stack)
{
  std::vector<StackPart> parts;
  double depth = 0.0;
  int first = 0;
  for (std::size_t layer = 0; layer <= stack.layers.size() && first < grid.nz; ++layer)
  {
    int end = grid.nz;
    if (layer < stack.layers.size())
    {
      depth += stack.layers[layer].thickness;
      end = std::min(end, static_cast<int>(std::lround(std::min(depth / grid.dz, 1.0 * grid.nz))));
    }
    if (end > first && !stack.of_layer(layer).is_rigid())
      parts.push_back({first, end, stack.of_layer(layer)});
    first = std::max(first, end);
  }
  return parts;
}

bool is_aligned(const VolumeGrid& grid, const ElasticStack& stack)
{
  constexpr double rounding = 1e-6; // of a layer of cells
  double depth = 0.0;
  for (const ElasticLayer& layer : stack.layers)
  {
    depth += layer.thickness;
    const double cells = depth / grid.dz;
    if (cells < grid.nz - rounding &&
        (std::abs(cells - std::round(cells)) > rounding || layer.thickness < 0.5 * grid.dz))
      return false;
  }
  return true;
}

void require_aligned(const VolumeGrid& grid, const ElasticStack& stack)
{
  if (is_aligned(grid, stack))
    return;
  double depth = 0.0;
  std::string depths;
  for (const ElasticLayer& layer : stack.layers)
    depths += fmt::format("{}{:.6g}", depths.empty() ? "" : ", ", depth += layer.thickness);
  const double first = stack.layers.front().thickness;
  throw InputError(fmt::format(
      "the layers of cells are {:.6g} m thick and the interfaces of the layered body at the depths {} m; allowed for "
      "plastic strain: cells that end at all interfaces, for example {:.6g} m thick for the first layer",
      grid.dz, depths, first / std::max(1.0, std::round(first / grid.dz))));
}

} // namespace brinell::halfspace
