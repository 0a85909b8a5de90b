// SPDX-License-Identifier: BSD-3-Clause
#include "foundation/blocked_fft.hpp"

#include "brinell/foundation/error.hpp"
#include "foundation/lane_functions.hpp"
#include "foundation/planner_lock.hpp"

#include <algorithm>
#include <array>
#include <fftw3.h>

namespace brinell
{

namespace
{

constexpr std::size_t batch_bytes = 64 * 1024; ///< of a batch of rows, before and after: a part of the second cache

fftw_complex* as_fftw(Complex* c)
{
  return reinterpret_cast<fftw_complex*>(c);
}

std::size_t product(int a, int b, int c = 1)
{
  return static_cast<std::size_t>(a) * static_cast<std::size_t>(b) * static_cast<std::size_t>(c);
}

} // namespace

/// Rows one by one: FFTW's estimate chooses better for one than for many.
struct BlockedFft::Plans
{
  fftw_plan row_forward = nullptr, row_inverse = nullptr;

  Plans(const BlockedFft& f, Scratch& scratch)
  {
    // ESTIMATE keeps the choice of algorithm, and so the last bit of every result, the same from run to run.
    const unsigned flags = FFTW_ESTIMATE | FFTW_DESTROY_INPUT;
    const auto lock = planner_lock();
    double* real = scratch.real.data();
    auto* half = as_fftw(scratch.half.data());
    row_forward = fftw_plan_dft_r2c_1d(f.px_, real, half, flags);
    row_inverse = fftw_plan_dft_c2r_1d(f.px_, half, real, flags);
    if (!row_forward || !row_inverse)
      throw InternalError("FFTW made no plan");
  }
  ~Plans()
  {
    const auto lock = planner_lock();
    fftw_destroy_plan(row_forward);
    fftw_destroy_plan(row_inverse);
  }
  Plans(const Plans&) = delete;
  Plans& operator=(const Plans&) = delete;
};

BlockedFft::BlockedFft(const SurfaceGrid& grid, int px, int py, int planes)
    : grid_(grid), px_(px), planes_(planes), columns_(std::max(py, 1))
{
  if (grid.nx < 1 || grid.ny < 1 || planes < 1 || px < grid.nx || py < grid.ny)
    throw InternalError("BlockedFft: the padded lengths must hold the grid");
  const std::size_t row_bytes = product(px, sizeof(double)) + product(width(), sizeof(Complex));
  batch_rows_ = std::clamp(static_cast<int>(batch_bytes / row_bytes), 1, grid.ny);
  Scratch scratch = make_scratch();
  plans_ = std::make_unique<Plans>(*this, scratch);
}

BlockedFft::~BlockedFft() = default;

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
  Scratch scratch;
  scratch.real.resize(product(px_, 1));
  scratch.half.resize(product(batch_rows_, width()));
  scratch.column.resize(product(py(), 1));
  scratch.work.resize(columns_.work_size());
  return scratch;
}

int BlockedFft::rows_in(int batch) const
{
  return std::min(batch_rows_, grid_.ny - batch * batch_rows_);
}

void BlockedFft::rows_forward(const double* field, int plane, ComplexLanes* rows, Scratch& scratch) const
{
  for (int batch = 0; batch < batches(); ++batch)
    rows_forward(field, plane, batch, rows, scratch);
}

void BlockedFft::rows_forward(const double* field, int plane, int batch, ComplexLanes* rows, Scratch& scratch) const
{
  const std::ptrdiff_t nx = grid_.nx;
  const int first = batch * batch_rows_;
  const int count = rows_in(batch);
  for (std::ptrdiff_t j = 0; j < count; ++j)
  {
    double* padding = std::copy_n(field + (first + j) * nx, nx, scratch.real.data());
    std::fill_n(padding, px_ - nx, 0.0);
    fftw_execute_dft_r2c(plans_->row_forward, scratch.real.data(), as_fftw(scratch.half.data() + j * width()));
  }
  const bool past_caches = rows_size() * sizeof(ComplexLanes) > cached_bytes;
  for (int block = 0; block < blocks(); ++block)
  {
    ComplexLanes* to = rows + rows_at(block, plane) + first;
    const Complex* from = scratch.half.data() + block * lane_count;
    for (int j = 0; j < count; ++j, ++to, from += width())
      store_lanes(load_lanes(from), to, past_caches);
  }
  end_streaming();
}

void BlockedFft::columns_forward(const ComplexLanes* rows, int block, int plane, ComplexLanes* column,
                                 Scratch& scratch) const
{
  columns_.forward(rows + rows_at(block, plane), grid_.ny, column, scratch.work.data());
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
  const int first = batch * batch_rows_;
  const int count = rows_in(batch);
  for (int block = 0; block < blocks(); ++block)
  {
    const ComplexLanes* from = rows + rows_at(block, plane) + first;
    Complex* to = scratch.half.data() + block * lane_count;
    for (int j = 0; j < count; ++j, ++from, to += width())
      store_lanes(*from, to);
  }
  const double scale = 1.0 / (static_cast<double>(px_) * py());
  const std::ptrdiff_t nx = grid_.nx;
  for (std::ptrdiff_t j = 0; j < count; ++j)
  {
    fftw_execute_dft_c2r(plans_->row_inverse, as_fftw(scratch.half.data() + j * width()), scratch.real.data());
    double* to = field + (first + j) * nx;
    for (std::ptrdiff_t i = 0; i < nx; ++i)
      to[i] = scale * scratch.real[static_cast<std::size_t>(i)];
  }
}

} // namespace brinell
