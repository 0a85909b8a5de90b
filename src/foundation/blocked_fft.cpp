// SPDX-License-Identifier: BSD-3-Clause
#include "foundation/blocked_fft.hpp"

#include "brinell/foundation/error.hpp"
#include "foundation/lane_functions.hpp"

#include <algorithm>

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

BlockedFft::BlockedFft(const SurfaceGrid& grid, int px, int py, int planes)
    : grid_(checked(grid, px, py, planes)), planes_(planes), rows_(grid.nx, px), columns_(py)
{
}

std::size_t BlockedFft::rows_size() const
{
  return product(blocks(), planes_, grid_.ny);
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
  return (static_cast<std::ptrdiff_t>(block) * planes_ + plane) * grid_.ny;
}

BlockedFft::Scratch BlockedFft::make_scratch() const
{
  return {rows_.make_work(), AlignedVector<ComplexLanes>(product(py(), 1)),
          AlignedVector<ComplexLanes>(columns_.work_size())};
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
  rows_.forward(field + static_cast<std::ptrdiff_t>(first) * grid_.nx, std::min(RowFft::most_rows, grid_.ny - first),
                rows + rows_at(0, plane) + first, rows_layout(), scratch.rows);
}

void BlockedFft::columns_forward(const ComplexLanes* rows, int block, int plane, ComplexLanes* column,
                                 Scratch& scratch) const
{
  const ComplexLanes* series = rows + rows_at(block, plane);
  for (int j = 0; plane + 1 < planes_ && j < grid_.ny; ++j)
    fetch_soon(series + grid_.ny + j); // of the next plane
  columns_.forward(series, grid_.ny, column, scratch.work.data());
}

void BlockedFft::columns_inverse(const ComplexLanes* column, int block, int plane, ComplexLanes* rows,
                                 Scratch& scratch) const
{
  columns_.inverse(column, rows + rows_at(block, plane), grid_.ny, scratch.work.data());
}

void BlockedFft::rows_inverse(const ComplexLanes* rows, int plane, double* field, Scratch& scratch) const
{
  for (int batch = 0; batch < batches(); ++batch)
    rows_inverse(rows, plane, batch, field, scratch);
}

void BlockedFft::rows_inverse(const ComplexLanes* rows, int plane, int batch, double* field, Scratch& scratch) const
{
  const int first = batch * RowFft::most_rows;
  rows_.inverse(rows + rows_at(0, plane) + first, rows_layout(), std::min(RowFft::most_rows, grid_.ny - first),
                1.0 / (static_cast<double>(px()) * py()), field + static_cast<std::ptrdiff_t>(first) * grid_.nx,
                scratch.rows);
}

} // namespace brinell
