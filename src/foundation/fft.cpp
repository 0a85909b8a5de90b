// SPDX-License-Identifier: BSD-3-Clause
#include "foundation/fft.hpp"

#include "brinell/foundation/error.hpp"
#include "foundation/lane_functions.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace brinell
{

namespace
{

bool is_smooth(int n)
{
  for (const int prime : {2, 3, 5, 7})
    while (n % prime == 0)
      n /= prime;
  return n == 1;
}

} // namespace

int fast_length(int n)
{
  int m = std::max(2, n + n % 2);
  while (!is_smooth(m))
    m += 2;
  return m;
}

namespace
{

/// @param period  of the other axis [m]; 0 if that one is open.
int padded_length(int cells, double cell, Boundary boundary, double period)
{
  if (boundary == Boundary::periodic)
    return cells;
  // Distance of the copies beside the grid, in periods of the other axis. There the longest wave along that axis, for strain up
  // to the edges of the grid, has decayed as (1 + k d) e^{-kd} to below 1e-4 of 2 mu max|eps|, the error of the image correction
  // for strain without waves. At a distance of one period the error would be up to 6e-3.
  constexpr double clearance = 1.75;
  const int clear = cells + static_cast<int>(std::ceil(clearance * period / cell));
  return fast_length(std::max(2 * cells - 1, clear));
}

const SurfaceGrid& checked(const SurfaceGrid& grid, int px, int py)
{
  if (grid.nx < 1 || grid.ny < 1 || px < grid.nx || py < grid.ny)
    throw InternalError("PaddedFft: the padded lengths must hold the grid");
  return grid;
}

} // namespace

PaddedLengths padded_lengths(const SurfaceGrid& grid)
{
  const double period_x = grid.is_periodic_x() && grid.nx > 1 ? grid.nx * grid.dx : 0.0;
  const double period_y = grid.is_periodic_y() && grid.ny > 1 ? grid.ny * grid.dy : 0.0;
  return {padded_length(grid.nx, grid.dx, grid.boundary_x, period_y),
          padded_length(grid.ny, grid.dy, grid.boundary_y, period_x)};
}

PaddedFft::PaddedFft(const SurfaceGrid& grid) : PaddedFft(grid, padded_lengths(grid).x, padded_lengths(grid).y) {}

PaddedFft::PaddedFft(const SurfaceGrid& grid, int px, int py)
    : grid_(checked(grid, px, py)), px_(px), py_(py), rows_(grid.nx, px), full_rows_(px, px), columns_(py)
{
  const std::size_t exact = static_cast<std::size_t>(kx()) * static_cast<std::size_t>(py_);
  plane_ = (exact + 7) / 8 * 8; // every plane of a batch starts on a cache line
}

double PaddedFft::wavenumber_x(int i) const
{
  return 2.0 * std::numbers::pi * i / (px_ * grid_.dx);
}

double PaddedFft::wavenumber_y(int j) const
{
  return 2.0 * std::numbers::pi * (j <= py_ / 2 ? j : j - py_) / (py_ * grid_.dy);
}

namespace
{

/// Stores neighbouring values of one row, up to the last column.
void store_row(const ComplexLanes& value, int count, Complex* to)
{
  if (count >= lane_count)
    return store_lanes(value, to);
  for (int lane = 0; lane < count; ++lane)
    to[lane] = {value.re[lane], value.im[lane]};
}

} // namespace

PaddedFft::Scratch PaddedFft::make_scratch(int rows) const
{
  return {rows_.make_work(),
          AlignedVector<ComplexLanes>(static_cast<std::size_t>(rows_.blocks()) * static_cast<std::size_t>(rows)),
          AlignedVector<ComplexLanes>(static_cast<std::size_t>(py_)),
          AlignedVector<ComplexLanes>(columns_.work_size())};
}

void PaddedFft::forward(const double* field, Complex* spectrum, Scratch& scratch) const
{
  forward(rows_, grid_.nx, grid_.ny, field, spectrum, scratch);
}

void PaddedFft::forward(const RowFft& row_fft, int nx, int ny, const double* field, Complex* spectrum,
                        Scratch& scratch) const
{
  for (std::ptrdiff_t first = 0; first < ny; first += RowFft::most_rows)
    row_fft.forward(field + first * nx, std::min<int>(RowFft::most_rows, ny - static_cast<int>(first)),
                    scratch.rows.data() + first, {ny, false}, scratch.row);
  const ComplexLanes* rows = scratch.rows.data();
  for (int first = 0; first < kx(); first += lane_count, rows += ny)
  {
    columns_.forward(rows, ny, scratch.column.data(), scratch.work.data());
    for (std::ptrdiff_t j = 0; j < py_; ++j)
      store_row(scratch.column[static_cast<std::size_t>(j)], kx() - first, spectrum + j * kx() + first);
  }
}

void PaddedFft::inverse(const Complex* spectrum, double* field, Scratch& scratch) const
{
  const std::ptrdiff_t nx = grid_.nx, ny = grid_.ny;
  ComplexLanes* rows = scratch.rows.data();
  for (int first = 0; first < kx(); first += lane_count, rows += ny)
  {
    for (std::ptrdiff_t j = 0; j < py_; ++j)
      scratch.column[static_cast<std::size_t>(j)] =
          load_lanes(spectrum + j * kx() + first, static_cast<std::size_t>(std::min(lane_count, kx() - first)));
    columns_.inverse(scratch.column.data(), rows, grid_.ny, scratch.work.data());
  }
  for (std::ptrdiff_t first = 0; first < ny; first += RowFft::most_rows)
    rows_.inverse(scratch.rows.data() + first, {ny, false},
                  std::min<int>(RowFft::most_rows, grid_.ny - static_cast<int>(first)),
                  1.0 / (static_cast<double>(px_) * py_), field + first * nx, scratch.row);
}

void PaddedFft::forward_padded(std::span<const double> field, Complex* spectrum) const
{
  Scratch scratch = make_scratch(py_);
  forward(full_rows_, px_, py_, field.data(), spectrum, scratch);
}

} // namespace brinell
