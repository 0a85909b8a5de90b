// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/grid.hpp"

#include <vector>

namespace brinell::halfspace
{

/// Replaces values at the middle of the cells of a plane by means over the cells, to the third order: (1, 22, 1)/24 along both axes. A
/// neighbour beyond an open edge has the value of the cell itself, so that the operator is symmetric.
/// @param copy  buffer
void mean_over_cells(const SurfaceGrid& s, double* values, std::vector<double>& copy);

} // namespace brinell::halfspace
