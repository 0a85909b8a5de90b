// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/elastoplastic/placement.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

namespace brinell::elastoplastic
{

namespace
{

/// Weights of the columns -1, 0, 1, 2 for cubic Lagrange interpolation at the position f in [0, 1); exact for parabolas.
std::array<double, 4> interpolation_weights(double f)
{
  return {-f * (f - 1.0) * (f - 2.0) / 6.0, (f + 1.0) * (f - 1.0) * (f - 2.0) / 2.0, -(f + 1.0) * f * (f - 2.0) / 2.0,
          (f + 1.0) * f * (f - 1.0) / 6.0};
}

/// Index of a column in a body's grid: wrapped if the grid is periodic, otherwise -1 outside the grid.
int column_on(const SurfaceGrid& body, int column)
{
  if (body.is_periodic_x())
    return ((column % body.nx) + body.nx) % body.nx;
  return column < 0 || column >= body.nx ? -1 : column;
}

} // namespace

void add_depth(const SurfaceGrid& body, std::span<const double> displacement, std::span<const double> texture,
               const Place& place, const SurfaceGrid& contact, std::span<double> out)
{
  const auto depth = [&](int column, int j)
  {
    column = column_on(body, column);
    if (column < 0)
      return 0.0;
    const auto n = body.index(column, j);
    return displacement[n] + (texture.empty() ? 0.0 : texture[n]);
  };
  const std::array<double, 4> weights = interpolation_weights(place.fraction);
  for (int j = 0; j < contact.ny; ++j)
    for (int i = 0; i < contact.nx; ++i)
    {
      double& value = out[contact.index(i, j)];
      const int column = i + place.column;
      if (place.fraction == 0.0)
        value += depth(column, j);
      else
        for (int m = 0; m < 4; ++m)
          value += weights[static_cast<std::size_t>(m)] * depth(column + m - 1, j);
    }
}

bool spread_traction(const SurfaceGrid& contact, std::span<const double> traction, const Place& place,
                     const SurfaceGrid& body, std::vector<double>& out)
{
  out.assign(body.size(), 0.0);
  bool all = true;
  const std::array<double, 4> weights = interpolation_weights(place.fraction);
  const bool between = place.fraction != 0.0;
  const int before = between ? 1 : 0;
  const int after = between ? 2 : 0;
  for (int j = 0; j < contact.ny; ++j)
    for (int i = 0; i < contact.nx; ++i)
    {
      const double t = traction[contact.index(i, j)];
      const int column = i + place.column;
      if (t == 0.0)
        continue;
      if (column_on(body, column - before) < 0 || column_on(body, column + after) < 0)
      {
        all = false;
        continue;
      }
      if (between)
        for (int m = 0; m < 4; ++m)
          out[body.index(column_on(body, column + m - 1), j)] += weights[static_cast<std::size_t>(m)] * t;
      else
        out[body.index(column_on(body, column), j)] += t;
    }
  return all;
}

bool spread_volume(const SurfaceGrid& contact, std::span<const double> depth, double factor, const Place& place,
                   const SurfaceGrid& body, std::span<double> out)
{
  bool all = true;
  for (int j = 0; j < contact.ny; ++j)
    for (int i = 0; i < contact.nx; ++i)
    {
      const double d = factor * depth[contact.index(i, j)];
      if (d == 0.0)
        continue;
      const int column = i + place.column;
      for (const auto& [to, weight] : {std::pair{column, 1.0 - place.fraction}, {column + 1, place.fraction}})
      {
        if (weight == 0.0)
          continue;
        if (const int on = column_on(body, to); on >= 0)
          out[body.index(on, j)] += weight * d;
        else
          all = false;
      }
    }
  return all;
}

} // namespace brinell::elastoplastic
