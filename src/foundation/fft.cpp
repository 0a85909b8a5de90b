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
    : fft_(grid, px, py, 1), full_({px, py, grid.dx, grid.dy}, px, py, 1), phase_(phases_of_mirror(grid.ny, py))
{
}

double PaddedFft::wavenumber_x(int i) const
{
  return 2.0 * std::numbers::pi * i / (px() * grid().dx);
}

double PaddedFft::wavenumber_y(int j) const
{
  return 2.0 * std::numbers::pi * (j <= py() / 2 ? j : j - py()) / (py() * grid().dy);
}

std::unique_ptr<PaddedFft::Work> PaddedFft::WorkPool::acquire()
{
  const std::lock_guard lock(mutex_);
  if (idle_.empty())
    return nullptr;
  std::unique_ptr<Work> work = std::move(idle_.back());
  idle_.pop_back();
  return work;
}

void PaddedFft::WorkPool::release(std::unique_ptr<Work> work)
{
  const std::lock_guard lock(mutex_);
  idle_.push_back(std::move(work));
}

std::unique_ptr<PaddedFft::Work> PaddedFft::acquire_work() const
{
  if (std::unique_ptr<Work> idle = pool_->acquire())
    return idle;
  return std::make_unique<Work>(Work{fft_.make_scratch(), {}, {}});
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

void PaddedFft::forward(const BlockedFft& fft, std::span<const double> field, Complex* spectrum) const
{
  std::unique_ptr<Work> acquired = acquire_work();
  Work& work = *acquired;
  work.rows.resize(std::max(work.rows.size(), fft.rows_size()));
  fft.rows_forward(field.data(), 0, work.rows.data(), work.blocked);
  for (int block = 0; block < fft.blocks(); ++block)
  {
    fft.columns_forward(work.rows.data(), block, 0, work.blocked.column.data(), work.blocked);
    const int first = block * lane_count;
    for (int n = 0; n < rows(); ++n)
      store_row(work.blocked.column[static_cast<std::size_t>(n)], kx() - first,
                spectrum + static_cast<std::ptrdiff_t>(n) * kx() + first);
  }
  pool_->release(std::move(acquired));
}

void PaddedFft::forward(std::span<const double> field, Complex* spectrum) const
{
  forward(fft_, field, spectrum);
}

AlignedVector<Complex> PaddedFft::forward(std::span<const double> field) const
{
  AlignedVector<Complex> spectrum(plane());
  forward(fft_, field, spectrum.data());
  return spectrum;
}

AlignedVector<Complex> PaddedFft::forward_padded(std::span<const double> field) const
{
  AlignedVector<Complex> spectrum(plane());
  forward(full_, field, spectrum.data());
  return spectrum;
}

void PaddedFft::complete(const Complex* stored, Complex* all) const
{
  const std::ptrdiff_t columns = kx();
  for (int n = 0; n < rows(); ++n)
  {
    const Complex* row = stored + n * columns;
    std::copy_n(row, columns, all + n * columns);
    if (!is_mirrored() || n == 0 || 2 * n >= py())
      continue;
    const Complex phase = phase_[static_cast<std::size_t>(n)];
    std::transform(row, row + columns, all + (py() - n) * columns,
                   [phase](const Complex& wave) { return phase * wave; });
  }
}

namespace
{

/// Loads `lane_count` neighbouring columns of a row; zero from `columns` on.
ComplexLanes load_columns(const Complex* row, int first, int columns)
{
  return load_lanes(row + first, static_cast<std::size_t>(std::clamp(columns - first, 0, lane_count)));
}

} // namespace

/// Completes all rows of neighbouring columns from the independent ones. For an odd field the opposite rows have the opposite
/// sign.
void PaddedFft::fill_column(const Pair& pair, int first, ComplexLanes* column) const
{
  const std::ptrdiff_t apart = kx();
  for (int n = 0; n < rows(); ++n)
  {
    ComplexLanes even, odd;
    if (pair.even != nullptr)
      even = load_columns(pair.even->waves + n * apart, first, pair.even->columns);
    if (pair.odd != nullptr)
      odd = load_columns(pair.odd->waves + n * apart, first, pair.odd->columns);
    column[n] = even + odd;
    if (!is_mirrored() || n == 0 || 2 * n >= py())
      continue;
    const Complex phase = phase_[static_cast<std::size_t>(n)];
    const ComplexLanes opposite = even - odd;
    column[py() - n] = phase.real() * opposite + phase.imag() * times_i(opposite);
  }
}

/// Inverse transform along y: the first `rows` rows of the field, as waves along x.
/// @param apart  values from one block to the next in `to`
void PaddedFft::invert_columns(const Pair& pair, int rows, ComplexLanes* to, int apart, Work& work) const
{
  const int columns =
      std::max(pair.even != nullptr ? pair.even->columns : 0, pair.odd != nullptr ? pair.odd->columns : 0);
  for (int block = 0; block < fft_.along_x().blocks(); ++block, to += apart)
  {
    if (block * lane_count >= columns)
    {
      std::fill_n(to, rows, ComplexLanes{});
      continue;
    }
    fill_column(pair, block * lane_count, work.blocked.column.data());
    fft_.along_y().inverse(work.blocked.column.data(), to, rows, work.blocked.work.data());
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
void write_parts(const SurfaceGrid& g, const PaddedFft::Window& window, const double* field, double* even, double* odd)
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
int PaddedFft::rows_of(std::size_t pair, const Batch& batch) const
{
  const int ny = grid().ny;
  const bool is_whole = !is_mirrored() || (pair < batch.even.size() && pair < batch.odd.size());
  return is_whole ? ny : (ny + 1) / 2;
}

/// The rows of all fields are stored contiguously, so that as many rows as possible are transformed together.
void PaddedFft::invert(const Batch& batch, bool adds, Work& work) const
{
  const SurfaceGrid& g = grid();
  const double scale = 1.0 / (static_cast<double>(px()) * py());
  const std::size_t pairs = std::max(batch.even.size(), batch.odd.size());
  int rows = 0;
  for (std::size_t n = 0; n < pairs; ++n)
    rows += rows_of(n, batch);
  const auto all_rows = static_cast<std::size_t>(rows);
  work.field.resize(std::max(work.field.size(), all_rows * static_cast<std::size_t>(g.nx)));
  work.rows.resize(std::max(work.rows.size(), all_rows * static_cast<std::size_t>(fft_.blocks())));
  int first = 0;
  for (std::size_t n = 0; n < pairs; first += rows_of(n, batch), ++n)
    invert_columns({n < batch.even.size() ? &batch.spectra[batch.even[n]] : nullptr,
                    n < batch.odd.size() ? &batch.spectra[batch.odd[n]] : nullptr},
                   rows_of(n, batch), work.rows.data() + first, rows, work);
  for (first = 0; first < rows; first += RowFft::most_rows)
    fft_.along_x().inverse(work.rows.data() + first, {rows, false}, std::min(RowFft::most_rows, rows - first), scale,
                           work.field.data() + static_cast<std::ptrdiff_t>(first) * g.nx, work.blocked.rows);
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

void PaddedFft::inverse(std::span<const Spectrum> spectra, const std::vector<bool>& is_odd, bool adds,
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

void PaddedFft::inverse(const Complex* spectrum, std::span<double> field, bool is_odd) const
{
  const Spectrum one{spectrum, kx()};
  inverse({&one, 1}, {is_odd}, false, {field});
}

} // namespace brinell
