// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "height_rows.hpp"

#include <array>
#include <optional>
#include <string>

/// Lists of points x, y, z that form a grid.
namespace brinell::io
{

/// A map made of points, row by row along x, rows in the order of y.
struct PointGrid
{
  std::vector<double> heights; ///< NaN where there is no point, or one without a height
  std::size_t columns = 0;
  std::array<double, 2> steps{}; ///< distances along x and y, in the unit of the coordinates
  std::size_t gaps = 0;
  std::string first_gap;
};

/// Orders points on the grid that their coordinates form; in the file they may have any order.
/// @param table  three columns: x, y, z
/// @throws InputError, which continues a sentence that begins with the file's name, if they form none, or if a point is
/// there twice
[[nodiscard]] PointGrid point_grid(const NumberRows& table);

/// Whether the first two columns are coordinates of a grid that is at least half full.
[[nodiscard]] bool begins_with_grid(const NumberRows& table);

/// Whether the first column rises or falls by equal steps.
[[nodiscard]] bool begins_with_steps(const NumberRows& table);

} // namespace brinell::io
