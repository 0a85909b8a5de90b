// SPDX-License-Identifier: BSD-3-Clause
#include "coarser_contact.hpp"

#include <algorithm>

namespace brinell::contact
{

namespace
{

/// Cells that cover two of the finer ones each; the last may stand out by one.
SurfaceGrid coarser(const SurfaceGrid& fine)
{
  return {(fine.nx + 1) / 2, (fine.ny + 1) / 2, 2.0 * fine.dx, 2.0 * fine.dy};
}

} // namespace

bool CoarserContact::helps(const SurfaceGrid& fine)
{
  constexpr int fewest = 48; // cells along an axis: below, an iteration is as cheap as what it takes to plan a grid
  return std::min(fine.nx, fine.ny) >= fewest;
}

CoarserContact::CoarserContact(const halfspace::SurfaceCompliance& fine)
    : fine_(fine.grid()), compliance_(fine.on(coarser(fine_))), contact_(compliance_),
      distance_(compliance_.grid().size()), pressure_(distance_.size()), gap_(distance_.size())
{
}

/// Pressure at a finer cell, whose middle is a quarter of a larger cell away from that of its own one; none where that one is
/// not pressed, so that the contact does not become wider.
double CoarserContact::interpolated(int i, int j) const
{
  const SurfaceGrid& g = compliance_.grid();
  const auto at = [&](int column, int row)
  {
    const bool is_inside = column >= 0 && column < g.nx && row >= 0 && row < g.ny;
    return is_inside ? pressure_[g.index(column, row)] : 0.0;
  };
  const int column = i / 2;
  const int row = j / 2;
  if (at(column, row) <= 0.0)
    return 0.0;
  const int beside = column + (i % 2 == 0 ? -1 : 1);
  const int before = row + (j % 2 == 0 ? -1 : 1);
  return (9.0 * at(column, row) + 3.0 * at(beside, row) + 3.0 * at(column, before) + at(beside, before)) / 16.0;
}

void CoarserContact::guess(std::span<const double> distance, const Drive& drive, double tolerance,
                           std::span<double> pressure, const std::function<bool()>& wants_stop)
{
  const SurfaceGrid& g = compliance_.grid();
  for (int row = 0; row < g.ny; ++row)
    for (int column = 0; column < g.nx; ++column)
    {
      double sum = 0.0;
      for (const int j : {2 * row, std::min(2 * row + 1, fine_.ny - 1)})
        for (const int i : {2 * column, std::min(2 * column + 1, fine_.nx - 1)})
          sum += distance[fine_.index(i, j)];
      distance_[g.index(column, row)] = 0.25 * sum;
    }
  std::fill(pressure_.begin(), pressure_.end(), 0.0);
  constexpr double rougher = 100.0; // the cells differ by more than that
  constexpr int most_iterations = 200;
  // A guess need not have converged.
  (void)contact_.solve(distance_, drive, rougher * tolerance, most_iterations, pressure_, gap_, wants_stop);
  for (int j = 0; j < fine_.ny; ++j)
    for (int i = 0; i < fine_.nx; ++i)
      pressure[fine_.index(i, j)] = interpolated(i, j);
}

} // namespace brinell::contact
