// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "foundation/lanes.hpp"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>

/// Range of cells where a field is not zero; work on the other cells can be skipped without changing any sum.
namespace brinell::halfspace
{

/// Columns [first_x, end_x) and rows [first_y, end_y) of a plane.
struct CellRectangle
{
  int first_x = 0, end_x = 0, first_y = 0, end_y = 0;
  [[nodiscard]] bool is_empty() const { return first_y == end_y; }
};

/// Whether any value is not zero; a NaN is not zero.
[[nodiscard]] inline bool has_nonzero(const double* values, int count)
{
  std::uint64_t bits = 0;
#pragma omp simd reduction(| : bits)
  for (int i = 0; i < count; ++i)
    bits |= std::bit_cast<std::uint64_t>(values[i]);
  return bits << 1U != 0; // all but the sign
}

/// Index of the first value that is not zero; `count` if there is none. Whole vectors of values are tested at a time.
[[nodiscard]] inline int first_nonzero(const double* values, int count)
{
  int i = 0;
  while (i + lane_count <= count && !has_nonzero(values + i, lane_count))
    i += lane_count;
  while (i < count && values[i] == 0.0)
    ++i;
  return i;
}

/// Index after the last nonzero value in [first, count); `first` if there is none.
[[nodiscard]] inline int end_of_nonzero(const double* values, int first, int count)
{
  int end = count;
  while (end - lane_count >= first && !has_nonzero(values + end - lane_count, lane_count))
    end -= lane_count;
  while (end > first && values[end - 1] == 0.0)
    --end;
  return end;
}

/// The smallest rectangle that contains all nonzero values of a plane. Each row is read from its beginning to the first nonzero
/// value, and from its end to the last one or to the rectangle found so far.
[[nodiscard]] inline CellRectangle used_cells(const double* plane, int nx, int rows)
{
  CellRectangle used{nx, 0, rows, 0};
  for (int j = 0; j < rows; ++j)
  {
    const double* row = plane + static_cast<std::ptrdiff_t>(j) * nx;
    const int first = first_nonzero(row, nx);
    if (first == nx)
      continue;
    used.first_y = std::min(used.first_y, j);
    used.end_y = j + 1;
    used.first_x = std::min(used.first_x, first);
    used.end_x = end_of_nonzero(row, used.end_x, nx);
  }
  return used.end_y == 0 ? CellRectangle{} : used;
}

} // namespace brinell::halfspace
