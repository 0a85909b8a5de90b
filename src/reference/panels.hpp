// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "foundation/gauss.hpp"

#include <algorithm>
#include <cstddef>
#include <numbers>

namespace brinell::reference
{

/// Integral from 0 to `end` of a function that oscillates no faster than a Bessel function of x: calls add(x, weight) for the points
/// of a Gauss rule in panels of up to half a period.
/// @param first  width of the first panel, within which the function is smooth; each further one is twice as wide
template <class F>
void for_each_wave(double end, double first, F add)
{
  double from = 0.0, width = std::min(first, 0.25 * end);
  while (from < end)
  {
    const double to = from + width < (1.0 - 1e-12) * end ? from + width : end, half = 0.5 * (to - from);
    for (std::size_t i = 0; i < gauss_point.size(); ++i)
      for (const double side : {-1.0, 1.0})
        add(from + half * (1.0 + side * gauss_point[i]), half * gauss_weight[i]);
    from = to;
    width = std::min(2.0 * width, std::numbers::pi);
  }
}

} // namespace brinell::reference
