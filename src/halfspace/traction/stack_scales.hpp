// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/green/stack.hpp"
#include "wave_terms.hpp"

#include <vector>

namespace brinell::halfspace
{

/// Distance from which the body responds like its substrate [m]: a hard coating spreads the load, a soft one that hardly
/// changes its volume is squeezed slowly.
[[nodiscard]] double reach(const ElasticStack& stack);

/// Waves of the displacement of the surface, less those of a homogeneous body: they decay as e^{-2kh} with the thickness h of the
/// first layer.
[[nodiscard]] WaveScales surface_scales(const ElasticStack& stack);

/// Waves of the stress, less those of a homogeneous body with Poisson's ratio of the material in question: at the first interface they
/// decay as e^{-kh}.
[[nodiscard]] WaveScales stress_scales(const ElasticStack& stack);

/// Part of a range of depths in one material, 0 for the first one.
struct MaterialRange
{
  std::size_t material;
  double from, to; ///< [m]
};
/// The materials in a range of depths. An interface at its end is not cut by rounding.
[[nodiscard]] std::vector<MaterialRange> materials_in(const ElasticStack& stack, double from, double to);

} // namespace brinell::halfspace
