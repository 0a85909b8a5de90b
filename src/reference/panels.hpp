// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "foundation/gauss.hpp"

#include <cmath>
#include <numbers>

namespace brinell::reference
{

/// Integral from 0 to `end` of a function that oscillates no faster than a Bessel function of x: calls add(x, weight) for the points
/// of a Gauss rule in panels of half a period, and of at least four panels.
template <class F>
void for_each_wave(double end, F add)
{
  const double panels = std::max(4.0, std::ceil(end / std::numbers::pi)), half = 0.5 * end / panels;
  for (double panel = 0.0; panel < panels; ++panel)
    for (std::size_t i = 0; i < gauss_point.size(); ++i)
      for (const double side : {-1.0, 1.0})
        add(half * (2.0 * panel + 1.0 + side * gauss_point[i]), half * gauss_weight[i]);
}

} // namespace brinell::reference
