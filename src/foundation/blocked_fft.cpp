// SPDX-License-Identifier: BSD-3-Clause
#include "foundation/blocked_fft.hpp"

#include "brinell/foundation/error.hpp"
#include "foundation/lane_functions.hpp"

#include <algorithm>
#include <numbers>

namespace brinell
{

namespace
{

std::size_t product(int a, int b, int c = 1)
{
  return static_cast<std::size_t>(a) * static_cast<std::size_t>(b) * static_cast<std::size_t>(c);
}

const SurfaceGrid& checked(const SurfaceGrid& grid, int px, int py, int planes)
{
  if (grid.nx < 1 || grid.ny < 1 || planes < 1 || px < grid.nx || py < grid.ny)
    throw InternalError("BlockedFft: the padded lengths must hold the grid");
  return grid;
}

} // namespace

std::vector<Complex> phases_of_mirror(int ny, int py)
{
  std::vector<Complex> phases;
  for (int n = 0; n <= py / 2; ++n) // the angle is reduced first, so that it is accurate for long series
  {
    const auto cycles = static_cast<double>(static_cast<long long>(n) * (ny - 1) % py) / py;
    phases.push_back(std::polar(1.0, 2.0 * std::numbers::pi * cycles));
  }
  return phases;
}

BlockedFft::BlockedFft(const SurfaceGrid& grid, int px, int py, int planes)
    : grid_(checked(grid, px, py, planes)), planes_(planes), rows_(grid.nx, px), columns_(py),
      phase_(grid.is_mirrored_y ? phases_of_mirror(grid.ny, py) : std::vector<Complex>{})
{
}

std::size_t BlockedFft::rows_size() const
{
  return product(blocks(), planes_, stored_rows());
}

std::size_t BlockedFft::block_size() const
{
  return product(planes_, pitch());
}

std::ptrdiff_t BlockedFft::plane_at(int block, int plane) const
{
  return (static_cast<std::ptrdiff_t>(block) * planes_ + plane) * pitch();
}

std::ptrdiff_t BlockedFft::rows_at(int block, int plane) const
{
  return (static_cast<std::ptrdiff_t>(block) * planes_ + plane) * stored_rows();
}

BlockedFft::Scratch BlockedFft::make_scratch() const
{
  return {rows_.make_work(), AlignedVector<ComplexLanes>(product(py(), 1)),
          AlignedVector<ComplexLanes>(columns_.work_size()),
          AlignedVector<ComplexLanes>(grid_.is_mirrored_y ? product(py(), 1) : 0U)};
}

RowFft::Spectra BlockedFft::rows_layout() const
{
  return {rows_at(1, 0), rows_size() * sizeof(ComplexLanes) > cached_bytes};
}

void BlockedFft::rows_forward(const double* field, int plane, ComplexLanes* rows, Scratch& scratch) const
{
  for (int batch = 0; batch < batches(); ++batch)
    rows_forward(field, plane, batch, rows, scratch);
}

void BlockedFft::rows_forward(const double* field, int plane, int batch, ComplexLanes* rows, Scratch& scratch) const
{
  const int first = batch * RowFft::most_rows;
  rows_.forward(field + static_cast<std::ptrdiff_t>(first) * grid_.nx,
                std::min(RowFft::most_rows, stored_rows() - first), rows + rows_at(0, plane) + first, rows_layout(),
                scratch.rows);
}

void BlockedFft::rows_forward_to(const double* field, ComplexLanes* rows, const RowFft::Spectra& apart,
                                 Scratch& scratch) const
{
  for (int first = 0; first < stored_rows(); first += RowFft::most_rows)
    rows_.forward(field + static_cast<std::ptrdiff_t>(first) * grid_.nx,
                  std::min(RowFft::most_rows, stored_rows() - first), rows + first, apart, scratch.rows);
}

void BlockedFft::columns_forward(const ComplexLanes* rows, int block, int plane, ComplexLanes* column, Scratch& scratch,
                                 bool is_odd) const
{
  const ComplexLanes* series = rows + rows_at(block, plane);
  for (int j = 0; plane + 1 < planes_ && j < stored_rows(); ++j)
    fetch_soon(series + stored_rows() + j); // of the next plane
  if (grid_.is_mirrored_y)
    series = both_sides(series, is_odd, scratch.both.data());
  columns_.forward(series, grid_.ny, column, scratch.work.data());
}

/// All rows of a field from the independent ones.
const ComplexLanes* BlockedFft::both_sides(const ComplexLanes* series, bool is_odd, ComplexLanes* both) const
{
  for (int j = 0; j < stored_rows(); ++j)
  {
    const bool is_middle = 2 * j + 1 == grid_.ny;
    both[j] = is_middle && is_odd ? ComplexLanes{} : series[j];
    if (!is_middle)
      both[grid_.ny - 1 - j] = is_odd ? -1.0 * series[j] : series[j];
  }
  return both;
}

/// All wavenumbers of a spectrum from those >= 0.
const ComplexLanes* BlockedFft::all_waves(const ComplexLanes* column, bool is_odd, ComplexLanes* all) const
{
  std::copy_n(column, waves_along_y(), all);
  for (int n = 1; 2 * n < py(); ++n)
  {
    const Complex& phase = phase_[static_cast<std::size_t>(n)];
    const ComplexLanes opposite = phase.real() * column[n] + phase.imag() * times_i(column[n]);
    all[py() - n] = is_odd ? -1.0 * opposite : opposite;
  }
  return all;
}

void BlockedFft::columns_inverse(const ComplexLanes* column, int block, int plane, ComplexLanes* rows, Scratch& scratch,
                                 bool is_odd) const
{
  if (grid_.is_mirrored_y)
    column = all_waves(column, is_odd, scratch.both.data());
  columns_.inverse(column, rows + rows_at(block, plane), stored_rows(), scratch.work.data());
}

void BlockedFft::rows_inverse(const ComplexLanes* rows, int plane, double* field, Scratch& scratch) const
{
  for (int batch = 0; batch < batches(); ++batch)
    rows_inverse(rows, plane, batch, field, scratch);
}

void BlockedFft::rows_inverse(const ComplexLanes* rows, int plane, int batch, double* field, Scratch& scratch) const
{
  const int first = batch * RowFft::most_rows;
  rows_.inverse(rows + rows_at(0, plane) + first, rows_layout(), std::min(RowFft::most_rows, stored_rows() - first),
                1.0 / (static_cast<double>(px()) * py()), field + static_cast<std::ptrdiff_t>(first) * grid_.nx,
                scratch.rows);
}

void BlockedFft::rows_inverse_from(const ComplexLanes* rows, const RowFft::Spectra& apart, double* field,
                                   Scratch& scratch) const
{
  for (int first = 0; first < stored_rows(); first += RowFft::most_rows)
    rows_.inverse(rows + first, apart, std::min(RowFft::most_rows, stored_rows() - first),
                  1.0 / (static_cast<double>(px()) * py()), field + static_cast<std::ptrdiff_t>(first) * grid_.nx,
                  scratch.rows);
}

} // namespace brinell
