// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/grid.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <vector>

/// Areas of contact of a given shape.
namespace brinell::contact::areas
{

inline constexpr double modulus = 2e11, infinite = std::numeric_limits<double>::infinity(); ///< [Pa], [m]
using Inside = std::function<bool(double x, double y)>;

/// An area on a grid around it, in touch as a flat punch: its edge is known only as that of the cells.
struct Area
{
  SurfaceGrid grid;
  std::vector<double> pressure, gap;
};

/// @param x, y  of the middle of the grid
inline Area area(int nx, int ny, double cell, const Inside& inside, double x = 0.0, double y = 0.0)
{
  Area a{.grid = {nx, ny, cell, cell}, .pressure = {}, .gap = {}};
  for (int j = 0; j < ny; ++j)
    for (int i = 0; i < nx; ++i)
    {
      const bool in = inside(x + a.grid.x(i), y + a.grid.y(j));
      a.pressure.push_back(in ? 1.0 : 0.0);
      a.gap.push_back(in ? 0.0 : infinite);
    }
  return a;
}

/// Whether a point is in one of several discs of radius 1.
inline Inside in_discs(const std::vector<std::array<double, 2>>& middles)
{
  return [=](double x, double y)
  {
    return std::any_of(middles.begin(), middles.end(),
                       [&](const auto& m) { return std::hypot(x - m[0], y - m[1]) < 1.0; });
  };
}

} // namespace brinell::contact::areas
