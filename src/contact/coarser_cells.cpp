// SPDX-License-Identifier: BSD-3-Clause
#include "coarser_cells.hpp"

#include <algorithm>
#include <cmath>

namespace brinell::contact
{

namespace
{

constexpr int fewest = 48; // cells along an axis: below, an iteration costs no more than planning a coarser grid

/// The grid of larger cells, with the same boundaries; along a periodic axis it has the same length as the finer grid.
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

bool CoarserCells::helps(const SurfaceGrid& fine)
{
  return std::max(fine.nx, fine.ny) >= fewest && fine.size() >= static_cast<std::size_t>(fewest) * fewest;
}

CoarserCells::CoarserCells(const SurfaceGrid& fine)
    : fine_(fine), x_(fine.nx, fine.boundary_x), y_(fine.ny, fine.boundary_y), coarse_(coarser(fine, x_, y_)),
      share_(coarse_.size(), 0.0)
{
  for (const CoarserAxis::Place& y : y_.places)
    for (const CoarserAxis::Place& x : x_.places)
      share_[coarse_.index(x.own, y.own)] += 1.0;
  for (double& share : share_)
    share = 1.0 / share;
}

void CoarserCells::average(std::span<const double> fine, std::span<double> coarse) const
{
  std::fill(coarse.begin(), coarse.end(), 0.0);
  for (std::size_t j = 0; j < y_.places.size(); ++j)
    for (std::size_t i = 0; i < x_.places.size(); ++i)
      coarse[coarse_.index(x_.places[i].own, y_.places[j].own)] +=
          fine[fine_.index(static_cast<int>(i), static_cast<int>(j))];
  for (std::size_t cell = 0; cell < coarse.size(); ++cell)
    coarse[cell] *= share_[cell];
}

std::array<CoarserCells::Neighbour, 4> CoarserCells::around(int i, int j) const
{
  const CoarserAxis::Place& x = x_.places[static_cast<std::size_t>(i)];
  const CoarserAxis::Place& y = y_.places[static_cast<std::size_t>(j)];
  const std::size_t own = coarse_.index(x.own, y.own);
  const auto at = [&](int column, int row, double weight)
  {
    const bool is_inside = column >= 0 && column < coarse_.nx && row >= 0 && row < coarse_.ny;
    return is_inside ? Neighbour{coarse_.index(column, row), weight} : Neighbour{own, 0.0};
  };
  return {at(x.own, y.own, (1.0 - x.share) * (1.0 - y.share)), at(x.beside, y.own, x.share * (1.0 - y.share)),
          at(x.own, y.beside, (1.0 - x.share) * y.share), at(x.beside, y.beside, x.share * y.share)};
}

} // namespace brinell::contact
