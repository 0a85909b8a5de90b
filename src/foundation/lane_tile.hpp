// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "foundation/lane_functions.hpp"

#include <array>
#include <cstddef>

namespace brinell
{

/// A square of values, for example `lane_count` rows at as many neighbouring positions. Loops over a tile are unrolled,
/// so that it stays in registers.
using Tile = std::array<Lanes, lane_count>;

/// Step of a recursive transposition: exchanges the off-diagonal squares of `size` in each diagonal square of 2 * `size`.
template <int size>
[[gnu::always_inline]] inline void exchange_squares(Tile& t)
{
#pragma GCC unroll 8
  for (std::size_t i = 0; i < lane_count; ++i)
    if ((i & size) == 0)
    {
      const Lanes a = t[i], b = t[i + size];
      t[i] = shuffled(a, b, [](int lane) { return lane & size ? lane_count + lane - size : lane; });
      t[i + size] = shuffled(a, b, [](int lane) { return lane & size ? lane_count + lane : lane + size; });
    }
  if constexpr (2 * size < lane_count)
    exchange_squares<2 * size>(t);
}

/// Transposes a tile.
[[gnu::always_inline]] inline void transpose(Tile& t)
{
  exchange_squares<1>(t);
}

} // namespace brinell
