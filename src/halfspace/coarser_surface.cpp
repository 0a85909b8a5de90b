// SPDX-License-Identifier: BSD-3-Clause
#include "coarser_surface.hpp"

#include "foundation/fft.hpp"

#include <algorithm>
#include <array>

namespace brinell::halfspace
{

namespace
{

/// Lagrange's weights at a quarter of the way between the second and the third of four places.
constexpr std::array<double, 4> cubic{-7.0 / 128.0, 105.0 / 128.0, 35.0 / 128.0, -5.0 / 128.0};

/// A fine cell lies a quarter of a coarse one before or behind the centre of the coarse one that holds it.
double weight(bool is_first_half, std::size_t n)
{
  return is_first_half ? cubic[3 - n] : cubic[n];
}

} // namespace

CoarserSurface::CoarserSurface(const SurfaceGrid& finer, const std::array<int, 2>& margins,
                               const std::array<bool, 2>& coarser)
    : fine_(finer), coarse_(finer)
{
  const auto halve = [](bool is_coarser, int fine_margin, int& cells, double& size, Axis& axis)
  {
    axis = {cells, cells, fine_margin, is_coarser};
    if (!is_coarser)
      return;
    const int inner = cells - 2 * fine_margin;
    cells = axis.coarse = (inner + 1) / 2 + 2 * margin;
    size *= 2.0;
  };
  halve(coarser[0] && !finer.is_periodic_x(), margins[0], coarse_.nx, coarse_.dx, x_);
  halve(coarser[1] && !finer.is_periodic_y(), margins[1], coarse_.ny, coarse_.dy, y_);
}

int CoarserSurface::Axis::first_of(int cell) const
{
  const int inner = cell - fine_margin;
  const int holder = inner >= 0 ? inner / 2 : (inner - 1) / 2;
  const bool is_first_half = inner - 2 * holder == 0;
  return margin + holder - (is_first_half ? 2 : 1);
}

std::vector<double> CoarserSurface::from_finer(std::span<const double> load) const
{
  // Along x, then along y; a half as each coarse cell is twice as long.
  std::vector<double> rows(static_cast<std::size_t>(coarse_.nx) * static_cast<std::size_t>(fine_.ny));
  for (int j = 0; j < fine_.ny; ++j)
    for (int i = 0; i < fine_.nx; ++i)
    {
      const double value = load[fine_.index(i, j)];
      double* row = rows.data() + static_cast<std::ptrdiff_t>(j) * coarse_.nx;
      if (!x_.is_coarser)
        row[i] = value;
      else
        for (std::size_t n = 0; n < cubic.size(); ++n)
          row[x_.first_of(i) + static_cast<int>(n)] += 0.5 * weight((i - x_.fine_margin) % 2 == 0, n) * value;
    }
  if (!y_.is_coarser)
    return rows;
  std::vector<double> result(coarse_.size());
  for (int j = 0; j < fine_.ny; ++j)
    for (std::size_t n = 0; n < cubic.size(); ++n)
    {
      const double share = 0.5 * weight((j - y_.fine_margin) % 2 == 0, n);
      const double* from = rows.data() + static_cast<std::ptrdiff_t>(j) * coarse_.nx;
      double* to = result.data() + coarse_.index(0, y_.first_of(j) + static_cast<int>(n));
      for (int i = 0; i < coarse_.nx; ++i)
        to[i] += share * from[i];
    }
  return result;
}

std::vector<double> CoarserSurface::to_finer(std::span<const double> field) const
{
  std::vector<double> rows(static_cast<std::size_t>(coarse_.nx) * static_cast<std::size_t>(fine_.ny));
  for (int j = 0; j < fine_.ny; ++j)
  {
    double* to = rows.data() + static_cast<std::ptrdiff_t>(j) * coarse_.nx;
    if (!y_.is_coarser)
      std::copy_n(field.data() + coarse_.index(0, j), coarse_.nx, to);
    else
      for (std::size_t n = 0; n < cubic.size(); ++n)
      {
        const double share = weight((j - y_.fine_margin) % 2 == 0, n);
        const double* from = field.data() + coarse_.index(0, y_.first_of(j) + static_cast<int>(n));
        for (int i = 0; i < coarse_.nx; ++i)
          to[i] += share * from[i];
      }
  }
  if (!x_.is_coarser)
    return rows;
  std::vector<double> result(fine_.size());
  for (int j = 0; j < fine_.ny; ++j)
    for (int i = 0; i < fine_.nx; ++i)
      for (std::size_t n = 0; n < cubic.size(); ++n)
        result[fine_.index(i, j)] += weight((i - x_.fine_margin) % 2 == 0, n) *
                                     rows[static_cast<std::size_t>(j) * static_cast<std::size_t>(coarse_.nx) +
                                          static_cast<std::size_t>(x_.first_of(i)) + n];
  return result;
}

int memory_length(int cells, bool begins_coarser)
{
  constexpr int ends = 2 * CoarserSurface::margin;
  if (!begins_coarser)
    return fast_length(std::max(2 * cells, cells + 2 + 2 * ends));
  int length = (2 * cells + 3) / 4 * 4;
  while (fast_length(length) != length)
    length += 4;
  return length;
}

bool is_long(int cells)
{
  constexpr int ends = 2 * CoarserSurface::margin;
  return 2 * cells >= cells + 6 + 4 * ends; // a quarter of which holds the ends of cells that are four times as long
}

} // namespace brinell::halfspace
