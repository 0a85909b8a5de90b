// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/io/height_file.hpp"

#include "height_header.hpp"
#include "height_rows.hpp"
#include "io/npy.hpp"
#include "measured_files.hpp"
#include "point_list.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace brinell::io
{

namespace
{

/// A map narrower than this and longer than `long_list` is hardly ever meant by a file of few columns.
constexpr std::size_t long_list = 8;

/// Whether the lines are points. If this cannot be told, the error asks.
bool is_point_list(const NumberRows& table, const HeightHeader& header, HeightLayout layout)
{
  if (layout != HeightLayout::automatic)
    return layout == HeightLayout::points;
  if (header.has_titles)
    return true;
  if (header.is_of_map() || header.spacing)
    return false;
  constexpr std::size_t fewest = 4; // points of a grid
  if (table.columns == 3 && table.rows() >= fewest && begins_with_grid(table))
    return true;
  if (table.rows() < long_list)
    return false;
  if (table.columns == 3)
    throw InputError(
        fmt::format("has three columns: points x, y, z that are not on a grid of equal steps, or {} rows of "
                    "three heights? Say which, as layout = 'rows' or layout = 'points'",
                    table.rows()));
  if (table.columns == 4 && begins_with_grid(table))
    throw InputError(
        "has four columns, the first two of which are the places of a grid: if the lines are points, leave only "
        "x, y and z; if they are rows of four heights, say layout = 'rows'");
  if (table.columns == 2 && begins_with_steps(table))
    throw InputError(
        "has two columns, the first of which has equal steps: a profile x, z is no map; if the lines are rows of "
        "two heights, say layout = 'rows'");
  return false;
}

/// Counts the gaps of a map and names the first one.
/// @param row_name  "line 3" for a row counted from 0
template <typename RowName>
void find_gaps(const std::vector<double>& heights, std::size_t columns, const RowName& row_name, HeightFile& file)
{
  const auto is_gap = [](double height) { return !std::isfinite(height); };
  file.gaps = static_cast<std::size_t>(std::count_if(heights.begin(), heights.end(), is_gap));
  if (file.gaps == 0)
    return;
  const auto first = std::find_if(heights.begin(), heights.end(), is_gap);
  const auto at = static_cast<std::size_t>(first - heights.begin());
  file.first_gap =
      fmt::format("in {}, column {} a height that is not finite", row_name(at / columns), at % columns + 1);
}

void scale(std::vector<double>& heights, double factor)
{
  if (factor != 1.0)
    for (double& height : heights)
      height *= factor;
}

void take_points(const InputLines& text, const HeightHeader& header, const HeightFileOptions& options,
                 const NumberRows& table, HeightFile& file)
{
  PointGrid grid = point_grid(table);
  const auto metres = metres_of_coordinates(text, header, options.unit);
  file.spacing = std::array{grid.steps[0] * metres[0], grid.steps[1] * metres[1]};
  file.gaps = grid.gaps;
  file.first_gap = std::move(grid.first_gap);
  file.table = {std::move(grid.heights), grid.columns};
}

} // namespace

HeightLayout height_layout(std::string_view word)
{
  if (word == "rows")
    return HeightLayout::rows;
  if (word != "points")
    throw InputError(fmt::format("layout = '{}'; allowed: 'rows', 'points'", word));
  return HeightLayout::points;
}

HeightFile read_height_text(const std::filesystem::path& path, const HeightFileOptions& options)
try
{
  const InputLines text = input_lines(path);
  const auto is_content = [](const InputLine& line) { return !line.is_comment; };
  const auto content = std::find_if(text.lines.begin(), text.lines.end(), is_content);
  auto first = static_cast<std::size_t>(content - text.lines.begin());
  const HeightHeader header = header_of(text, first);
  if (first < text.lines.size() && !begins_as_row(text.lines[first].text))
    throw NoHeightText(fmt::format("begins in line {} with {}, no number", text.lines[first].number,
                                   text.quoted(text.lines[first].text)));
  if (const InputLine* const next = second_map(text, first))
    throw NoHeightText(
        fmt::format("holds several maps, the second from line {} on, {}", next->number, text.quoted(next->text)));
  NumberRows table = number_rows(text, first);
  HeightFile file;
  const bool is_points = is_point_list(table, header, options.layout);
  const double metres = metres_of_heights(text, header, options.unit, is_points);
  if (is_points)
    take_points(text, header, options, table, file);
  else
  {
    find_gaps(
        table.values, table.columns, [&](std::size_t row) { return fmt::format("line {}", table.lines[row]); }, file);
    file.spacing = spacing_of(text, header, table.columns, table.rows());
    file.table = {std::move(table.values), table.columns};
    file.x = header.x;
    file.y = header.y;
    file.periodic = header.periodic;
  }
  scale(file.table.heights, metres);
  return file;
}
catch (const NoText& error)
{
  throw NoHeightText(error.what());
}

HeightFile read_height_file(const std::filesystem::path& path, const HeightFileOptions& options)
{
  if (path.extension() != ".npy" && !is_npy(path))
    return read_height_text(path, options);
  HeightFile file;
  file.table = read_npy(path);
  find_gaps(
      file.table.heights, file.table.columns, [](std::size_t row) { return fmt::format("row {}", row + 1); }, file);
  const double metres = options.unit ? size_of_unit(*options.unit, dimension::length, "length, such as \"um\"") : 1.0;
  scale(file.table.heights, metres);
  return file;
}

std::string gap_text(const HeightFile& file)
{
  return fmt::format(
      "has {}{}; fill what was not measured, as \"brinell surface convert FILE OUT.npy --fill\" does by a "
      "smooth surface",
      file.first_gap, file.gaps > 1 ? fmt::format(", the first of {}", file.gaps) : "");
}

} // namespace brinell::io
