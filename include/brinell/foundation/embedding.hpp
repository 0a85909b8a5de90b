// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/field_table.hpp"
#include "brinell/foundation/grid.hpp"

#include <algorithm>
#include <span>
#include <string_view>

/// Fields of a grid on a larger one with the same centre.
namespace brinell
{

/// Copies a field of a grid into the centre of a larger one.
inline void embed_field(const SurfaceGrid& small, std::span<const double> from, const SurfaceGrid& large,
                        std::span<double> to)
{
  const int columns = (large.nx - small.nx) / 2;
  const int rows = (large.ny - small.ny) / 2;
  for (int j = 0; j < small.ny; ++j)
    std::copy_n(from.data() + small.index(0, j), small.nx, to.data() + large.index(columns, j + rows));
}

/// Takes over a state with fields on the surface from a smaller grid: all but what is derived from the rest.
template <typename State>
void embed_state(const SurfaceGrid& small, const State& from, const SurfaceGrid& large, State& to)
{
  for_parts(
      [&](std::string_view /*name*/, const Traits& traits, const auto& before, auto& now)
      {
        if (traits.is_derived)
          return;
        if constexpr (requires { before.size(); })
          embed_field(small, before, large, now);
        else
          now = before;
      },
      from, to);
}

} // namespace brinell
