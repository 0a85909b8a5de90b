// SPDX-License-Identifier: BSD-3-Clause
#include "stack_scales.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

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

WaveScales stress_scales(const ElasticStack& stack)
{
  return {.decay = stack.layers.front().thickness, .reach = reach(stack)};
}

std::vector<MaterialRange> materials_in(const ElasticStack& stack, double from, double to)
{
  constexpr double rounding = 1e-9; // of the range
  std::vector<MaterialRange> ranges;
  double top = 0.0;
  for (std::size_t material = 0; material <= stack.layers.size(); ++material)
  {
    const double bottom = material < stack.layers.size() ? top + stack.layers[material].thickness
                                                         : std::numeric_limits<double>::infinity();
    const double begin = std::max(from, top), end = std::min(to, bottom);
    if (end - begin > rounding * (to - from))
      ranges.push_back({material, begin, end});
    top = bottom;
  }
  return ranges;
}

} // namespace brinell::halfspace
