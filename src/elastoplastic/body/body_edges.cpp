// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/elastoplastic/body.hpp"

#include <algorithm>
#include <cmath>

namespace brinell::elastoplastic
{

Edges Body::reached_edges() const
{
  // A plastic strain at an edge that is smaller than this share of the largest one extends beyond the edge for one or two cells
  // at most; strains far below the yield strain have no effect.
  constexpr double tolerated = 0.01;
  constexpr double negligible = 1e-3;
  Edges edges;
  if (!is_plastic())
    return edges;
  double largest = zone_.largest();
  for (std::size_t a = 0; a < active_.size(); ++a)
    largest = std::max(largest, equivalent_of_active(a));
  const double limit =
      std::max(tolerated * largest,
               negligible * constitutive::initial_yield_stress(*material_.hardening) / material_.elastic.young_modulus);
  const SurfaceGrid& s = grid().surface;
  std::vector<std::size_t> at_ends, at_sides;
  for (std::size_t a = 0; a < active_.size(); ++a)
  {
    const std::size_t cell = active_.cell(a);
    if (active_.equivalent(a) <= 0.0 || equivalent_of_active(a) <= limit)
      continue;
    const std::size_t in_layer = cell % s.size();
    const int i = static_cast<int>(in_layer % static_cast<std::size_t>(s.nx));
    const int j = static_cast<int>(in_layer / static_cast<std::size_t>(s.nx));
    if (!s.is_periodic_x() && (i == 0 || i == s.nx - 1))
      at_ends.push_back(cell);
    if (!s.is_periodic_y() && (j == 0 || j == s.ny - 1))
      at_sides.push_back(cell);
    edges.bottom = edges.bottom || static_cast<int>(layer_of(cell)) == grid().nz - 1;
  }
  edges.ends = extends_beyond(at_ends, 1, s.nx, largest);
  edges.sides = extends_beyond(at_sides, static_cast<std::size_t>(s.nx), s.ny, largest);
  edges.bottom = edges.bottom || may_yield_below();
  return edges;
}

/// Equivalent plastic strain of the present trial in an active cell.
double Body::equivalent_of_active(std::size_t a) const
{
  return state_.equivalent[active_.cell(a)] + active_.equivalent(a);
}

/// Whether the plastic strain in some cells at the first or last place along an axis is likely to extend beyond it. Towards the
/// border of the plastic zone it falls from cell to cell by ever larger factors, so that the cell beyond the edge would hold less
/// than a geometric series through the cell at the edge and the one before it.
/// @param apart    distance between the indices of neighbouring cells along the axis
/// @param places   number of cells along the axis
/// @param largest  largest equivalent plastic strain
bool Body::extends_beyond(const std::vector<std::size_t>& cells, std::size_t apart, int places, double largest) const
{
  constexpr double tolerated = 1e-3;
  if (cells.empty() || places < 2)
    return !cells.empty();
  std::vector<double> equivalent = state_.equivalent;
  for (std::size_t a = 0; a < active_.size(); ++a)
    equivalent[active_.cell(a)] = equivalent_of_active(a);
  return std::any_of(cells.begin(), cells.end(),
                     [&](std::size_t cell)
                     {
                       const bool is_first = cell / apart % static_cast<std::size_t>(places) == 0;
                       const double before = equivalent[is_first ? cell + apart : cell - apart];
                       return equivalent[cell] * equivalent[cell] > tolerated * largest * before;
                     });
}

/// Whether some layer below the grid is so weak that it would yield under the stress of the last layer of the grid. This is a
/// safe estimate: the grid is deeper than the place of the largest shear stress, so that below it the contact stress falls with
/// depth, and so does the temperature, hence the softening.
bool Body::may_yield_below() const
{
  const std::size_t n = grid().size();
  const auto last = static_cast<std::size_t>(grid().nz - 1);
  double weakest = yield_factor_[last];
  double added = 0.0; // largest difference of the initial stress below the grid from that in the last layer [Pa]
  const double bottom = grid().nz * grid().dz;
  for (const double z : material_.yield_factor.depth())
    if (z > bottom)
      weakest = std::min(weakest, material_.yield_factor.at(z, 1.0));
  for (const double z : material_.initial_stress.depth())
    if (z > bottom)
      added = std::max(added, std::abs(material_.initial_stress.at(z, 0.0) - initial_stress_[last]));
  if (weakest >= yield_factor_[last] && added == 0.0)
    return false; // no layer below the grid yields before the last layer
  const double yield = weakest * constitutive::initial_yield_stress(*material_.hardening);
  const std::size_t first = last * grid().surface.size();
  for (std::size_t cell = first; cell < first + independent_cells(); ++cell)
    if (von_mises(deviator_at(stress_, n, cell) - centre(cell)) > softening(cell) * yield - added)
      return true;
  return false;
}

} // namespace brinell::elastoplastic
