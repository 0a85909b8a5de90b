// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/input_lines.hpp"

#include <array>
#include <optional>
#include <string>

/// Contents of the comment lines before the heights of a text file, and of titles of columns.
/// @throws InputError that continues a sentence which begins with the file's name (all of this header)
namespace brinell::io
{

/// A value, and the line that holds it; none without a line.
struct HeaderEntry
{
  std::string value;
  const InputLine* line = nullptr;
  [[nodiscard]] bool is_there() const { return line != nullptr; }
};

struct HeightHeader
{
  HeaderEntry width, height;               ///< of the whole map: Gwyddion, and SPIP with the unit apart
  HeaderEntry x_unit, y_unit, height_unit; ///< of SPIP, of Gwyddion's lists of points, and of titles of columns
  HeaderEntry columns, rows;
  std::optional<std::array<double, 2>> spacing; ///< [m], as brinell writes it
  std::optional<double> x, y;                   ///< [m]
  std::optional<bool> periodic;
  bool has_titles = false; ///< x, y and z as titles of three columns

  [[nodiscard]] bool is_of_map() const { return width.is_there() || height.is_there(); }
};

/// Reads the comments before the heights, and titles of columns in the first other line or a comment.
/// @param [in,out] first  index of the first line that is no comment; moved behind titles of columns
[[nodiscard]] HeightHeader header_of(const InputLines& text, std::size_t& first);

/// The line that begins another map in the same file, as Gwyddion writes several; nullptr if there is none.
/// @param first  index of the first line of the heights
[[nodiscard]] const InputLine* second_map(const InputLines& text, std::size_t first);

/// Size of the unit of the heights [m], from the header or, if it has none, `given`; one of both has to say it, except for plain
/// rows of numbers, which are in m.
[[nodiscard]] double metres_of_heights(const InputLines& text, const HeightHeader& header,
                                       const std::optional<std::string>& given, bool is_points);

/// Size of the unit of the coordinates of points along x and y [m].
[[nodiscard]] std::array<double, 2> metres_of_coordinates(const InputLines& text, const HeightHeader& header,
                                                          const std::optional<std::string>& given);

/// Distances of the points of a map along x and y [m], if the header has them or the size of the map.
[[nodiscard]] std::optional<std::array<double, 2>> spacing_of(const InputLines& text, const HeightHeader& header,
                                                              std::size_t columns, std::size_t rows);

} // namespace brinell::io
