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

/// Copies fields of a body into the centre of a larger one, from the surface downwards. Values outside stay; they are 0 if there
/// were none before.
inline void embed_field(const VolumeGrid& small, std::span<const double> from, const VolumeGrid& large,
                        std::vector<double>& to)
{
  const std::size_t fields = from.size() / small.size();
  to.resize(fields * large.size());
  for (std::size_t field = 0; field < fields; ++field)
    for (int k = 0; k < small.nz; ++k)
      embed_field(small.surface, from.subspan(field * small.size() + small.index(0, 0, k)), large.surface,
                  std::span(to).subspan(field * large.size() + large.index(0, 0, k)));
}

/// Takes over a state from a smaller grid, all but what is derived from the rest.
template <typename State, typename Grid>
void embed_state(const Grid& small, const State& from, const Grid& large, State& to)
{
  for_parts(
      [&]<typename Part>(std::string_view /*name*/, const Traits& traits, const Part& before, Part& now)
      {
        if (traits.is_derived)
          return;
        if constexpr (std::is_arithmetic_v<Part>)
          now = before;
        else
          embed_field(small, before, large, now);
      },
      from, to);
}

} // namespace brinell
