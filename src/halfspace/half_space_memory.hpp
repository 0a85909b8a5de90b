// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/grid.hpp"

namespace brinell::halfspace
{

/// What a HalfSpace on a grid takes [bytes].
struct MemoryOfHalfSpace
{
  double operators; ///< kernels and what takes off the images
  double work;      ///< of an evaluation (HalfSpace::Work)
  double trace;     ///< while the stress is computed for output, besides the work
};

/// @param shears  components of the shear on the surface, 0 to 2
[[nodiscard]] MemoryOfHalfSpace memory_of_half_space(const VolumeGrid& grid, int shears);

} // namespace brinell::halfspace
