// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/foundation/blocked_fft.hpp"

#include "brinell/foundation/error.hpp"
#include "foundation/planner_lock.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <fftw3.h>

namespace brinell
{

namespace
{

constexpr std::size_t lane_bytes = lane_count * sizeof(Complex);
constexpr std::size_t batch_bytes = 64 * 1024; ///< of a batch of rows, before and after: a part of the second cache

fftw_complex* as_fftw(Complex* c)
{
  return reinterpret_cast<fftw_complex*>(c);
}

std::size_t product(int a, int b, int c, int d = 1)
{
  return static_cast<std::size_t>(a) * static_cast<std::size_t>(b) * static_cast<std::size_t>(c) *
         static_cast<std::size_t>(d);
}

} // namespace

/// Transforms of a batch of rows.
struct RowPlans
{
  fftw_plan forward = nullptr, inverse = nullptr;
};

/// Out of place throughout: in place, FFTW's transforms of a few neighbouring columns take about half as long again.
struct BlockedFft::Plans
{
  RowPlans batch, last_batch;
  fftw_plan columns_forward = nullptr, columns_inverse = nullptr;

  Plans(const BlockedFft& f, Scratch& scratch)
  {
    // ESTIMATE keeps the choice of algorithm, and so the last bit of every result, the same from run to run.
    const unsigned flags = FFTW_ESTIMATE;
    const auto lock = planner_lock();
    const int width = f.width();
    const int pitch = f.pitch() * lane_count;
    auto* half = as_fftw(scratch.half.data());
    double* real = scratch.real.data();
    const auto rows = [&](int count)
    {
      return RowPlans{fftw_plan_many_dft_r2c(1, &f.px_, count, real, nullptr, 1, f.px_, half, nullptr, 1, width,
                                             flags | FFTW_DESTROY_INPUT),
                      fftw_plan_many_dft_c2r(1, &f.px_, count, half, nullptr, 1, width, real, nullptr, 1, f.px_,
                                             flags | FFTW_DESTROY_INPUT)};
    };
    batch = rows(f.batch_rows_);
    last_batch = rows(f.rows_in(f.batches() - 1));
    AlignedVector<Complex> block(f.block_size());
    auto* spectrum = as_fftw(block.data());
    columns_forward = fftw_plan_many_dft(1, &f.py_, lane_count, as_fftw(scratch.padded.data()), nullptr, lane_count, 1,
                                         spectrum, nullptr, pitch, 1, FFTW_FORWARD, flags | FFTW_PRESERVE_INPUT);
    columns_inverse =
        fftw_plan_many_dft(1, &f.py_, lane_count, spectrum, nullptr, pitch, 1, as_fftw(scratch.column.data()), nullptr,
                           lane_count, 1, FFTW_BACKWARD, flags | FFTW_PRESERVE_INPUT);
    for (fftw_plan p : all())
      if (!p)
        throw InternalError("FFTW made no plan");
  }
  [[nodiscard]] std::array<fftw_plan, 6> all() const
  {
    return {batch.forward, batch.inverse, last_batch.forward, last_batch.inverse, columns_forward, columns_inverse};
  }
  ~Plans()
  {
    const auto lock = planner_lock();
    for (fftw_plan p : all())
      fftw_destroy_plan(p);
  }
  Plans(const Plans&) = delete;
  Plans& operator=(const Plans&) = delete;
};

BlockedFft::BlockedFft(const SurfaceGrid& grid, int px, int py, int planes)
    : grid_(grid), px_(px), py_(py), planes_(planes)
{
  if (grid.nx < 1 || grid.ny < 1 || planes < 1 || px < grid.nx || py < grid.ny || px % 2 != 0 || py % 2 != 0)
    throw InternalError("BlockedFft: the padded lengths must be even and hold the grid");
  const std::size_t row_bytes =
      static_cast<std::size_t>(px) * sizeof(double) + static_cast<std::size_t>(width()) * sizeof(Complex);
  batch_rows_ = std::clamp(static_cast<int>(batch_bytes / row_bytes), 1, grid.ny);
  Scratch scratch = make_scratch();
  plans_ = std::make_unique<Plans>(*this, scratch);
}

BlockedFft::~BlockedFft() = default;

std::size_t BlockedFft::rows_size() const
{
  return product(blocks(), planes_, grid_.ny, lane_count);
}

std::size_t BlockedFft::block_size() const
{
  return product(py_, pitch(), lane_count);
}

std::size_t BlockedFft::rows_at(int block, int plane) const
{
  return (static_cast<std::size_t>(block) * static_cast<std::size_t>(planes_) + static_cast<std::size_t>(plane)) *
         product(grid_.ny, lane_count, 1);
}

BlockedFft::Scratch BlockedFft::make_scratch() const
{
  Scratch scratch;
  scratch.real.resize(product(batch_rows_, px_, 1));
  scratch.half.resize(product(batch_rows_, width(), 1));
  scratch.padded.resize(product(py_, lane_count, 1));
  scratch.column.resize(product(py_, lane_count, 1));
  return scratch;
}

int BlockedFft::rows_in(int batch) const
{
  return std::min(batch_rows_, grid_.ny - batch * batch_rows_);
}

void BlockedFft::rows_forward(const double* field, int plane, Complex* rows, Scratch& scratch) const
{
  for (int batch = 0; batch < batches(); ++batch)
    rows_forward(field, plane, batch, rows, scratch);
}

void BlockedFft::rows_forward(const double* field, int plane, int batch, Complex* rows, Scratch& scratch) const
{
  const std::ptrdiff_t nx = grid_.nx;
  const int first = batch * batch_rows_;
  const int count = rows_in(batch);
  for (std::ptrdiff_t j = 0; j < count; ++j)
  {
    double* padding = std::copy_n(field + (first + j) * nx, nx, scratch.real.data() + j * px_);
    std::fill_n(padding, px_ - nx, 0.0);
  }
  const RowPlans& plans = count == batch_rows_ ? plans_->batch : plans_->last_batch;
  fftw_execute_dft_r2c(plans.forward, scratch.real.data(), as_fftw(scratch.half.data()));
  for (int block = 0; block < blocks(); ++block)
  {
    Complex* to = rows + rows_at(block, plane) + first * lane_count;
    const Complex* from = scratch.half.data() + block * lane_count;
    for (int j = 0; j < count; ++j, to += lane_count, from += width())
      std::memcpy(to, from, lane_bytes);
  }
}

void BlockedFft::columns_forward(const Complex* rows, int block, int plane, Complex* spectrum, Scratch& scratch) const
{
  std::copy_n(rows + rows_at(block, plane), product(grid_.ny, lane_count, 1), scratch.padded.data());
  fftw_execute_dft(plans_->columns_forward, as_fftw(scratch.padded.data()), as_fftw(spectrum + plane * lane_count));
}

void BlockedFft::columns_inverse(const Complex* spectrum, int block, int plane, Complex* rows, Scratch& scratch) const
{
  auto* from = as_fftw(const_cast<Complex*>(spectrum) + plane * lane_count); // planned to preserve its input
  fftw_execute_dft(plans_->columns_inverse, from, as_fftw(scratch.column.data()));
  std::copy_n(scratch.column.data(), product(grid_.ny, lane_count, 1), rows + rows_at(block, plane));
}

void BlockedFft::rows_inverse(const Complex* rows, int plane, double* field, Scratch& scratch) const
{
  for (int batch = 0; batch < batches(); ++batch)
    rows_inverse(rows, plane, batch, field, scratch);
}

void BlockedFft::rows_inverse(const Complex* rows, int plane, int batch, double* field, Scratch& scratch) const
{
  const int first = batch * batch_rows_;
  const int count = rows_in(batch);
  for (int block = 0; block < blocks(); ++block)
  {
    const Complex* from = rows + rows_at(block, plane) + first * lane_count;
    Complex* to = scratch.half.data() + block * lane_count;
    for (int j = 0; j < count; ++j, from += lane_count, to += width())
      std::memcpy(to, from, lane_bytes);
  }
  const RowPlans& plans = count == batch_rows_ ? plans_->batch : plans_->last_batch;
  fftw_execute_dft_c2r(plans.inverse, as_fftw(scratch.half.data()), scratch.real.data());
  const double scale = 1.0 / (static_cast<double>(px_) * py_);
  const std::ptrdiff_t nx = grid_.nx;
  for (std::ptrdiff_t j = 0; j < count; ++j)
    for (std::ptrdiff_t i = 0; i < nx; ++i)
      field[(first + j) * nx + i] = scale * scratch.real[static_cast<std::size_t>(j * px_ + i)];
}

} // namespace brinell
