// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/grid.hpp"
#include "brinell/green/stack.hpp"
#include "wave_terms.hpp"

namespace brinell::halfspace
{

/// Distance from which the body responds like its substrate [m]: a hard coating spreads the load, a soft one that hardly
/// changes its volume is squeezed slowly.
[[nodiscard]] double reach(const ElasticStack& stack);

/// Waves of the displacement of the surface, less those of a homogeneous body: they decay as e^{-2kh} with the thickness h of the
/// first layer.
[[nodiscard]] WaveScales surface_scales(const ElasticStack& stack);

/// Waves of the stress in layers of cells. At the first interface they decay as e^{-kh}. In a layer of cells that contains an interface
/// they decay more slowly, or not at all; they are cut off at an eighth of a cell.
[[nodiscard]] WaveScales stress_scales(const VolumeGrid& grid, const ElasticStack& stack);

} // namespace brinell::halfspace
