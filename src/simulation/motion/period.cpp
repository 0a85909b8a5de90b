// SPDX-License-Identifier: BSD-3-Clause
#include "period.hpp"

#include "brinell/foundation/error.hpp"
#include "simulation/plan/domain.hpp"
#include "simulation/plan/surface_distance.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <functional>
#include <numeric>

namespace brinell::simulation
{

namespace
{

using contact::Drive;
using Field = std::vector<double>;

/// Sum of the depths of both textures at the centres of the cells, moved by (dx, dy).
Field of_both(const IndentationCase& c, const SurfaceGrid& grid, double dx = 0.0, double dy = 0.0)
{
  CellPlaces at = places_in_run(grid, c.places.front());
  at.x += dx;
  at.y += dy;
  return texture_distance(c.lower, c.upper, grid, at, depths);
}

double mean(const Field& field)
{
  return std::accumulate(field.begin(), field.end(), 0.0) / static_cast<double>(field.size());
}

} // namespace

double touching_gap(const IndentationCase& c, const SurfaceGrid& grid)
{
  const Field distance = surface_distance(c.lower, c.upper, grid, places_in_run(grid, c.places.front()), cell_depths);
  return mean(distance) - *std::min_element(distance.begin(), distance.end());
}

Roughness roughness(const IndentationCase& c, const SurfaceGrid& grid)
{
  const auto mean_square = [](const Field& field)
  { return std::inner_product(field.begin(), field.end(), field.begin(), 0.0) / static_cast<double>(field.size()); };
  Roughness result = roughness_of(of_both(c, grid), grid);
  // Slopes by differences over a tiny part of a cell, since textures are functions of continuous coordinates.
  constexpr double hair = 1e-4;
  const auto mean_square_slope = [&](double dx, double dy)
  {
    Field ahead = of_both(c, grid, dx, dy);
    const Field behind = of_both(c, grid, -dx, -dy);
    std::transform(ahead.begin(), ahead.end(), behind.begin(), ahead.begin(), std::minus<>());
    return mean_square(ahead) / (4.0 * (dx * dx + dy * dy));
  };
  result.slope = std::sqrt(mean_square_slope(hair * grid.dx, 0.0) + mean_square_slope(0.0, hair * grid.dy));
  return result;
}

contact::Drive largest_drive(const IndentationCase& c)
{
  if (c.sequence.empty())
    throw InputError("an indentation needs at least one load, approach or mean gap");
  const auto by_value = [](const Drive& a, const Drive& b) { return a.value < b.value; };
  const auto [smallest, largest] = std::minmax_element(c.sequence.begin(), c.sequence.end(), by_value);
  if (largest->kind != Drive::Kind::mean_gap)
  {
    if (!(largest->value > 0.0))
      throw InputError("an indentation needs a load or an approach > 0");
    return *largest;
  }
  if (!c.domain.is_periodic())
    throw InputError("a mean gap is defined over a period only; allowed: bodies that are periodic along both axes");
  if (!(smallest->value > 0.0))
    throw InputError(fmt::format("a mean gap of {:g} m; allowed: > 0", smallest->value));
  const double touch = touching_gap(c, sampled_period(c.domain)); // an estimate: the cells of the run are not known yet
  return {Drive::Kind::approach, std::max(touch - smallest->value, 1e-3 * touch)};
}

} // namespace brinell::simulation
