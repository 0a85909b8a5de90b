// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/elastoplastic/active_cells.hpp"
#include "constitutive/lane_return.hpp"
#include "foundation/lane_functions.hpp"

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>

/// Loading and storing of active cells that are processed together, one per lane.
namespace brinell::elastoplastic
{

using LaneDeviators = constitutive::LanePoints::Deviators;

/// A run of cells that are neighbours within one layer of the grid and consecutive in the list of active cells.
struct LaneCells
{
  std::size_t a;     ///< index of the first one among the active cells
  std::size_t cell;  ///< index of the first one in the grid
  std::size_t count; ///< at most `lane_count`
};

/// Calls work(LaneCells) for runs that cover the active cells [first, last).
/// @param layer  number of cells in a layer
template <typename Work>
void for_lane_cells(std::span<const std::size_t> cells, std::size_t first, std::size_t last, std::size_t layer,
                    const Work& work)
{
  while (first < last)
  {
    const std::size_t cell = cells[first];
    const std::size_t most = std::min({static_cast<std::size_t>(lane_count), last - first, layer - cell % layer});
    std::size_t count = 1;
    while (count < most && cells[first + count] == cell + count)
      ++count;
    work(LaneCells{first, cell, count});
    first += count;
  }
}

/// Loads deviators from a field of the grid, stored component after component.
/// @param stride  number of cells of the grid
inline LaneDeviators load_deviators(const double* field, std::size_t stride, const LaneCells& at)
{
  LaneDeviators d;
  for (std::size_t c = 0; c < Deviator::size; ++c)
    d[c] = load_lanes(field + c * stride + at.cell, at.count);
  return d;
}
inline void store_deviators(const LaneDeviators& d, double* field, std::size_t stride, const LaneCells& at)
{
  for (std::size_t c = 0; c < Deviator::size; ++c)
    store_lanes(d[c], at.count, field + c * stride + at.cell);
}

namespace detail
{

/// Number of values of `count` packed deviators that lie in the register r.
inline std::size_t packed_in(std::size_t r, std::size_t count)
{
  const std::size_t all = Deviator::size * count, before = r * lane_count;
  return all <= before ? 0 : std::min(all - before, static_cast<std::size_t>(lane_count));
}

/// Lane `to` of the result is lane `from` of the vector number `of` among five.
struct Source
{
  int of, from;
};
/// Source in registers of packed deviators of the component c of the deviator in a lane.
constexpr Source packed_place(int c, int lane)
{
  const int place = Deviator::size * lane + c;
  return {place / lane_count, place % lane_count};
}
/// Inverse of `packed_place`: component (`of`) and lane (`from`) whose value belongs in a lane of the packed register r.
constexpr Source component_place(int r, int lane)
{
  const int place = lane_count * r + lane;
  return {place % Deviator::size, place / Deviator::size};
}

/// Gathers the vector number n of the result from five vectors.
/// @tparam place  function that maps (n, lane) to a Source
template <auto place, int n, int... lane>
Lanes gathered(const LaneDeviators& from, std::integer_sequence<int, lane...> /*all*/)
{
  static_assert(Deviator::size == 5);
  // Lanes whose source is not among the two vectors hold arbitrary values, which the next shuffles replace.
  const Lanes low =
      __builtin_shufflevector(from[0], from[1], (place(n, lane).from + (place(n, lane).of == 1 ? lane_count : 0))...);
  const Lanes high =
      __builtin_shufflevector(from[2], from[3], (place(n, lane).from + (place(n, lane).of == 3 ? lane_count : 0))...);
  const Lanes most = __builtin_shufflevector(low, high, (place(n, lane).of < 2 ? lane : lane + lane_count)...);
  return __builtin_shufflevector(most, from[4], (place(n, lane).of < 4 ? lane : place(n, lane).from + lane_count)...);
}

template <auto place>
LaneDeviators turned(const LaneDeviators& from)
{
  constexpr auto lanes = std::make_integer_sequence<int, lane_count>();
  return {gathered<place, 0>(from, lanes), gathered<place, 1>(from, lanes), gathered<place, 2>(from, lanes),
          gathered<place, 3>(from, lanes), gathered<place, 4>(from, lanes)};
}

} // namespace detail

/// Loads deviators that are packed, deviator after deviator.
inline LaneDeviators load_packed(const double* packed, const LaneCells& at)
{
  LaneDeviators values;
  packed += at.a * Deviator::size;
  if (at.count == lane_count)
    for (std::size_t r = 0; r < values.size(); ++r)
      values[r] = load_lanes(packed + r * lane_count);
  else
    for (std::size_t r = 0; r < values.size(); ++r)
      values[r] = load_lanes(packed + r * lane_count, detail::packed_in(r, at.count));
  return detail::turned<detail::packed_place>(values);
}
inline void store_packed(const LaneDeviators& d, double* packed, const LaneCells& at)
{
  const LaneDeviators values = detail::turned<detail::component_place>(d);
  for (std::size_t r = 0; r < values.size(); ++r)
    store_lanes(values[r], detail::packed_in(r, at.count), packed + at.a * Deviator::size + r * lane_count);
}

} // namespace brinell::elastoplastic
