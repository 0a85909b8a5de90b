// SPDX-License-Identifier: BSD-3-Clause
#include "foundation/fft.hpp"

#include "brinell/foundation/error.hpp"
#include "foundation/fftw.hpp"
#include "foundation/lane_fft.hpp"
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

/// FFTW plans on one plane: rows between a real buffer and the complex plane. Only the rows that contain data are transformed
/// along x, so the zero padding costs nothing there. Columns are transformed `lane_count` at a time in lanes, which read and
/// write only the rows that contain data.
struct PaddedFft::Plans
{
  fftw_plan rows_forward = nullptr, rows_inverse = nullptr, all_rows_forward = nullptr;
  fftw_plan columns_forward = nullptr;
  LaneFft columns;

  Plans(int px, int py, int ny, std::size_t plane) : columns(py)
  {
    // FFTW_ESTIMATE makes the choice of algorithm, and so the last bit of every result, reproducible.
    const unsigned flags = FFTW_ESTIMATE;
    const auto lock = planner_lock();
    AlignedVector<Complex> spectrum(plane);
    AlignedVector<double> real(static_cast<std::size_t>(px) * static_cast<std::size_t>(py));
    auto* c = as_fftw(spectrum.data());
    double* r = real.data();
    const int kx = px / 2 + 1;
    const auto rows = [&](int count)
    { return fftw_plan_many_dft_r2c(1, &px, count, r, nullptr, 1, px, c, nullptr, 1, kx, flags | FFTW_DESTROY_INPUT); };
    rows_forward = rows(ny);
    all_rows_forward = rows(py);
    rows_inverse = fftw_plan_many_dft_c2r(1, &px, ny, c, nullptr, 1, kx, r, nullptr, 1, px, flags | FFTW_DESTROY_INPUT);
    columns_forward = fftw_plan_many_dft(1, &py, kx, c, nullptr, kx, 1, c, nullptr, kx, 1, FFTW_FORWARD, flags);
    if (!rows_forward || !all_rows_forward || !rows_inverse || !columns_forward)
      throw InternalError("FFTW made no plan");
  }
  ~Plans()
  {
    const auto lock = planner_lock();
    for (fftw_plan p : {rows_forward, rows_inverse, all_rows_forward, columns_forward})
      fftw_destroy_plan(p);
  }
  Plans(const Plans&) = delete;
  Plans& operator=(const Plans&) = delete;
};

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

PaddedFft::PaddedFft(const SurfaceGrid& grid, int px, int py) : grid_(grid), px_(px), py_(py)
{
  if (grid.nx < 1 || grid.ny < 1 || px < grid.nx || py < grid.ny)
    throw InternalError("PaddedFft: the padded lengths must hold the grid");
  const std::size_t exact = static_cast<std::size_t>(kx()) * static_cast<std::size_t>(py_);
  plane_ = (exact + 7) / 8 * 8; // every plane of a batch starts on a cache line
  plans_ = std::make_unique<Plans>(px_, py_, grid_.ny, plane_);
}

PaddedFft::~PaddedFft() = default;
PaddedFft::PaddedFft(PaddedFft&&) noexcept = default;
PaddedFft& PaddedFft::operator=(PaddedFft&&) noexcept = default;

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

/// Number of real values of the rows, rounded up to whole cache lines.
std::size_t rows_size(int px, int ny)
{
  return (static_cast<std::size_t>(px) * static_cast<std::size_t>(ny) + lane_count - 1) / lane_count * lane_count;
}

/// Neighbouring values of one row in lanes; zero beyond the last column.
ComplexLanes load_row(const Complex* from, int count)
{
  if (count >= lane_count)
    return load_lanes(from);
  ComplexLanes value;
  for (int lane = 0; lane < count; ++lane)
  {
    value.re[lane] = from[lane].real();
    value.im[lane] = from[lane].imag();
  }
  return value;
}
void store_row(const ComplexLanes& value, int count, Complex* to)
{
  if (count >= lane_count)
    return store_lanes(value, to);
  for (int lane = 0; lane < count; ++lane)
    to[lane] = {value.re[lane], value.im[lane]};
}

} // namespace

std::size_t PaddedFft::scratch_size() const
{
  constexpr std::size_t values = 2 * lane_count; // of ComplexLanes
  return rows_size(px_, grid_.ny) + values * (2 * static_cast<std::size_t>(py_) + plans_->columns.work_size());
}

void PaddedFft::forward(const double* field, Complex* spectrum, std::span<double> scratch) const
{
  const std::ptrdiff_t nx = grid_.nx;
  for (std::ptrdiff_t j = 0; j < grid_.ny; ++j)
  {
    double* row = std::copy_n(field + j * nx, nx, scratch.data() + j * px_);
    std::fill_n(row, px_ - nx, 0.0);
  }
  fftw_execute_dft_r2c(plans_->rows_forward, scratch.data(), as_fftw(spectrum));
  auto* column = reinterpret_cast<ComplexLanes*>(scratch.data() + rows_size(px_, grid_.ny));
  ComplexLanes *transformed = column + py_, *work = transformed + py_;
  for (int first = 0; first < kx(); first += lane_count)
  {
    const int count = kx() - first;
    for (std::ptrdiff_t j = 0; j < grid_.ny; ++j)
      column[j] = load_row(spectrum + j * kx() + first, count);
    plans_->columns.forward(column, grid_.ny, transformed, work);
    for (std::ptrdiff_t j = 0; j < py_; ++j)
      store_row(transformed[j], count, spectrum + j * kx() + first);
  }
}

void PaddedFft::inverse(Complex* spectrum, double* field, std::span<double> scratch) const
{
  auto* column = reinterpret_cast<ComplexLanes*>(scratch.data() + rows_size(px_, grid_.ny));
  ComplexLanes *transformed = column + py_, *work = transformed + py_;
  for (int first = 0; first < kx(); first += lane_count)
  {
    const int count = kx() - first;
    for (std::ptrdiff_t j = 0; j < py_; ++j)
      column[j] = load_row(spectrum + j * kx() + first, count);
    plans_->columns.inverse(column, transformed, grid_.ny, work);
    for (std::ptrdiff_t j = 0; j < grid_.ny; ++j)
      store_row(transformed[j], count, spectrum + j * kx() + first);
  }
  fftw_execute_dft_c2r(plans_->rows_inverse, as_fftw(spectrum), scratch.data());
  const double scale = 1.0 / (static_cast<double>(px_) * py_);
  for (std::ptrdiff_t j = 0; j < grid_.ny; ++j)
    for (std::ptrdiff_t i = 0; i < grid_.nx; ++i)
      field[j * grid_.nx + i] = scale * scratch[static_cast<std::size_t>(j * px_ + i)];
}

void PaddedFft::forward_padded(std::span<double> field, Complex* spectrum) const
{
  fftw_execute_dft_r2c(plans_->all_rows_forward, field.data(), as_fftw(spectrum));
  fftw_execute_dft(plans_->columns_forward, as_fftw(spectrum), as_fftw(spectrum));
}

} // namespace brinell
