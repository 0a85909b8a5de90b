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

IndependentRowsFft::IndependentRowsFft(const SurfaceGrid& grid, int px, int py, Symmetry symmetry)
    : all_(grid, px, py), columns_(py), row_fft_(std::make_unique<const RowFft>(grid.nx, px)), symmetry_(symmetry),
      rows_(symmetry == Symmetry::none ? py : py / 2 + 1),
      plane_(PlaneOfWaves::whole_lines(static_cast<std::size_t>(all_.kx()) * static_cast<std::size_t>(rows_)))
{
  if (grid.nx < 1 || grid.ny < 1 || px < grid.nx || py < grid.ny)
    throw InternalError("IndependentRowsFft: the padded lengths must hold the grid");
  for (int n = 0; n < rows_; ++n)
    turn_.push_back(std::polar(1.0, 2.0 * std::numbers::pi * n * (grid.ny - 1) / py));
}

std::unique_ptr<IndependentRowsFft::Work> IndependentRowsFft::Works::take()
{
  const std::lock_guard lock(mutex_);
  if (idle_.empty())
    return nullptr;
  std::unique_ptr<Work> work = std::move(idle_.back());
  idle_.pop_back();
  return work;
}

void IndependentRowsFft::Works::give(std::unique_ptr<Work> work)
{
  const std::lock_guard lock(mutex_);
  idle_.push_back(std::move(work));
}

std::unique_ptr<IndependentRowsFft::Work> IndependentRowsFft::take_work() const
{
  if (std::unique_ptr<Work> idle = works_->take())
    return idle;
  const auto py = static_cast<std::size_t>(all_.py()), ny = static_cast<std::size_t>(all_.grid().ny);
  return std::make_unique<Work>(Work{AlignedVector<ComplexLanes>(py), AlignedVector<ComplexLanes>(columns_.work_size()),
                                     AlignedVector<ComplexLanes>(static_cast<std::size_t>(row_fft_->blocks()) * ny),
                                     row_fft_->make_work(), std::vector<double>(all_.grid().size())});
}

AlignedVector<Complex> IndependentRowsFft::forward(std::span<const double> field) const
{
  const SurfaceGrid& g = all_.grid();
  std::unique_ptr<Work> taken = take_work();
  Work& work = *taken;
  for (int first = 0; first < g.ny; first += RowFft::most_rows)
    row_fft_->forward(field.data() + g.index(0, first), std::min(RowFft::most_rows, g.ny - first),
                      work.rows.data() + first, {g.ny, false}, work.row);
  AlignedVector<Complex> spectrum(plane_);
  for (int block = 0; block < row_fft_->blocks(); ++block)
  {
    columns_.forward(work.rows.data() + static_cast<std::ptrdiff_t>(block) * g.ny, g.ny, work.column.data(),
                     work.lanes.data());
    const int first = block * lane_count, count = std::min(lane_count, all_.kx() - first);
    for (int n = 0; n < rows_; ++n)
    {
      const ComplexLanes& value = work.column[static_cast<std::size_t>(n)];
      Complex* to = spectrum.data() + static_cast<std::ptrdiff_t>(n) * all_.kx() + first;
      if (count == lane_count)
        store_lanes(value, to);
      else
        for (int lane = 0; lane < count; ++lane)
          to[lane] = {value.re[lane], value.im[lane]};
    }
  }
  works_->give(std::move(taken));
  return spectrum;
}

void IndependentRowsFft::complete(const Complex* rows, Complex* all) const
{
  const std::ptrdiff_t columns = all_.kx();
  for (int n = 0; n < rows_; ++n)
  {
    const Complex turn = turn_[static_cast<std::size_t>(n)];
    const std::ptrdiff_t here = n * columns, there = (all_.py() - n) * columns;
    std::copy_n(rows + here, columns, all + here);
    if (symmetry_ != Symmetry::none && n > 0 && 2 * n < all_.py())
      std::transform(rows + here, rows + here + columns, all + there, [&](const Complex& wave) { return turn * wave; });
  }
}

