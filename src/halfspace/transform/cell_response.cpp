// SPDX-License-Identifier: BSD-3-Clause
#include "cell_response.hpp"

#include "brinell/foundation/error.hpp"
#include "brinell/green/rectangle.hpp"
#include "brinell/green/strip.hpp"

#include <cmath>

namespace brinell::halfspace
{

namespace
{

double scaled(double factor, double value)
{
  return factor * value;
}

template <std::size_t size>
std::array<double, size> scaled(double factor, std::array<double, size> value)
{
  for (double& component : value)
    component *= factor;
  return value;
}

void add(double value, double& sum)
{
  sum += value;
}

template <std::size_t size>
void add(const std::array<double, size>& value, std::array<double, size>& sum)
{
  for (std::size_t c = 0; c < sum.size(); ++c)
    sum[c] += value[c];
}

/// The copies of a cell along a periodic axis, from one period to the next.
struct Copies
{
  int cells;
  double cell, period; ///< [m]

  /// Number of periods on either side beyond which the copies are replaced by a strip (Euler-Maclaurin sum, midpoint rule).
  static constexpr int near = 8;
  [[nodiscard]] int count() const { return cells == 1 ? 0 : near; }
  /// Weight of a copy: the end correction of the sum shifts a little weight from the last copy to the one behind it. The shift is
  /// zero if the copies touch each other.
  [[nodiscard]] double weight(int copy) const
  {
    const double share = cell / period;
    const double end = (1.0 - share * share) / 24.0;
    const int distance = std::abs(copy);
    return (distance <= count() ? 1.0 : 0.0) - (distance == count() ? end : 0.0) +
           (distance == count() + 1 ? end : 0.0);
  }
  /// Length of the row of copies that are summed [m].
  [[nodiscard]] double length() const { return (2 * count() + 1) * period; }
};

/// Response of a cell with copies along y, at offsets >= 0.
template <typename Value, typename Kernel>
void with_copies(const SurfaceGrid& grid, const Kernel& kernel, Quadrant<Value>& out)
{
  const Copies copies{grid.ny, grid.dy, grid.ny * grid.dy};
  const double density = grid.dy / copies.period; // density of the strip that replaces the copies
  const auto summed_corner = [&](double X, double Y)
  {
    Value sum{};
    for (int copy = -copies.count() - 1; copy <= copies.count() + 1; ++copy)
      if (const double weight = copies.weight(copy); weight != 0.0)
        add(scaled(weight, kernel.corner(X, Y + copy * copies.period)), sum);
    return sum;
  };
  /// The strip without the part over which the copies have been summed.
  const auto rest = [&](double X, double y)
  {
    Value value = scaled(density, kernel.edge(X));
    add(scaled(-density, kernel.corner(X, y + 0.5 * copies.length())), value);
    add(scaled(density, kernel.corner(X, y - 0.5 * copies.length())), value);
    return value;
  };
  const auto columns = static_cast<std::size_t>(out.nx + 1);
  std::vector<Value> front(columns), back(columns), middle(columns);
  const auto fill = [&](std::vector<Value>& row, const auto& function, double y)
  {
    for (std::size_t i = 0; i < columns; ++i)
      row[i] = function((static_cast<double>(i) - 0.5) * grid.dx, y);
  };
  fill(back, summed_corner, -0.5 * grid.dy);
  for (int j = 0; j < out.ny; ++j)
  {
    std::swap(front, back);
    fill(back, summed_corner, (j + 0.5) * grid.dy);
    fill(middle, rest, j * grid.dy);
    for (int i = 0; i < out.nx; ++i)
    {
      const auto left = static_cast<std::size_t>(i);
      Value& value = out.at(i, j);
      value = middle[left + 1];
      add(scaled(-1.0, middle[left]), value);
      add(back[left + 1], value);
      add(front[left], value);
      add(scaled(-1.0, back[left]), value);
      add(scaled(-1.0, front[left + 1]), value);
    }
  }
}

/// Response of a single cell without copies.
template <typename Value, typename Kernel>
void alone(const SurfaceGrid& grid, const Kernel& kernel, Quadrant<Value>& out)
{
  const auto columns = static_cast<std::size_t>(out.nx + 1);
  std::vector<Value> front(columns), back(columns);
  const auto fill = [&](std::vector<Value>& row, int j)
  {
    for (std::size_t i = 0; i < columns; ++i)
      row[i] = kernel.corner((static_cast<double>(i) - 0.5) * grid.dx, (j - 0.5) * grid.dy);
  };
  fill(back, 0);
  for (int j = 0; j < out.ny; ++j)
  {
    std::swap(front, back);
    fill(back, j + 1);
    for (int i = 0; i < out.nx; ++i)
    {
      const auto left = static_cast<std::size_t>(i);
      Value& value = out.at(i, j);
      value = back[left + 1];
      add(front[left], value);
      add(scaled(-1.0, back[left]), value);
      add(scaled(-1.0, front[left + 1]), value);
    }
  }
}

SurfaceGrid swapped(const SurfaceGrid& g)
{
  return {g.ny, g.nx, g.dy, g.dx, g.boundary_y, g.boundary_x};
}

using brinell::xy_exchanged;
using green::xy_exchanged;

std::array<double, 2> xy_exchanged(const std::array<double, 2>& value)
{
  return value;
}

double xy_exchanged(double value)
{
  return value;
}

/// @param kernel  antiderivatives `corner` of the rectangle at (X, Y) and `edge` of the strip at X, and `xy_exchanged`
template <typename Value, typename Kernel>
Quadrant<Value> response(const SurfaceGrid& grid, const Kernel& kernel)
{
  if (grid.is_periodic())
    throw InternalError("the response of a cell: a body that is periodic along both axes has waves instead");
  Quadrant<Value> out(grid);
  if (grid.is_periodic_y())
    with_copies(grid, kernel, out);
  else if (!grid.is_periodic_x())
    alone(grid, kernel, out);
  else
  {
    const Quadrant<Value> across = response<Value>(swapped(grid), kernel.xy_exchanged());
    for (int j = 0; j < out.ny; ++j)
      for (int i = 0; i < out.nx; ++i)
        out.at(i, j) = xy_exchanged(across.at(j, i));
  }
  return out;
}

/// Antiderivatives of 1/r.
struct DisplacementKernel
{
  double reference;
  [[nodiscard]] double corner(double X, double Y) const { return green::rectangle_displacement_corner(X, Y); }
  [[nodiscard]] double edge(double X) const { return green::strip_displacement_edge(X, reference); }
  [[nodiscard]] DisplacementKernel xy_exchanged() const { return *this; }
};

/// Antiderivatives of 1/R and depth/R^3 (Love 1929), R^2 = X^2 + Y^2 + depth^2.
struct BuriedKernel
{
  double depth, reference;
  [[nodiscard]] std::array<double, 2> corner(double X, double Y) const
  {
    const double angle = std::atan(X * Y / (depth * std::hypot(X, Y, depth)));
    return {X * std::asinh(Y / std::hypot(X, depth)) + Y * std::asinh(X / std::hypot(Y, depth)) - depth * angle, angle};
  }
  [[nodiscard]] std::array<double, 2> edge(double X) const
  {
    const double angle = std::atan(X / depth);
    return {2.0 * (X - X * std::log(std::hypot(X, depth) / reference) - depth * angle), 2.0 * angle};
  }
  [[nodiscard]] BuriedKernel xy_exchanged() const { return *this; }
};

struct SurfaceTermsKernel
{
  double reference;
  [[nodiscard]] green::SurfaceTerms corner(double X, double Y) const { return green::rectangle_surface_corner(X, Y); }
  [[nodiscard]] green::SurfaceTerms edge(double X) const { return green::strip_surface_edge(X, reference); }
  [[nodiscard]] SurfaceTermsKernel xy_exchanged() const { return *this; }
};

struct StressKernel
{
  double depth, poisson_ratio;
  Traction traction;
  [[nodiscard]] SymTensor corner(double X, double Y) const
  {
    return green::rectangle_stress_corner(X, Y, depth, poisson_ratio, traction);
  }
  [[nodiscard]] SymTensor edge(double X) const { return green::strip_stress_edge(X, depth, poisson_ratio, traction); }
  [[nodiscard]] StressKernel xy_exchanged() const { return {depth, poisson_ratio, brinell::xy_exchanged(traction)}; }
};

} // namespace

Quadrant<double> cell_displacement(const SurfaceGrid& grid, double reference)
{
  return response<double>(grid, DisplacementKernel{reference});
}

Quadrant<std::array<double, 2>> buried_cell(const SurfaceGrid& grid, double depth, double reference)
{
  return response<std::array<double, 2>>(grid, BuriedKernel{depth, reference});
}

Quadrant<green::SurfaceTerms> cell_surface_terms(const SurfaceGrid& grid, double reference)
{
  return response<green::SurfaceTerms>(grid, SurfaceTermsKernel{reference});
}

Quadrant<SymTensor> cell_stress(const SurfaceGrid& grid, double depth, double poisson_ratio, Traction traction)
{
  return response<SymTensor>(grid, StressKernel{depth, poisson_ratio, traction});
}

} // namespace brinell::halfspace
