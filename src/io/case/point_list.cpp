// SPDX-License-Identifier: BSD-3-Clause
#include "point_list.hpp"

#include "brinell/foundation/error.hpp"
#include "foundation/nan.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace brinell::io
{

namespace
{

/// Equidistant coordinates.
struct Axis
{
  double first = 0.0, step = 0.0;
  std::size_t count = 1;

  [[nodiscard]] double at(std::size_t i) const { return first + static_cast<double>(i) * step; }
  [[nodiscard]] std::size_t index(double x) const
  {
    return count == 1 ? 0 : static_cast<std::size_t>(std::lround((x - first) / step));
  }
};

/// Coordinates are printed with a few digits: they may be off by this part of a step.
constexpr double slack = 0.1;

/// The axis with this number of steps through sorted coordinates, if none of them lies beside it.
std::optional<Axis> axis_through(const std::vector<double>& sorted, double steps)
{
  constexpr double most = 1e8; // points along an axis
  if (!(steps >= 1.0 && steps < most))
    return std::nullopt;
  const Axis axis{sorted.front(), (sorted.back() - sorted.front()) / steps, static_cast<std::size_t>(steps) + 1};
  const bool fits = std::all_of(sorted.begin(), sorted.end(),
                                [&](double x) { return std::abs(x - axis.at(axis.index(x))) <= slack * axis.step; });
  return fits ? std::optional(axis) : std::nullopt;
}

/// A coordinate and the number of points that have it.
struct GridLine
{
  double place = 0.0;
  std::size_t points = 0;
};

std::vector<GridLine> lines_of(const std::vector<double>& sorted)
{
  constexpr double rounding = 1e-9;
  const double range = sorted.back() - sorted.front();
  std::vector<GridLine> lines;
  for (const double x : sorted)
    if (lines.empty() || x - lines.back().place > rounding * range)
      lines.push_back({x, 1});
    else
      ++lines.back().points;
  return lines;
}

/// The axis of a column of coordinates; none if they are not equidistant. Coordinates that no point has are allowed.
std::optional<Axis> axis_of(const NumberRows& table, std::size_t column)
{
  std::vector<double> sorted;
  for (std::size_t i = 0; i < table.rows(); ++i)
    sorted.push_back(table.at(i, column));
  if (std::any_of(sorted.begin(), sorted.end(), [](double x) { return std::isnan(x); }))
    return std::nullopt;
  std::sort(sorted.begin(), sorted.end());
  const double range = sorted.back() - sorted.front();
  if (!(range > 0.0))
    return Axis{sorted.front(), 0.0, 1};
  const std::vector<GridLine> lines = lines_of(sorted);
  sorted.clear();
  std::size_t most = 0;
  for (const GridLine& line : lines)
  {
    sorted.push_back(line.place);
    most = std::max(most, line.points);
  }
  if (const auto axis = axis_through(sorted, static_cast<double>(sorted.size() - 1)))
    return axis;
  // Whole lines may be missing. Those with few points do not count: a wrong coordinate makes no finer grid.
  double step = range;
  const GridLine* before = nullptr;
  for (const GridLine& line : lines)
    if (2 * line.points >= most)
    {
      step = before ? std::min(step, line.place - before->place) : step;
      before = &line;
    }
  return axis_through(sorted, std::round(range / step));
}

struct Grid
{
  Axis x, y;
  [[nodiscard]] std::size_t size() const { return x.count * y.count; }
};

/// The grid of the first two columns, if it is at least half full and has two points or more along both axes.
std::optional<Grid> grid_of(const NumberRows& table)
{
  const auto x = axis_of(table, 0), y = axis_of(table, 1);
  if (!x || !y || x->count < 2 || y->count < 2 || x->count > 2 * table.rows() || y->count > 2 * table.rows())
    return std::nullopt;
  const Grid grid{*x, *y};
  return grid.size() <= 2 * table.rows() ? std::optional(grid) : std::nullopt;
}

constexpr std::size_t none = static_cast<std::size_t>(-1);

/// Row of the table for each point of the grid, or none.
/// @param twice  receives the two rows of a point that is there twice
std::vector<std::size_t> rows_on(const Grid& grid, const NumberRows& table, std::array<std::size_t, 2>* twice)
{
  std::vector<std::size_t> rows(grid.size(), none);
  for (std::size_t i = 0; i < table.rows(); ++i)
  {
    std::size_t& row = rows[grid.y.index(table.at(i, 1)) * grid.x.count + grid.x.index(table.at(i, 0))];
    if (row != none && twice)
    {
      *twice = {row, i};
      return {};
    }
    row = i;
  }
  return rows;
}

} // namespace

PointGrid point_grid(const NumberRows& table)
{
  if (table.columns != 3)
    throw InputError(fmt::format("has {} columns; allowed: three, with x, y and z of a point per line", table.columns));
  const auto grid = grid_of(table);
  if (!grid)
    throw InputError(
        "has points x, y, z that are not on a grid of equal steps along x and y, or on less than half of its "
        "places; allowed: a grid");
  std::array<std::size_t, 2> twice{none, none};
  const auto rows = rows_on(*grid, table, &twice);
  if (twice[0] != none)
    throw InputError(fmt::format("has the point x = {:.6g}, y = {:.6g} twice, in line {} and line {}",
                                 table.at(twice[1], 0), table.at(twice[1], 1), table.lines[twice[0]],
                                 table.lines[twice[1]]));
  PointGrid result{.heights = {}, .columns = grid->x.count, .steps = {grid->x.step, grid->y.step}, .first_gap = {}};
  for (std::size_t k = 0; k < rows.size(); ++k)
  {
    const double height = rows[k] == none ? nan : table.at(rows[k], 2);
    if (std::isnan(height) && result.gaps++ == 0)
      result.first_gap = rows[k] == none ? fmt::format("at x = {:.6g}, y = {:.6g} no point",
                                                       grid->x.at(k % grid->x.count), grid->y.at(k / grid->x.count))
                                         : fmt::format("in line {} no height", table.lines[rows[k]]);
    result.heights.push_back(height);
  }
  return result;
}

bool begins_with_grid(const NumberRows& table)
{
  const auto grid = grid_of(table);
  std::array<std::size_t, 2> twice{none, none};
  return grid && !rows_on(*grid, table, &twice).empty();
}

bool begins_with_steps(const NumberRows& table)
{
  const auto axis = axis_of(table, 0);
  if (!axis || axis->count != table.rows())
    return false;
  const bool rises = table.at(0, 0) < table.at(1, 0);
  for (std::size_t i = 0; i < table.rows(); ++i)
    if (axis->index(table.at(i, 0)) != (rises ? i : table.rows() - 1 - i))
      return false;
  return true;
}

} // namespace brinell::io
