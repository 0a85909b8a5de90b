// SPDX-License-Identifier: BSD-3-Clause
#include "coverage.hpp"

#include <algorithm>
#include <span>

namespace brinell::simulation
{

namespace
{

/// Number of layers of a body from the first to the last one with a significant plastic strain.
int plastic_layers(const elastoplastic::Body& body)
{
  constexpr double counts = 0.01; // share of the largest strain; smaller ones are the rim of every plastic zone
  const std::span<const double> largest = body.plastic_zone().largest_of_layers();
  if (largest.empty())
    return 0;
  const double limit = counts * body.plastic_zone().largest();
  const auto holds = [limit](double value) { return value > limit; };
  const auto first = std::find_if(largest.begin(), largest.end(), holds);
  const auto last = std::find_if(largest.rbegin(), largest.rend(), holds);
  return first == largest.end() ? 0 : static_cast<int>(last.base() - first);
}

} // namespace

void extend(Coverage& coverage, const elastoplastic::CoupledContact& pair)
{
  const SurfaceGrid& grid = pair.grid();
  int left = grid.nx, right = -1, front = grid.ny, back = -1;
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i)
      if (pair.pressure()[grid.index(i, j)] > 0.0)
      {
        left = std::min(left, i);
        right = std::max(right, i);
        front = std::min(front, j);
        back = std::max(back, j);
      }
  coverage.contact_columns = std::max(coverage.contact_columns, right - left + 1);
  coverage.contact_rows = std::max(coverage.contact_rows, back - front + 1);
  // The body with the larger plastic strain has to be resolved.
  const bool lower_yields_more = pair.lower().solved().state().dissipation >= pair.upper().solved().state().dissipation;
  coverage.plastic_layers = plastic_layers(lower_yields_more ? pair.lower().solved() : pair.upper().solved());
}

} // namespace brinell::simulation
