// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/contact/contact_area.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace brinell::contact
{

namespace
{

constexpr double wall = std::numeric_limits<double>::infinity();

struct Cell
{
  int i = 0, j = 0;
};

/// Position of the contact edge on the line between the centres of two neighbouring cells.
struct Edge
{
  double covered = 0.0; ///< fraction of the line that is in contact
  bool is_wall = false; ///< whether the edge coincides with that of the cells
};

/// Degree to which an edge is a kink left by plastic strain in the surfaces, 0 to 1. Beside an elastic edge the slope of the gap,
/// 2 K sqrt(s)/E', and the pressure, K sqrt(s), have a fixed ratio at the same distance s: multiplied by E'/2 and evaluated at
/// the cell centres it is at most sqrt(3/2), more in contacts of only a few cells.
/// @param slope_over_pressure  E'/2 times the slope, over the pressure
double kink_share(double slope_over_pressure)
{
  constexpr double elastic = 2.0;
  return slope_over_pressure > elastic ? 1.0 - std::pow(elastic / slope_over_pressure, 2) : 0.0;
}

/// Pressure and gap of a solved contact, cell by cell; an open grid is surrounded by walls.
class Field
{
public:
  Field(const SurfaceGrid& grid, std::span<const double> pressure, std::span<const double> gap, double modulus)
      : grid_(grid), pressure_(pressure), gap_(gap), modulus_(modulus)
  {
  }

  [[nodiscard]] bool touches(const Cell& c) const { return has(c) && pressure_[at(c)] > 0.0; }

  /// The edge between two neighbours, one of them under pressure.
  [[nodiscard]] Edge edge(const Cell& a, const Cell& b) const
  {
    if (!touches(a))
      return edge(b, a);
    const double distance = a.j == b.j ? grid_.dx : grid_.dy;
    // A gap that rises by more than 45 degrees is not the surface of a half space but the side of a body.
    if (!has(b) || gap_[at(b)] > distance)
      return {edge_position(wall), true};
    const double gap = std::max(0.0, gap_[at(b)]);
    const double elastic = edge_position(0.75 * modulus_ * gap / (pressure_[at(a)] * distance));
    const Cell behind{2 * a.i - b.i, 2 * a.j - b.j};
    const Cell beyond{2 * b.i - a.i, 2 * b.j - a.j};
    if (!touches(behind) || !has(beyond) || gap_[at(beyond)] > distance)
      return {elastic, false};
    const double rise = gap_[at(beyond)] - gap;
    const double pressure = std::max(pressure_[at(a)], pressure_[at(behind)]);
    const double kink = kink_share(0.5 * modulus_ * rise / (pressure * distance));
    if (kink == 0.0)
      return {elastic, false};
    // Beside a kink both grow in proportion to the distance.
    const double inside = pressure_[at(a)] / pressure;
    const double outside = gap / rise;
    return {elastic + kink * (inside / (inside + outside) - elastic), false};
  }

private:
  [[nodiscard]] bool has(const Cell& c) const
  {
    return (grid_.is_periodic_x() || (c.i >= 0 && c.i < grid_.nx)) &&
           (grid_.is_periodic_y() || (c.j >= 0 && c.j < grid_.ny));
  }
  [[nodiscard]] std::size_t at(const Cell& c) const
  {
    return grid_.index((c.i + 2 * grid_.nx) % grid_.nx, (c.j + 2 * grid_.ny) % grid_.ny); // at most two cells outside
  }

  const SurfaceGrid& grid_;
  std::span<const double> pressure_, gap_;
  double modulus_;
};

/// Area fractions in contact of the square between the centres of four cells, of which (i, j) is the first. `add` is called for
/// each fraction, with a cell under pressure of the patch to which it belongs. Two diagonally opposite corners are not connected.
template <typename Add>
void add_square(const Field& field, int i, int j, const Add& add)
{
  // Around the square, so that corner k and k + 1 are neighbours.
  const std::array<Cell, 4> corner{{{i, j}, {i + 1, j}, {i + 1, j + 1}, {i, j + 1}}};
  std::array<bool, 4> in{};
  int count = 0;
  for (std::size_t k = 0; k < 4; ++k)
    count += in[k] = field.touches(corner[k]);
  if (count == 0)
    return;
  if (count == 4)
    return add(corner[0], 1.0);
  const auto edge = [&](std::size_t k, std::size_t next) { return field.edge(corner[k], corner[next % 4]); };
  if (count == 2 && in[0] != in[2]) // side by side: a trapezium
  {
    for (std::size_t k = 0; k < 4; ++k)
      if (in[k] && in[(k + 1) % 4])
        add(corner[k], 0.5 * (edge(k, k + 3).covered + edge((k + 1) % 4, k + 2).covered));
    return;
  }
  // Single corners: triangles, or rectangles beside a wall, at each corner in contact; of three, at the one that is not in
  // contact.
  const bool odd_one = count != 3;
  for (std::size_t k = 0; k < 4; ++k)
    if (in[k] == odd_one)
    {
      const Edge a = edge(k, k + 1);
      const Edge b = edge(k, k + 3);
      const double box = odd_one ? a.covered * b.covered : (1.0 - a.covered) * (1.0 - b.covered);
      const double share = a.is_wall || b.is_wall ? box : 0.5 * box;
      add(odd_one ? corner[k] : corner[(k + 1) % 4], odd_one ? share : 1.0 - share);
    }
}

/// Calls add_square for all squares of a grid.
template <typename Add>
void add_squares(const SurfaceGrid& grid, const Field& field, const Add& add)
{
  for (int j = grid.is_periodic_y() ? 0 : -1; j < grid.ny; ++j)
    for (int i = grid.is_periodic_x() ? 0 : -1; i < grid.nx; ++i)
      add_square(field, i, j, add);
}

/// Union-find structure of connected cells; the root of each group is its first cell.
class Groups
{
public:
  explicit Groups(std::size_t cells) : parent_(cells) { std::iota(parent_.begin(), parent_.end(), std::size_t{0}); }

  [[nodiscard]] std::size_t root(std::size_t cell)
  {
    while (parent_[cell] != cell)
      cell = parent_[cell] = parent_[parent_[cell]]; // path halving, which shortens the next search
    return cell;
  }
  void join(std::size_t a, std::size_t b)
  {
    const auto [first, other] = std::minmax({root(a), root(b)}); // of values: the pair of references would dangle
    parent_[other] = first;
  }

private:
  std::vector<std::size_t> parent_;
};

} // namespace

double edge_position(double gap_over_pressure)
{
  if (std::isinf(gap_over_pressure))
    return 0.5;
  const double r2 = gap_over_pressure * gap_over_pressure;
  constexpr double too_large = 1e30; // t is below rounding
  if (!(r2 < too_large))
    return 0.0;
  // (1 - t)^3 = r^2 t with s = 1 - t: s^3 + r^2 s - r^2 is convex and rises for s > 0, so that Newton's steps from above its root
  // fall towards it, until rounding stops them.
  double s = std::min(1.0, std::cbrt(r2));
  for (;;)
  {
    const double next = (2.0 * s * s * s + r2) / (3.0 * s * s + r2);
    if (!(next < s))
      return 1.0 - s;
    s = next;
  }
}

double contact_area(const SurfaceGrid& grid, std::span<const double> pressure, std::span<const double> gap,
                    double contact_modulus)
{
  const Field field(grid, pressure, gap, contact_modulus);
  double cells = 0.0;
  add_squares(grid, field, [&](const Cell& /*cell*/, double share) { cells += share; });
  return cells * grid.cell_area();
}

Patches patches(const SurfaceGrid& grid, std::span<const double> pressure, std::span<const double> gap,
                double contact_modulus)
{
  const Field field(grid, pressure, gap, contact_modulus);
  Groups groups(grid.size());
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i)
      for (const Cell& next : {Cell{i + 1, j}, Cell{i, j + 1}})
        if (field.touches({i, j}) && field.touches(next))
          groups.join(grid.index(i, j), grid.index(next.i % grid.nx, next.j % grid.ny));
  Patches result{std::vector<int>(grid.size(), -1), {}};
  for (std::size_t cell = 0; cell < grid.size(); ++cell)
    if (pressure[cell] > 0.0)
    {
      const std::size_t root = groups.root(cell);
      if (root == cell) // the first cell of its patch
      {
        result.label[cell] = static_cast<int>(result.area.size());
        result.area.push_back(0.0);
      }
      result.label[cell] = result.label[root];
    }
  const auto wrapped = [](int i, int n) { return (i + n) % n; };
  add_squares(grid, field,
              [&](const Cell& cell, double share)
              {
                const std::size_t at = grid.index(wrapped(cell.i, grid.nx), wrapped(cell.j, grid.ny));
                result.area[static_cast<std::size_t>(result.label[at])] += share * grid.cell_area();
              });
  return result;
}

} // namespace brinell::contact
