// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/grid.hpp"

namespace brinell::halfspace
{

/// Memory of a HalfSpace on a grid [bytes].
struct MemoryOfHalfSpace
{
  double operators; ///< kernels and image correction
  double work;      ///< of an evaluation (HalfSpace::Work)
  double trace;     ///< in addition to `work`, while the stress is computed for output
};

/// @param shears  number of components of the shear on the surface, 0 to 2
[[nodiscard]] MemoryOfHalfSpace memory_of_half_space(const VolumeGrid& grid, int shears);

} // namespace brinell::halfspace
