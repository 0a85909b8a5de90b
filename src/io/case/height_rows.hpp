// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/input_lines.hpp"

#include <cstddef>
#include <string_view>
#include <vector>

/// Rows of numbers with gaps.
namespace brinell::io
{

/// Numbers of a text, row by row.
struct NumberRows
{
  std::vector<double> values; ///< NaN where a number is missing
  std::size_t columns = 0;
  std::vector<int> lines; ///< number of the line of each row

  [[nodiscard]] std::size_t rows() const { return lines.size(); }
  [[nodiscard]] double at(std::size_t row, std::size_t column) const { return values[row * columns + column]; }
};

/// Whether a line begins with a number or a gap, as rows of heights do.
[[nodiscard]] bool begins_as_row(std::string_view line);

/// Reads the lines from `first` on that are no comments.
/// @throws InputError, which continues a sentence that begins with the file's name, if rows have different lengths or a cell
/// contains something other than a number
[[nodiscard]] NumberRows number_rows(const InputLines& text, std::size_t first);

} // namespace brinell::io
