// SPDX-License-Identifier: BSD-3-Clause
#include "coarser_surface.hpp"

#include "foundation/fft.hpp"

#include <algorithm>
#include <array>

namespace brinell::halfspace
{

namespace
{

/// Number of cells twice as long that cover `cells` cells with the same middle. It is even, so that a load in the middle is
/// spread over two cells: in a single cell it would remain a spike at all levels, whose shortest waves differ between lattices of
/// different periods.
int half_as_many(int cells)
{
  return 2 * ((cells + (cells % 2 == 0 ? 3 : 4)) / 4);
}

/// Lagrange weights of four equidistant points, at the distance s (in units of their spacing) behind the second one.
std::array<double, 4> cubic(double s)
{
  return {-s * (s - 1.0) * (s - 2.0) / 6.0, (s + 1.0) * (s - 1.0) * (s - 2.0) / 2.0, -(s + 1.0) * s * (s - 2.0) / 2.0,
          (s + 1.0) * s * (s - 1.0) / 6.0};
}

} // namespace

CoarserSurface::CoarserSurface(const SurfaceGrid& finer, const std::array<int, 2>& margins,
                               const std::array<bool, 2>& coarser)
    : fine_(finer), coarse_(finer), margins_(margins)
{
  const auto halve = [](int& finer_margin, int& cells, double& size)
  {
    const int fine = cells;
    cells = half_as_many(cells - 2 * finer_margin) + 2 * margin;
    size *= 2.0;
    finer_margin = margin;
    return axis(fine, cells);
  };
  if (coarser[0] && !finer.is_periodic_x())
    x_ = halve(margins_[0], coarse_.nx, coarse_.dx);
  if (coarser[1] && !finer.is_periodic_y())
    y_ = halve(margins_[1], coarse_.ny, coarse_.dy);
}

CoarserSurface::Axis CoarserSurface::axis(int fine, int coarse)
{
  Axis axis;
  for (int cell = 0; cell < fine; ++cell)
  {
    // Position in quarters of a coarse cell, from the centre of the first one; the middles of both grids coincide.
    const int quarters = 2 * cell - fine + 2 * coarse - 1;
    axis.push_back({quarters / 4 - 1, cubic(0.25 * (quarters % 4))});
  }
  return axis;
}

std::vector<double> CoarserSurface::from_finer(std::span<const double> load) const
{
  // Along x, then along y; the factor 1/2 since each coarse cell is twice as long.
  std::vector<double> rows(static_cast<std::size_t>(coarse_.nx) * static_cast<std::size_t>(fine_.ny));
  for (int j = 0; j < fine_.ny; ++j)
    for (int i = 0; i < fine_.nx; ++i)
    {
      const double value = load[fine_.index(i, j)];
      double* row = rows.data() + static_cast<std::ptrdiff_t>(j) * coarse_.nx;
      if (x_.empty())
      {
        row[i] = value;
        continue;
      }
      const Between& at = x_[static_cast<std::size_t>(i)];
      for (std::size_t n = 0; n < at.weights.size(); ++n)
        row[static_cast<std::size_t>(at.first) + n] += 0.5 * at.weights[n] * value;
    }
  if (y_.empty())
    return rows;
  std::vector<double> result(coarse_.size());
  for (int j = 0; j < fine_.ny; ++j)
    for (int n = 0; n < 4; ++n)
    {
      const Between& at = y_[static_cast<std::size_t>(j)];
      const double share = 0.5 * at.weights[static_cast<std::size_t>(n)];
      const double* from = rows.data() + static_cast<std::ptrdiff_t>(j) * coarse_.nx;
      double* to = result.data() + coarse_.index(0, at.first + n);
      for (int i = 0; i < coarse_.nx; ++i)
        to[i] += share * from[i];
    }
  return result;
}

std::vector<double> CoarserSurface::to_finer(std::span<const double> field) const
{
  std::vector<double> rows, result;
  to_finer(field, rows, result);
  return result;
}

/// Along y, then along x. Along x two sets of weights alternate between neighbouring fine cells.
void CoarserSurface::to_finer(std::span<const double> field, std::vector<double>& room,
                              std::vector<double>& result) const
{
  std::vector<double>& rows = x_.empty() ? result : room;
  rows.resize(static_cast<std::size_t>(coarse_.nx) * static_cast<std::size_t>(fine_.ny));
  for (int j = 0; j < fine_.ny; ++j)
  {
    double* to = rows.data() + static_cast<std::ptrdiff_t>(j) * coarse_.nx;
    if (y_.empty())
    {
      std::copy_n(field.data() + coarse_.index(0, j), coarse_.nx, to);
      continue;
    }
    const Between& at = y_[static_cast<std::size_t>(j)];
    const double* four = field.data() + coarse_.index(0, at.first);
    for (int i = 0; i < coarse_.nx; ++i)
      to[i] = at.weights[0] * four[i] + at.weights[1] * four[coarse_.nx + i] +
              at.weights[2] * four[2 * coarse_.nx + i] + at.weights[3] * four[3 * coarse_.nx + i];
  }
  if (x_.empty())
    return;
  result.resize(fine_.size());
  // After the first fine cell, each coarse cell is the first of the four for two successive fine cells.
  const Between &once = x_.front(), &twice = x_[std::min<std::size_t>(1, x_.size() - 1)];
  for (int j = 0; j < fine_.ny; ++j)
  {
    const double* row = rows.data() + static_cast<std::ptrdiff_t>(j) * coarse_.nx;
    double* to = result.data() + fine_.index(0, j);
    const double *four = row + once.first, *next = row + twice.first;
    for (int n = 0; n < fine_.nx / 2; ++n)
    {
      to[2 * n] = once.weights[0] * four[n] + once.weights[1] * four[n + 1] + once.weights[2] * four[n + 2] +
                  once.weights[3] * four[n + 3];
      to[2 * n + 1] = twice.weights[0] * next[n] + twice.weights[1] * next[n + 1] + twice.weights[2] * next[n + 2] +
                      twice.weights[3] * next[n + 3];
    }
    if (fine_.nx % 2 != 0)
    {
      const int n = fine_.nx / 2;
      to[2 * n] = once.weights[0] * four[n] + once.weights[1] * four[n + 1] + once.weights[2] * four[n + 2] +
                  once.weights[3] * four[n + 3];
    }
  }
}

int memory_length(int cells, bool begins_coarser)
{
  constexpr int ends = 2 * CoarserSurface::margin;
  if (!begins_coarser)
    return fast_length(2 * std::max(cells, half_as_many(cells) + ends));
  int length = (2 * cells + 3) / 4 * 4;
  while (fast_length(length) != length)
    length += 4;
  return length;
}

bool is_long(int cells)
{
  constexpr int ends = 2 * CoarserSurface::margin;
  return cells >= 2 * (half_as_many(half_as_many(cells)) + ends);
}

} // namespace brinell::halfspace
