// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/grid.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

/// Fields on a surface grid.
namespace brinell::test
{

using Field = std::vector<double>;

/// f(i, j) at all cells.
template <typename Function>
[[nodiscard]] Field sampled(const SurfaceGrid& g, Function f)
{
  Field field(g.size());
  for (int j = 0; j < g.ny; ++j)
    for (int i = 0; i < g.nx; ++i)
      field[g.index(i, j)] = f(i, j);
  return field;
}

[[nodiscard]] inline double sum(const Field& field)
{
  return std::accumulate(field.begin(), field.end(), 0.0);
}
[[nodiscard]] inline double mean(const Field& field)
{
  return sum(field) / static_cast<double>(field.size());
}
/// Largest magnitude.
[[nodiscard]] inline double largest(const Field& field)
{
  double value = 0.0;
  for (const double f : field)
    value = std::max(value, std::abs(f));
  return value;
}

/// r^2/(2 R) - approach around the middle of the grid.
[[nodiscard]] inline Field paraboloid(const SurfaceGrid& g, double approach, double radius = 1.0)
{
  return sampled(g, [&](int i, int j) { return 0.5 * (g.x(i) * g.x(i) + g.y(j) * g.y(j)) / radius - approach; });
}

/// Mean over cells of sqrt(1 - r^2), the cell in the middle of the grid at the origin; in one row, of sqrt(1 - x^2).
[[nodiscard]] inline Field hertz(const SurfaceGrid& g)
{
  constexpr int parts = 32;
  const auto middle = [&](int i, int a, int cells, double size)
  { return cells == 1 ? 0.0 : (i - cells / 2 - 0.5 + (a + 0.5) / parts) * size; };
  return sampled(g,
                 [&](int i, int j)
                 {
                   double sum = 0.0;
                   for (int b = 0; b < parts; ++b)
                     for (int a = 0; a < parts; ++a)
                       sum += std::sqrt(std::max(0.0, 1.0 - std::pow(middle(i, a, g.nx, g.dx), 2) -
                                                          std::pow(middle(j, b, g.ny, g.dy), 2)));
                   return sum / (parts * parts);
                 });
}

/// Share of the cells inside a disc of the radius 1 about the middle of the grid.
[[nodiscard]] inline Field disc(const SurfaceGrid& g)
{
  constexpr int parts = 32;
  return sampled(g,
                 [&](int i, int j)
                 {
                   int inside = 0;
                   for (int b = 0; b < parts; ++b)
                     for (int a = 0; a < parts; ++a)
                       inside += std::hypot(g.x(i) + ((a + 0.5) / parts - 0.5) * g.dx,
                                            g.y(j) + ((b + 0.5) / parts - 0.5) * g.dy) < 1.0;
                   return static_cast<double>(inside) / (parts * parts);
                 });
}

inline double largest_difference(const Field& a, const Field& b)
{
  double value = 0.0;
  for (std::size_t n = 0; n < a.size(); ++n)
    value = std::max(value, std::abs(a[n] - b[n]));
  return value;
}

} // namespace brinell::test
