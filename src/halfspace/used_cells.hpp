// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>

/// Where a field is not zero, so that work on the rest can be left out without a change of any sum.
namespace brinell::halfspace
{

/// Columns [first_x, end_x) and rows [first_y, end_y) of a plane.
struct CellRectangle
{
  int first_x = 0, end_x = 0, first_y = 0, end_y = 0;
  [[nodiscard]] bool is_empty() const { return first_y == end_y; }
};

/// A NaN counts.
[[nodiscard]] inline bool has_nonzero(const double* values, int count)
{
  std::uint64_t bits = 0;
#pragma omp simd reduction(| : bits)
  for (int i = 0; i < count; ++i)
    bits |= std::bit_cast<std::uint64_t>(values[i]);
  return bits << 1U != 0; // all but the sign
}

/// The smallest rectangle that holds all values of a plane that are not zero. All are read, one after the other: that
/// also brings them into the cache.
[[nodiscard]] inline CellRectangle used_cells(const double* plane, int nx, int rows)
{
  CellRectangle used{nx, 0, rows, 0};
  for (int j = 0; j < rows; ++j)
  {
    const double* row = plane + static_cast<std::ptrdiff_t>(j) * nx;
    if (!has_nonzero(row, nx))
      continue;
    used.first_y = std::min(used.first_y, j);
    used.end_y = j + 1;
    used.first_x = static_cast<int>(std::find_if(row, row + used.first_x, [](double v) { return v != 0.0; }) - row);
    while (used.end_x < nx && has_nonzero(row + used.end_x, nx - used.end_x))
      ++used.end_x;
  }
  return used.end_y == 0 ? CellRectangle{} : used;
}

} // namespace brinell::halfspace
