// SPDX-License-Identifier: BSD-3-Clause
#include "body_parts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace brinell::elastoplastic
{

namespace
{

/// Equivalent plastic strain of the present trial in an active cell.
double equivalent_of(const BodyParts& b, std::size_t a)
{
  return b.state.equivalent[b.trial.active.cell(a)] + b.trial.active.equivalent(a);
}

/// Whether the plastic strain in some cells at the first or last place along an axis is likely to extend beyond it. Towards the
/// border of the plastic zone it falls from cell to cell by ever larger factors, so that the cell beyond the edge would hold less
/// than a geometric series through the cell at the edge and the one before it.
/// @param apart    distance between the indices of neighbouring cells along the axis
/// @param places   number of cells along the axis
/// @param largest  largest equivalent plastic strain
bool extends_beyond(const BodyParts& b, const std::vector<std::size_t>& cells, std::size_t apart, int places,
                    double largest)
{
  constexpr double tolerated = 1e-3;
  if (cells.empty() || places < 2)
    return !cells.empty();
  std::vector<double> equivalent = b.state.equivalent;
  for (std::size_t a = 0; a < b.trial.active.size(); ++a)
    equivalent[b.trial.active.cell(a)] = equivalent_of(b, a);
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
bool may_yield_below(const BodyParts& b)
{
  if (!b.share.has(b.whole.nz - 1))
    return false;
  const std::size_t n = b.grid.size();
  const auto last = static_cast<std::size_t>(b.grid.nz - 1);
  double weakest = b.yield.factor[last];
  double added = 0.0; // largest difference of the initial stress below the grid from that in the last layer [Pa]
  const double bottom = b.whole.nz * b.grid.dz;
  const double at_last =
      b.yield.factor[last] * constitutive::initial_yield_stress(b.yield.law_at(last * b.yield.cells_of_layer));
  double beneath =
      std::numeric_limits<double>::infinity(); // smallest initial yield stress below the grid without the factor
  const std::size_t reached = b.yield.material.stack().layer_at(bottom);
  for (std::size_t coat = reached; coat < b.yield.laws.size(); ++coat)
    beneath = std::min(beneath, constitutive::initial_yield_stress(b.yield.laws[coat]));
  for (const double z : b.yield.material.yield_factor.depth())
    if (z > bottom)
      weakest = std::min(weakest, b.yield.material.yield_factor.at(z, 1.0));
  for (const double z : b.yield.material.initial_stress.depth())
    if (z > bottom)
      added = std::max(added,
                       std::abs(b.yield.material.initial_stress.at(z, 0.0) - b.evaluation->initial_stress().at(last)));
  const double yield = weakest * beneath;
  if (yield >= at_last && added == 0.0)
    return false; // no layer below the grid yields before the last layer
  const std::size_t first = last * b.grid.surface.size();
  for (std::size_t cell = first; cell < first + b.grid.surface.independent_cells(); ++cell)
    if (von_mises(deviator_at(b.trial.stress, n, cell) - b.centre(cell)) > b.yield.softening_at(cell) * yield - added)
      return true;
  return false;
}

} // namespace

Edges Body::reached_edges() const
{
  const BodyParts& b = parts_;
  // A plastic strain at an edge that is smaller than this share of the largest one extends beyond the edge for one or two cells
  // at most; strains far below the yield strain have no effect.
  constexpr double tolerated = 0.01;
  constexpr double negligible = 1e-3;
  Edges edges;
  if (!b.is_plastic())
    return edges;
  double largest = b.zone.largest();
  for (std::size_t a = 0; a < b.trial.active.size(); ++a)
    largest = std::max(largest, equivalent_of(b, a));
  largest = b.ranks->largest(largest);
  const double limit =
      std::max(tolerated * largest, negligible * constitutive::initial_yield_stress(b.yield.material.law()) /
                                        b.yield.material.elastic.young_modulus);
  const SurfaceGrid& s = b.grid.surface;
  std::vector<std::size_t> at_ends, at_sides;
  for (std::size_t a = 0; a < b.trial.active.size(); ++a)
  {
    const std::size_t cell = b.trial.active.cell(a);
    if (b.trial.active.equivalent(a) <= 0.0 || equivalent_of(b, a) <= limit)
      continue;
    const std::size_t in_layer = cell % s.size();
    const int i = static_cast<int>(in_layer % static_cast<std::size_t>(s.nx));
    const int j = static_cast<int>(in_layer / static_cast<std::size_t>(s.nx));
    if (!s.is_periodic_x() && (i == 0 || i == s.nx - 1))
      at_ends.push_back(cell);
    if (!s.is_periodic_y() && (j == 0 || j == s.ny - 1))
      at_sides.push_back(cell);
    edges.bottom = edges.bottom || b.layer_of(cell) == b.whole.nz - 1;
  }
  edges.ends = b.ranks->any(extends_beyond(b, at_ends, 1, s.nx, largest));
  edges.sides = b.ranks->any(extends_beyond(b, at_sides, static_cast<std::size_t>(s.nx), s.ny, largest));
  edges.bottom = b.ranks->any(edges.bottom || may_yield_below(b));
  return edges;
}

} // namespace brinell::elastoplastic
