// SPDX-License-Identifier: BSD-3-Clause
#include "coarser_contact.hpp"

#include <algorithm>

namespace brinell::contact
{

CoarserContact::CoarserContact(const halfspace::SurfaceCompliance& fine)
    : cells_(fine.grid()), compliance_(fine.on(cells_.coarse())), contact_(compliance_),
      distance_(compliance_.grid().size()), pressure_(distance_.size()), gap_(distance_.size())
{
}

/// Pressure at a finer cell, interpolated between the larger cells around it; zero if the larger cell that contains it is not
/// under pressure, so that the contact does not become wider.
double CoarserContact::interpolated(int i, int j) const
{
  const std::array<CoarserCells::Neighbour, 4> around = cells_.around(i, j);
  if (pressure_[around.front().cell] <= 0.0)
    return 0.0;
  double value = 0.0;
  for (const CoarserCells::Neighbour& neighbour : around)
    value += neighbour.weight * pressure_[neighbour.cell];
  return value;
}

void CoarserContact::guess(std::span<const double> distance, const Drive& drive, double tolerance,
                           std::span<double> pressure, const std::function<bool()>& wants_stop)
{
  cells_.average(distance, distance_);
  std::fill(pressure_.begin(), pressure_.end(), 0.0);
  constexpr double rougher = 100.0; // looser tolerance: the discretisation error of the larger cells is larger anyway
  constexpr int most_iterations = 200;
  // The report is ignored: a guess need not have converged.
  (void)contact_.solve(distance_, drive, rougher * tolerance, most_iterations, pressure_, gap_, wants_stop);
  const SurfaceGrid& fine = cells_.fine();
  for (int j = 0; j < fine.ny; ++j)
    for (int i = 0; i < fine.nx; ++i)
      pressure[fine.index(i, j)] = interpolated(i, j);
}

} // namespace brinell::contact
