// SPDX-License-Identifier: BSD-3-Clause
#include "entry_compliance.hpp"

#include "foundation/sharing.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace brinell::contact
{

namespace
{

/// Index along an axis; none beyond an open end.
std::optional<int> wrapped(int i, int count, bool is_periodic)
{
  if (is_periodic)
    return ((i % count) + count) % count;
  return i >= 0 && i < count ? std::optional(i) : std::nullopt;
}

} // namespace

EntryCompliance::EntryCompliance(const halfspace::SurfaceCompliance& pair)
    : grid_(pair.grid()), along_edge_(pair.along_over_across())
{
}

/// Unit vector across the edge of the contact beside a cell: that of the steepest pressure.
std::array<double, 2> EntryCompliance::across_edge(std::span<const double> pressure, int column, int row) const
{
  const auto at = [&](int i, int j)
  {
    const std::optional<int> x = wrapped(i, grid_.nx, grid_.is_periodic_x());
    const std::optional<int> y = wrapped(j, grid_.ny, grid_.is_periodic_y());
    return x && y ? pressure[grid_.index(*x, *y)] : 0.0;
  };
  const double x = (at(column + 1, row) - at(column - 1, row)) / grid_.dx;
  const double y = (at(column, row + 1) - at(column, row - 1)) / grid_.dy;
  const double size = std::hypot(x, y);
  return size > 0.0 ? std::array{x / size, y / size} : std::array{1.0, 0.0};
}

void EntryCompliance::find(const std::array<int, 2>& carried, std::span<const double> pressure_before,
                           std::span<const double> pressure, std::span<const double> gap)
{
  // Bodies that have not touched before are put down: nothing has rolled into the contact.
  const bool rolls = (carried[0] != 0 || carried[1] != 0) && sum(pressure_before) > 0.0;
  for (std::vector<double>& part : field_)
    part.assign(rolls ? grid_.size() : 0, 0.0);
  if (!rolls)
    return;
  for (int row = 0; row < grid_.ny; ++row)
    for (int column = 0; column < grid_.nx; ++column)
    {
      const std::size_t cell = grid_.index(column, row);
      const std::optional<int> x = wrapped(column - carried[0], grid_.nx, grid_.is_periodic_x());
      const std::optional<int> y = wrapped(row - carried[1], grid_.ny, grid_.is_periodic_y());
      if (!(pressure[cell] > 0.0) || pressure_before[cell] > 0.0 || !x || !y)
        continue;
      const std::size_t previous = grid_.index(*x, *y);
      if (pressure[previous] > 0.0)
        continue;
      const double free = std::max(0.0, gap[previous]) / pressure[cell];
      const auto [nx, ny] = across_edge(pressure, column, row);
      field_[0][cell] = free * (nx * nx + along_edge_ * ny * ny);
      field_[1][cell] = free * (ny * ny + along_edge_ * nx * nx);
      field_[2][cell] = free * (1.0 - along_edge_) * nx * ny;
    }
}

} // namespace brinell::contact
