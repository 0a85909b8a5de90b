// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/grid.hpp"
#include "brinell/green/stack.hpp"

#include <vector>

namespace brinell::halfspace
{

/// The layers of cells [first, end) of one material.
struct StackPart
{
  int first = 0, end = 0;
  Elastic elastic;
};

/// Materials of the layers of cells, from the surface down, without a rigid base. An interface within a layer of cells is moved to its nearest boundary.
[[nodiscard]] std::vector<StackPart> stack_parts(const VolumeGrid& grid, const ElasticStack& stack);

} // namespace brinell::halfspace
