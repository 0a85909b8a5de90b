// SPDX-License-Identifier: BSD-3-Clause
#include "independent_rows_fft.hpp"

#include "brinell/foundation/error.hpp"
#include "foundation/lane_functions.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace brinell::halfspace
{

double PlaneOfWaves::wavenumber_x(int column) const
{
  return 2.0 * std::numbers::pi * column / (px_ * grid_.dx);
}

double PlaneOfWaves::wavenumber_y(int row) const
{
  return 2.0 * std::numbers::pi * (row <= py_ / 2 ? row : row - py_) / (py_ * grid_.dy);
}

IndependentRowsFft::IndependentRowsFft(const SurfaceGrid& grid, int px, int py)
    : full_plane_(grid, px, py), columns_(py), row_fft_(std::make_unique<const RowFft>(grid.nx, px)),
      rows_(grid.is_mirrored_y ? py / 2 + 1 : py),
      plane_(PlaneOfWaves::whole_lines(static_cast<std::size_t>(full_plane_.kx()) * static_cast<std::size_t>(rows_)))
{
  if (grid.nx < 1 || grid.ny < 1 || px < grid.nx || py < grid.ny)
    throw InternalError("IndependentRowsFft: the padded lengths must hold the grid");
  for (int n = 0; n < rows_; ++n)
    phase_.push_back(std::polar(1.0, 2.0 * std::numbers::pi * n * (grid.ny - 1) / py));
}

std::unique_ptr<IndependentRowsFft::Work> IndependentRowsFft::WorkPool::acquire()
{
  const std::lock_guard lock(mutex_);
  if (idle_.empty())
    return nullptr;
  std::unique_ptr<Work> work = std::move(idle_.back());
  idle_.pop_back();
  return work;
}

void IndependentRowsFft::WorkPool::release(std::unique_ptr<Work> work)
{
  const std::lock_guard lock(mutex_);
  idle_.push_back(std::move(work));
}

std::unique_ptr<IndependentRowsFft::Work> IndependentRowsFft::acquire_work() const
{
  if (std::unique_ptr<Work> idle = pool_->acquire())
    return idle;
  const auto py = static_cast<std::size_t>(full_plane_.py()), ny = static_cast<std::size_t>(full_plane_.grid().ny);
  return std::make_unique<Work>(Work{AlignedVector<ComplexLanes>(py), AlignedVector<ComplexLanes>(columns_.work_size()),
                                     AlignedVector<ComplexLanes>(static_cast<std::size_t>(row_fft_->blocks()) * ny),
                                     row_fft_->make_work(), std::vector<double>(full_plane_.grid().size())});
}

AlignedVector<Complex> IndependentRowsFft::forward(std::span<const double> field) const
{
  const SurfaceGrid& g = full_plane_.grid();
  std::unique_ptr<Work> acquired = acquire_work();
  Work& work = *acquired;
  for (int first = 0; first < g.ny; first += RowFft::most_rows)
    row_fft_->forward(field.data() + g.index(0, first), std::min(RowFft::most_rows, g.ny - first),
                      work.rows.data() + first, {g.ny, false}, work.row);
  AlignedVector<Complex> spectrum(plane_);
  for (int block = 0; block < row_fft_->blocks(); ++block)
  {
    columns_.forward(work.rows.data() + static_cast<std::ptrdiff_t>(block) * g.ny, g.ny, work.column.data(),
                     work.lanes.data());
    const int first = block * lane_count, count = std::min(lane_count, full_plane_.kx() - first);
    for (int n = 0; n < rows_; ++n)
    {
      const ComplexLanes& value = work.column[static_cast<std::size_t>(n)];
      Complex* to = spectrum.data() + static_cast<std::ptrdiff_t>(n) * full_plane_.kx() + first;
      if (count == lane_count)
        store_lanes(value, to);
      else
        for (int lane = 0; lane < count; ++lane)
          to[lane] = {value.re[lane], value.im[lane]};
    }
  }
  pool_->release(std::move(acquired));
  return spectrum;
}

void IndependentRowsFft::complete(const Complex* rows, Complex* all) const
{
  const std::ptrdiff_t columns = full_plane_.kx();
  for (int n = 0; n < rows_; ++n)
  {
    const Complex phase = phase_[static_cast<std::size_t>(n)];
    const std::ptrdiff_t row_offset = n * columns, opposite_offset = (full_plane_.py() - n) * columns;
    std::copy_n(rows + row_offset, columns, all + row_offset);
    if (is_mirrored() && n > 0 && 2 * n < full_plane_.py())
      std::transform(rows + row_offset, rows + row_offset + columns, all + opposite_offset,
                     [&](const Complex& wave) { return phase * wave; });
  }
}

namespace
{

/// Loads `lane_count` neighbouring columns of a row; zero from `columns` on.
ComplexLanes load_columns(const Complex* row, int first, int columns)
{
  ComplexLanes value = load_lanes(row + first);
  if (columns - first >= lane_count)
    return value;
  Lanes number;
  for (int lane = 0; lane < lane_count; ++lane)
    number[lane] = lane;
  const auto is_there = number < static_cast<double>(columns - first);
  return {is_there ? value.re : Lanes{}, is_there ? value.im : Lanes{}};
}

} // namespace

/// Completes all rows of neighbouring columns from the independent ones. For an odd field the opposite rows have the opposite
/// sign.
void IndependentRowsFft::fill_column(const Pair& pair, int first, ComplexLanes* column) const
{
  const std::ptrdiff_t apart = full_plane_.kx();
  for (int n = 0; n < rows_; ++n)
  {
    ComplexLanes even, odd;
    if (pair.even != nullptr)
      even = load_columns(pair.even->waves + n * apart, first, pair.even->columns);
    if (pair.odd != nullptr)
      odd = load_columns(pair.odd->waves + n * apart, first, pair.odd->columns);
    column[n] = even + odd;
    if (!is_mirrored() || n == 0 || 2 * n >= full_plane_.py())
      continue;
    const Complex phase = phase_[static_cast<std::size_t>(n)];
    const ComplexLanes opposite = even - odd;
    column[full_plane_.py() - n] = phase.real() * opposite + phase.imag() * times_i(opposite);
  }
}

/// Inverse transform along y: the first `rows` rows of the field, as waves along x.
/// @param apart  values from one block to the next in `to`
void IndependentRowsFft::invert_columns(const Pair& pair, int rows, ComplexLanes* to, int apart, Work& work) const
{
  const int columns =
      std::max(pair.even != nullptr ? pair.even->columns : 0, pair.odd != nullptr ? pair.odd->columns : 0);
  for (int block = 0; block < row_fft_->blocks(); ++block, to += apart)
  {
    if (block * lane_count >= columns)
    {
      std::fill_n(to, rows, ComplexLanes{});
      continue;
    }
    fill_column(pair, block * lane_count, work.column.data());
    columns_.inverse(work.column.data(), to, rows, work.lanes.data());
  }
}

namespace
{

template <bool adds>
void write_value(double value, double& to)
{
  to = adds ? to + value : value;
}

/// Splits a field into its parts that are even and odd about the middle row, in a window.
/// @param even, odd  outputs; one of them may be nullptr, then the field consists of the other part only
template <bool adds>
void write_parts(const SurfaceGrid& g, const IndependentRowsFft::Window& window, const double* field, double* even,
                 double* odd)
{
  const int columns = window.columns;
  for (int j = window.first_row; 2 * j < g.ny; ++j)
  {
    const int to_row = j - window.first_row, to_opposite = g.ny - 1 - j - window.first_row;
    const std::ptrdiff_t row_offset = static_cast<std::ptrdiff_t>(to_row) * columns,
                         opposite_offset = static_cast<std::ptrdiff_t>(to_opposite) * columns;
    const bool is_middle = row_offset == opposite_offset;
    const double *at = field + g.index(window.first_column, j),
                 *opposite = field + g.index(window.first_column, g.ny - 1 - j);
    if (even == nullptr || odd == nullptr)
    {
      double *to = (even != nullptr ? even : odd) + row_offset,
             *mirrored = (even != nullptr ? even : odd) + opposite_offset;
      const double sign = even != nullptr ? 1.0 : -1.0, middle_factor = is_middle && odd != nullptr ? 0.0 : 1.0;
      for (int i = 0; i < columns; ++i)
        write_value<adds>(middle_factor * at[i], to[i]);
      for (int i = 0; i < columns && !is_middle; ++i)
        write_value<adds>(sign * at[i], mirrored[i]);
      continue;
    }
    for (int i = 0; i < columns; ++i)
    {
      write_value<adds>(0.5 * (at[i] + opposite[i]), even[row_offset + i]);
      write_value<adds>(0.5 * (at[i] - opposite[i]), odd[row_offset + i]);
    }
    for (int i = 0; i < columns && !is_middle; ++i)
    {
      write_value<adds>(0.5 * (at[i] + opposite[i]), even[opposite_offset + i]);
      write_value<adds>(0.5 * (opposite[i] - at[i]), odd[opposite_offset + i]);
    }
  }
}

} // namespace

/// Number of rows to compute for a pair: all rows for an even and an odd field together; half of them for one field alone.
int IndependentRowsFft::rows_of(std::size_t pair, const Batch& batch) const
{
  const int ny = full_plane_.grid().ny;
  const bool is_whole = !is_mirrored() || (pair < batch.even.size() && pair < batch.odd.size());
  return is_whole ? ny : (ny + 1) / 2;
}

/// The rows of all fields are stored contiguously, so that as many rows as possible are transformed together.
void IndependentRowsFft::invert(const Batch& batch, bool adds, Work& work) const
{
  const SurfaceGrid& g = full_plane_.grid();
  const double scale = 1.0 / (static_cast<double>(full_plane_.px()) * full_plane_.py());
  const std::size_t pairs = std::max(batch.even.size(), batch.odd.size());
  int rows = 0;
  for (std::size_t n = 0; n < pairs; ++n)
    rows += rows_of(n, batch);
  const auto all_rows = static_cast<std::size_t>(rows);
  if (work.field.size() < all_rows * static_cast<std::size_t>(g.nx))
  {
    work.field.resize(all_rows * static_cast<std::size_t>(g.nx));
    work.rows.resize(all_rows * static_cast<std::size_t>(row_fft_->blocks()));
  }
  int first = 0;
  for (std::size_t n = 0; n < pairs; first += rows_of(n, batch), ++n)
    invert_columns({n < batch.even.size() ? &batch.spectra[batch.even[n]] : nullptr,
                    n < batch.odd.size() ? &batch.spectra[batch.odd[n]] : nullptr},
                   rows_of(n, batch), work.rows.data() + first, rows, work);
  for (first = 0; first < rows; first += RowFft::most_rows)
    row_fft_->inverse(work.rows.data() + first, {rows, false}, std::min(RowFft::most_rows, rows - first), scale,
                      work.field.data() + static_cast<std::ptrdiff_t>(first) * g.nx, work.row);
  const double* field = work.field.data();
  for (std::size_t n = 0; n < pairs; field += static_cast<std::ptrdiff_t>(rows_of(n, batch)) * g.nx, ++n)
  {
    double* even = n < batch.even.size() ? batch.fields[batch.even[n]].data() : nullptr;
    double* odd = n < batch.odd.size() ? batch.fields[batch.odd[n]].data() : nullptr;
    const Window& window = batch.window;
    if (is_mirrored())
    {
      (adds ? write_parts<true> : write_parts<false>)(g, window, field, even, odd);
      continue;
    }
    for (int j = 0; j < window.rows; ++j, even += window.columns)
    {
      const double* from = field + g.index(window.first_column, window.first_row + j);
      for (int i = 0; i < window.columns; ++i)
        even[i] = adds ? even[i] + from[i] : from[i];
    }
  }
}

void IndependentRowsFft::inverse(std::span<const Spectrum> spectra, const std::vector<bool>& is_odd, bool adds,
                                 const std::vector<std::span<double>>& fields, const Window& window) const
{
  std::unique_ptr<Work> work = acquire_work();
  const std::size_t count = is_odd.size();
  std::vector<std::size_t> even, odd; // on a grid that is not mirrored all fields are in `even`
  for (std::size_t f = 0; f < count; ++f)
    (is_odd[f] && is_mirrored() ? odd : even).push_back(f);
  for (std::size_t first = 0; first < fields.size(); first += count)
    invert({spectra.subspan(first, count), std::span(fields).subspan(first, count), even, odd, window}, adds, *work);
  pool_->release(std::move(work));
}

} // namespace brinell::halfspace
