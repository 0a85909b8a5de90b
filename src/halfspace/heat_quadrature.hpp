// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/grid.hpp"
#include "brinell/halfspace/heat_response.hpp"

#include <vector>

namespace brinell::halfspace
{

/// One time before the end, with the weight of what has entered then.
struct PastTime
{
  double time = 0.0;   ///< [s]
  double weight = 0.0; ///< [s^(1/2)]; holds 1/sqrt(time)
};

/// A rule for integrals over the time before the end, from 0 to the duration, of f(t)/sqrt(t), where f is how cells spread as they
/// move: Gauss's rule in sqrt(t) on pieces that grow with the time, and end where an edge of the cell passes a point of the grid.
[[nodiscard]] std::vector<PastTime> past_times(const SurfaceGrid& grid, double diffusivity, const HeatMotion& motion);

} // namespace brinell::halfspace
