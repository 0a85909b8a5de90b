// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/grid.hpp"

namespace brinell::test
{

/// The grid with both sides of y = 0 as mirror images of each other, or not.
[[nodiscard]] inline SurfaceGrid mirrored(SurfaceGrid grid, bool is_mirrored = true)
{
  grid.is_mirrored_y = is_mirrored;
  return grid;
}
[[nodiscard]] inline VolumeGrid mirrored(VolumeGrid grid, bool is_mirrored = true)
{
  grid.surface.is_mirrored_y = is_mirrored;
  return grid;
}

} // namespace brinell::test
