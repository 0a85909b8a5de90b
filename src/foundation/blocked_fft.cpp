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

std::size_t product(int a, int b, int c, int d = 1)
{
  return static_cast<std::size_t>(a) * static_cast<std::size_t>(b) * static_cast<std::size_t>(c) *
         static_cast<std::size_t>(d);
}

} // namespace

/// Out of place throughout: in place, FFTW's transforms of a few neighbouring columns take about half as long again. Rows
/// one by one: FFTW's estimate chooses better for one than for many.
struct BlockedFft::Plans
{
  fftw_plan row_forward = nullptr, row_inverse = nullptr;
  fftw_plan columns_forward = nullptr, columns_inverse = nullptr;

  Plans(const BlockedFft& f, Scratch& scratch)
  {
    // ESTIMATE keeps the choice of algorithm, and so the last bit of every result, the same from run to run.
    const unsigned flags = FFTW_ESTIMATE;
    const auto lock = planner_lock();
    const unsigned destroy = flags | FFTW_DESTROY_INPUT;
    double* real = scratch.real.data();
    auto* half = as_fftw(scratch.half.data());
    row_forward = fftw_plan_dft_r2c_1d(f.px_, real, half, destroy);
    row_inverse = fftw_plan_dft_c2r_1d(f.px_, half, real, destroy);
    const auto along_columns = [&](AlignedVector<Complex>& from, AlignedVector<Complex>& to, int sign)
    {
      return fftw_plan_many_dft(1, &f.py_, lane_count, as_fftw(from.data()), nullptr, lane_count, 1, as_fftw(to.data()),
                                nullptr, lane_count, 1, sign, flags | FFTW_PRESERVE_INPUT);
    };
    columns_forward = along_columns(scratch.padded, scratch.columns, FFTW_FORWARD);
    columns_inverse = along_columns(scratch.columns, scratch.column, FFTW_BACKWARD);
    for (fftw_plan p : all())
      if (!p)
        throw InternalError("FFTW made no plan");
  }
  [[nodiscard]] std::array<fftw_plan, 4> all() const
  {
    return {row_forward, row_inverse, columns_forward, columns_inverse};
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
  if (grid.nx < 1 || grid.ny < 1 || planes < 1 || px < grid.nx || py < grid.ny)
    throw InternalError("BlockedFft: the padded lengths must hold the grid");
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
  scratch.real.resize(static_cast<std::size_t>(px_));
  scratch.half.resize(product(batch_rows_, width(), 1));
  scratch.padded.resize(product(py_, lane_count, 1));
  scratch.column.resize(product(py_, lane_count, 1));
  scratch.columns.resize(product(std::min(group_planes, planes_), py_, lane_count));
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
    double* padding = std::copy_n(field + (first + j) * nx, nx, scratch.real.data());
    std::fill_n(padding, px_ - nx, 0.0);
    fftw_execute_dft_r2c(plans_->row_forward, scratch.real.data(), as_fftw(scratch.half.data() + j * width()));
  }
  for (int block = 0; block < blocks(); ++block)
  {
    Complex* to = rows + rows_at(block, plane) + first * lane_count;
    const Complex* from = scratch.half.data() + block * lane_count;
    for (int j = 0; j < count; ++j, to += lane_count, from += width())
      copy_lanes(from, to, past_caches());
  }
  end_streaming();
}

namespace
{

int planes_in(int group, int planes)
{
  return std::min(BlockedFft::group_planes, planes - group * BlockedFft::group_planes);
}

} // namespace

void BlockedFft::columns_forward(const Complex* rows, int block, int group, int planes, Scratch& scratch) const
{
  Complex* column = scratch.columns.data();
  for (int g = 0; g < planes_in(group, planes); ++g, column += column_size())
  {
    std::copy_n(rows + rows_at(block, group * group_planes + g), grid_column_size(), scratch.padded.data());
    fftw_execute_dft(plans_->columns_forward, as_fftw(scratch.padded.data()), as_fftw(column));
  }
}

void BlockedFft::scatter(const Scratch& scratch, int group, int planes, Complex* spectrum) const
{
  const std::ptrdiff_t count = planes_in(group, planes);
  const Complex* from = scratch.columns.data();
  Complex* to = spectrum + group * group_planes * lane_count;
  for (int row = 0; row < py_; ++row, from += lane_count, to += pitch() * lane_count)
    for (std::ptrdiff_t g = 0; g < count; ++g)
      copy_lanes(from + g * column_size(), to + g * lane_count, false);
}

void BlockedFft::gather(const Complex* spectrum, int group, int planes, Scratch& scratch) const
{
  const std::ptrdiff_t count = planes_in(group, planes);
  const Complex* from = spectrum + group * group_planes * lane_count;
  Complex* to = scratch.columns.data();
  for (int row = 0; row < py_; ++row, from += pitch() * lane_count, to += lane_count)
    for (std::ptrdiff_t g = 0; g < count; ++g)
      copy_lanes(from + g * lane_count, to + g * column_size(), false);
}

void BlockedFft::columns_inverse(Scratch& scratch, int block, int group, int planes, Complex* rows) const
{
  Complex* column = scratch.columns.data(); // planned to be preserved
  for (int g = 0; g < planes_in(group, planes); ++g, column += column_size())
  {
    fftw_execute_dft(plans_->columns_inverse, as_fftw(column), as_fftw(scratch.column.data()));
    const Complex* from = scratch.column.data();
    Complex* to = rows + rows_at(block, group * group_planes + g);
    for (std::ptrdiff_t i = 0; i < grid_column_size(); i += lane_count)
      copy_lanes(from + i, to + i, past_caches());
  }
  end_streaming();
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
      copy_lanes(from, to, false);
  }
  const double scale = 1.0 / (static_cast<double>(px_) * py_);
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
