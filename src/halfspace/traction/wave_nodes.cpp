// SPDX-License-Identifier: BSD-3-Clause
#include "foundation/gauss.hpp"
#include "wave_terms.hpp"

#include <algorithm>
#include <numbers>

namespace brinell::halfspace
{

/// From the longest waves on the intervals grow by a factor of two, up to one period of the wave at the distance.
WaveNodes::WaveNodes(const WaveScales& scales, double distance)
{
  const double longest = 2.0 * std::numbers::pi / std::max(distance, scales.decay);
  for (double low = 0.0, high = scales.smallest(); low < scales.largest(); low = high, high += std::min(high, longest))
    for (std::size_t g = 0; g < gauss_point.size(); ++g)
      for (const double side : {-1.0, 1.0})
      {
        k.push_back(0.5 * (low + high) + side * 0.5 * (high - low) * gauss_point[g]);
        weight.push_back(0.5 * (high - low) * gauss_weight[g]);
      }
}

} // namespace brinell::halfspace
