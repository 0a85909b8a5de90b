// SPDX-License-Identifier: BSD-3-Clause
#include "coarser_contact.hpp"

#include <algorithm>
#include <cmath>

namespace brinell::contact
{

namespace
{

constexpr int fewest = 48; // cells along an axis: below, an iteration is as cheap as what it takes to plan a grid

/// Larger cells, with the same boundaries: of a period, as long together as the finer ones.
SurfaceGrid coarser(const SurfaceGrid& fine, const CoarserAxis& x, const CoarserAxis& y)
{
  const auto cell = [](int count, double length, int larger, bool is_periodic) {
    return larger == count ? length : is_periodic ? length * count / larger : 2.0 * length;
  };
  return {x.cells,
          y.cells,
          cell(fine.nx, fine.dx, x.cells, fine.is_periodic_x()),
          cell(fine.ny, fine.dy, y.cells, fine.is_periodic_y()),
          fine.boundary_x,
          fine.boundary_y};
}

} // namespace

CoarserAxis::CoarserAxis(int fine, Boundary boundary) : cells(fine < fewest ? fine : (fine + 1) / 2)
{
  const bool is_periodic = boundary == Boundary::periodic;
  const double ratio = cells == fine ? 1.0 : is_periodic ? static_cast<double>(cells) / fine : 0.5;
  for (int i = 0; i < fine; ++i)
  {
    const double middle = (i + 0.5) * ratio; // in larger cells
    const int own = std::min(static_cast<int>(middle), cells - 1);
    const double away = middle - (own + 0.5);
    int beside = own + (away < 0.0 ? -1 : 1);
    if (is_periodic)
      beside = (beside + cells) % cells;
    places.push_back({own, beside, std::abs(away)});
  }
}

bool CoarserContact::helps(const SurfaceGrid& fine)
{
  return std::max(fine.nx, fine.ny) >= fewest && fine.size() >= static_cast<std::size_t>(fewest) * fewest;
}

CoarserContact::CoarserContact(const halfspace::SurfaceCompliance& fine)
    : fine_(fine.grid()), x_(fine_.nx, fine_.boundary_x), y_(fine_.ny, fine_.boundary_y),
      compliance_(fine.on(coarser(fine_, x_, y_))), contact_(compliance_), distance_(compliance_.grid().size()),
      pressure_(distance_.size()), gap_(distance_.size())
{
}

/// Pressure at a finer cell, between those of the larger cells around it; none where its own one is not pressed, so that the
/// contact does not become wider.
double CoarserContact::interpolated(int i, int j) const
{
  const SurfaceGrid& g = compliance_.grid();
  const auto at = [&](int column, int row)
  {
    const bool is_inside = column >= 0 && column < g.nx && row >= 0 && row < g.ny;
    return is_inside ? pressure_[g.index(column, row)] : 0.0;
  };
  const CoarserAxis::Place& x = x_.places[static_cast<std::size_t>(i)];
  const CoarserAxis::Place& y = y_.places[static_cast<std::size_t>(j)];
  if (at(x.own, y.own) <= 0.0)
    return 0.0;
  const auto along_row = [&](int row) { return (1.0 - x.share) * at(x.own, row) + x.share * at(x.beside, row); };
  return (1.0 - y.share) * along_row(y.own) + y.share * along_row(y.beside);
}

void CoarserContact::guess(std::span<const double> distance, const Drive& drive, double tolerance,
                           std::span<double> pressure, const std::function<bool()>& wants_stop)
{
  const SurfaceGrid& g = compliance_.grid();
  std::fill(distance_.begin(), distance_.end(), 0.0);
  std::fill(gap_.begin(), gap_.end(), 0.0); // how many finer cells lie on a larger one
  for (int j = 0; j < fine_.ny; ++j)
    for (int i = 0; i < fine_.nx; ++i)
    {
      const std::size_t own =
          g.index(x_.places[static_cast<std::size_t>(i)].own, y_.places[static_cast<std::size_t>(j)].own);
      distance_[own] += distance[fine_.index(i, j)];
      gap_[own] += 1.0;
    }
  for (std::size_t i = 0; i < distance_.size(); ++i)
    distance_[i] /= gap_[i];
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
