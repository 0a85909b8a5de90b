// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/simulation/texture.hpp"
#include "foundation/aligned.hpp"

#include <array>

namespace brinell::simulation
{

/// Amplitudes of the waves of a random surface: its height at (x, y) is the sum over (i, j) of
/// Re(c_ij exp(2 pi I (i x/size_x + j y/size_y))). One of each pair of opposite wavevectors is stored; the mean is zero.
struct RandomSurface::Waves
{
  int max_x = 0, max_y = 0;          ///< i from 0 to max_x, j from -max_y to max_y
  std::vector<Complex> amplitudes{}; ///< [m], j runs fastest; zero beyond the cutoff

  [[nodiscard]] std::size_t rows() const { return 2 * static_cast<std::size_t>(max_y) + 1; }
  [[nodiscard]] std::size_t index(int i, int j) const
  {
    return static_cast<std::size_t>(i) * rows() + static_cast<std::size_t>(j + max_y);
  }
};

/// Ratio of the mean of a wave over a cell to its value at the centre of the cell.
[[nodiscard]] double mean_over_cell(double cell, double wavelength);

/// Sides of the cell over which waves are averaged [m]; zero: no average, the value at the centre is used.
using Averaged = std::array<double, 2>;

/// Height out of the body at (x, y) [m], by the sum over all waves.
[[nodiscard]] double height_of(const RandomSurface& surface, double x, double y, const Averaged& over);

/// Algorithm for the heights on a grid; the results are the same.
enum class Route
{
  transform,        ///< fast Fourier transform; only if the cells divide the period into even numbers
  rows_and_columns, ///< sum over the waves, along y and then along x
  cheapest
};
/// Adds the height times `factor` at each cell of a grid whose cell (0, 0) has its centre at (x0, y0).
void add_heights(const RandomSurface& surface, const SurfaceGrid& grid, double x0, double y0, const Averaged& over,
                 double factor, std::vector<double>& heights, Route route = Route::cheapest);

/// Largest height on a grid with four points per shortest wave along both axes [m].
[[nodiscard]] double highest_point(const RandomSurface& surface);

} // namespace brinell::simulation