namespace
{

/// Some neighbouring columns of a row; zero beyond the last one that there is.
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

/// All rows of some neighbouring columns. Of an odd field the opposite rows have the other sign.
void IndependentRowsFft::fill_column(const Pair& pair, int first, ComplexLanes* column) const
{
  const std::ptrdiff_t apart = all_.kx();
  for (int n = 0; n < rows_; ++n)
  {
    ComplexLanes even, odd;
    if (pair.even != nullptr)
      even = load_columns(pair.even->waves + n * apart, first, pair.even->columns);
    if (pair.odd != nullptr)
      odd = load_columns(pair.odd->waves + n * apart, first, pair.odd->columns);
    column[n] = even + odd;
    if (symmetry_ == Symmetry::none || n == 0 || 2 * n >= all_.py())
      continue;
    const Complex turn = turn_[static_cast<std::size_t>(n)];
    const ComplexLanes opposite = even - odd;
    column[all_.py() - n] = turn.real() * opposite + turn.imag() * times_i(opposite);
  }
}

/// The first rows of the field, as waves along x.
/// @param apart  from block to block
void IndependentRowsFft::put_in_rows(const Pair& pair, int rows, ComplexLanes* to, int apart, Work& work) const
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
void put(double value, double& to)
{
  to = adds ? to + value : value;
}

/// The parts of a field that are even and odd about the middle row, in a window.
/// @param even, odd  nullptr if there is none; then the field is the other one
template <bool adds>
void put_parts(const SurfaceGrid& g, const IndependentRowsFft::Window& window, const double* field, double* even,
               double* odd)
{
  const int columns = window.columns;
  for (int j = window.first_row; 2 * j < g.ny; ++j)
  {
    const int to_row = j - window.first_row, to_opposite = g.ny - 1 - j - window.first_row;
    const std::ptrdiff_t here = static_cast<std::ptrdiff_t>(to_row) * columns,
                         there = static_cast<std::ptrdiff_t>(to_opposite) * columns;
    const bool is_middle = here == there;
    const double *at = field + g.index(window.first_column, j),
                 *opposite = field + g.index(window.first_column, g.ny - 1 - j);
    if (even == nullptr || odd == nullptr)
    {
      double *to = (even != nullptr ? even : odd) + here, *mirrored = (even != nullptr ? even : odd) + there;
      const double sign = even != nullptr ? 1.0 : -1.0, of_middle = is_middle && odd != nullptr ? 0.0 : 1.0;
      for (int i = 0; i < columns; ++i)
        put<adds>(of_middle * at[i], to[i]);
      for (int i = 0; i < columns && !is_middle; ++i)
        put<adds>(sign * at[i], mirrored[i]);
      continue;
    }
    for (int i = 0; i < columns; ++i)
    {
      put<adds>(0.5 * (at[i] + opposite[i]), even[here + i]);
      put<adds>(0.5 * (at[i] - opposite[i]), odd[here + i]);
    }
    for (int i = 0; i < columns && !is_middle; ++i)
    {
      put<adds>(0.5 * (at[i] + opposite[i]), even[there + i]);
      put<adds>(0.5 * (opposite[i] - at[i]), odd[there + i]);
    }
  }
}

} // namespace

/// Of an even and an odd field, or of one of them: then half of the rows tell all.
int IndependentRowsFft::rows_of(std::size_t pair, const Together& together) const
{
  const int ny = all_.grid().ny;
  const bool is_whole = symmetry_ == Symmetry::none || (pair < together.even.size() && pair < together.odd.size());
  return is_whole ? ny : (ny + 1) / 2;
}

/// Rows of all the fields lie one after the other, so that those that are transformed together are as many as can be.
void IndependentRowsFft::invert(const Together& together, bool adds, Work& work) const
{
  const SurfaceGrid& g = all_.grid();
  const double scale = 1.0 / (static_cast<double>(all_.px()) * all_.py());
  const std::size_t pairs = std::max(together.even.size(), together.odd.size());
  int rows = 0;
  for (std::size_t n = 0; n < pairs; ++n)
    rows += rows_of(n, together);
  const auto all_rows = static_cast<std::size_t>(rows);
  if (work.field.size() < all_rows * static_cast<std::size_t>(g.nx))
  {
    work.field.resize(all_rows * static_cast<std::size_t>(g.nx));
    work.rows.resize(all_rows * static_cast<std::size_t>(row_fft_->blocks()));
  }
  int first = 0;
  for (std::size_t n = 0; n < pairs; first += rows_of(n, together), ++n)
    put_in_rows({n < together.even.size() ? &together.spectra[together.even[n]] : nullptr,
                 n < together.odd.size() ? &together.spectra[together.odd[n]] : nullptr},
                rows_of(n, together), work.rows.data() + first, rows, work);
  for (first = 0; first < rows; first += RowFft::most_rows)
    row_fft_->inverse(work.rows.data() + first, {rows, false}, std::min(RowFft::most_rows, rows - first), scale,
                      work.field.data() + static_cast<std::ptrdiff_t>(first) * g.nx, work.row);
  const double* field = work.field.data();
  for (std::size_t n = 0; n < pairs; field += static_cast<std::ptrdiff_t>(rows_of(n, together)) * g.nx, ++n)
  {
    double* even = n < together.even.size() ? together.fields[together.even[n]].data() : nullptr;
    double* odd = n < together.odd.size() ? together.fields[together.odd[n]].data() : nullptr;
    const Window& window = together.window;
    if (symmetry_ != Symmetry::none)
    {
      (adds ? put_parts<true> : put_parts<false>)(g, window, field, even, odd);
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
  std::unique_ptr<Work> work = take_work();
  const std::size_t count = is_odd.size();
  std::vector<std::size_t> even, odd; // without symmetry all are as even ones
  for (std::size_t f = 0; f < count; ++f)
    (is_odd[f] && symmetry_ != Symmetry::none ? odd : even).push_back(f);
  for (std::size_t first = 0; first < fields.size(); first += count)
    invert({spectra.subspan(first, count), std::span(fields).subspan(first, count), even, odd, window}, adds, *work);
  works_->give(std::move(work));
}

} // namespace brinell::halfspace
