// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/grid.hpp"
#include "brinell/halfspace/heat_response.hpp"

#include <vector>

namespace brinell::halfspace
{

/// A node of the quadrature: a time before the end, with the weight of the heat that entered at that time.
struct PastTime
{
  double time = 0.0;   ///< [s]
  double weight = 0.0; ///< [s^(1/2)]; includes 1/sqrt(time)
};

/// Quadrature of f(t)/sqrt(t) over the time t before the end, from 0 to the duration, where f describes the spreading of the heat
/// of moving cells: Gauss quadrature in sqrt(t) on intervals that grow with the time, with ends where an edge of the cell passes
/// a point of the grid.
[[nodiscard]] std::vector<PastTime> past_times(const SurfaceGrid& grid, double diffusivity, const HeatMotion& motion);

} // namespace brinell::halfspace
