// SPDX-License-Identifier: BSD-3-Clause
#include "cell_means.hpp"

#include "brinell/foundation/symmetry.hpp"

#include <utility>

namespace brinell::halfspace
{

namespace
{

constexpr double of_neighbour = 1.0 / 24.0;

/// Places and weights of the stencil around a place on an axis.
std::array<std::pair<int, double>, 3> stencil(int place, int count, bool is_periodic)
{
  const int before = place > 0 ? place - 1 : is_periodic ? count - 1 : place;
  const int after = place + 1 < count ? place + 1 : is_periodic ? 0 : place;
  return {{{before, of_neighbour}, {place, 1.0 - 2.0 * of_neighbour}, {after, of_neighbour}}};
}

} // namespace

CellMeans::CellMeans(const SurfaceGrid& grid, const std::vector<std::size_t>& cells) : neighbours_(cells.size())
{
  for (std::size_t c = 0; c < cells.size(); ++c)
  {
    const int column = static_cast<int>(cells[c] % static_cast<std::size_t>(grid.nx)),
              row = static_cast<int>(cells[c] / static_cast<std::size_t>(grid.nx)) % grid.ny;
    const std::size_t layer = cells[c] / grid.size() * grid.size();
    const bool has_image = grid.copies_of_row(row) == 2;
    std::size_t at = 0;
    for (const auto& [j, weight_y] : stencil(row, grid.ny, grid.is_periodic_y()))
      for (const auto& [i, weight_x] : stencil(column, grid.nx, grid.is_periodic_x()))
      {
        const double weight = weight_x * weight_y;
        const bool is_image = j >= grid.independent_rows(), is_middle = grid.copies_of_row(j) == 1 && has_image;
        Neighbour& n = neighbours_[c][at++];
        n.cell = layer + grid.index(i, is_image ? grid.ny - 1 - j : j);
        (is_image ? n.read_image : n.read) = weight;
        n.written = is_image ? 0.0 : weight;
        n.written_image = has_image && (is_image || is_middle) ? weight : 0.0;
      }
  }
}

double CellMeans::mean(const double* field, double parity, std::size_t i) const
{
  double sum = 0.0;
  for (const Neighbour& n : neighbours_[i])
    sum += (n.read + parity * n.read_image) * field[n.cell];
  return sum;
}

void CellMeans::spread(double value, double parity, std::size_t i, double* field) const
{
  for (const Neighbour& n : neighbours_[i])
    field[n.cell] += (n.written + parity * n.written_image) * value;
}

void CellMeans::clear(double* field) const
{
  for (const auto& of_cell : neighbours_)
    for (const Neighbour& n : of_cell)
      field[n.cell] = 0.0;
}

} // namespace brinell::halfspace
