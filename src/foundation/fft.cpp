// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/foundation/fft.hpp"

#include "brinell/foundation/error.hpp"

#include <algorithm>
#include <fftw3.h>
#include <numbers>

namespace brinell
{

namespace
{

fftw_complex* as_fftw(Complex* c)
{
  return reinterpret_cast<fftw_complex*>(c);
}

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

/// FFTW plans, in place on one plane: rows are real <-> complex, columns complex <-> complex. Only the rows that
/// hold data are transformed along x; the zero padding costs nothing there.
struct PaddedFft::Plans
{
  fftw_plan rows_forward = nullptr, rows_inverse = nullptr, all_rows_forward = nullptr;
  fftw_plan columns_forward = nullptr, columns_inverse = nullptr;

  Plans(int px, int py, int ny, std::size_t plane)
  {
    // ESTIMATE keeps the choice of algorithm, and so the last bit of every result, the same from run to run.
    const unsigned flags = FFTW_ESTIMATE;
    AlignedVector<Complex> scratch(plane);
    auto* c = as_fftw(scratch.data());
    auto* r = reinterpret_cast<double*>(scratch.data());
    const int kx = px / 2 + 1;
    const auto rows = [&](int count)
    { return fftw_plan_many_dft_r2c(1, &px, count, r, nullptr, 1, 2 * kx, c, nullptr, 1, kx, flags); };
    rows_forward = rows(ny);
    all_rows_forward = rows(py);
    rows_inverse = fftw_plan_many_dft_c2r(1, &px, ny, c, nullptr, 1, kx, r, nullptr, 1, 2 * kx, flags);
    columns_forward = fftw_plan_many_dft(1, &py, kx, c, nullptr, kx, 1, c, nullptr, kx, 1, FFTW_FORWARD, flags);
    columns_inverse = fftw_plan_many_dft(1, &py, kx, c, nullptr, kx, 1, c, nullptr, kx, 1, FFTW_BACKWARD, flags);
    if (!rows_forward || !all_rows_forward || !rows_inverse || !columns_forward || !columns_inverse)
      throw InternalError("FFTW made no plan");
  }
  ~Plans()
  {
    for (fftw_plan p : {rows_forward, rows_inverse, all_rows_forward, columns_forward, columns_inverse})
      fftw_destroy_plan(p);
  }
  Plans(const Plans&) = delete;
  Plans& operator=(const Plans&) = delete;
};

PaddedFft::PaddedFft(const SurfaceGrid& grid)
    : PaddedFft(grid, fast_length(2 * grid.nx - 1), fast_length(2 * grid.ny - 1))
{
}

PaddedFft::PaddedFft(const SurfaceGrid& grid, int px, int py) : grid_(grid), px_(px), py_(py)
{
  if (grid.nx < 1 || grid.ny < 1 || px < grid.nx || py < grid.ny || px % 2 != 0 || py % 2 != 0)
    throw InternalError("PaddedFft: the padded lengths must be even and hold the grid");
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

void PaddedFft::forward(const double* field, Complex* spectrum) const
{
  auto* real = reinterpret_cast<double*>(spectrum);
  const int pitch = 2 * kx();
  for (int j = 0; j < grid_.ny; ++j)
  {
    double* row = std::copy_n(field + static_cast<std::ptrdiff_t>(j) * grid_.nx, grid_.nx,
                              real + static_cast<std::ptrdiff_t>(j) * pitch);
    std::fill_n(row, pitch - grid_.nx, 0.0);
  }
  std::fill_n(real + static_cast<std::ptrdiff_t>(grid_.ny) * pitch, static_cast<std::ptrdiff_t>(py_ - grid_.ny) * pitch,
              0.0);
  fftw_execute_dft_r2c(plans_->rows_forward, real, as_fftw(spectrum));
  fftw_execute_dft(plans_->columns_forward, as_fftw(spectrum), as_fftw(spectrum));
}

void PaddedFft::inverse(Complex* spectrum, double* field) const
{
  auto* real = reinterpret_cast<double*>(spectrum);
  const int pitch = 2 * kx();
  fftw_execute_dft(plans_->columns_inverse, as_fftw(spectrum), as_fftw(spectrum));
  fftw_execute_dft_c2r(plans_->rows_inverse, as_fftw(spectrum), real);
  const double scale = 1.0 / (static_cast<double>(px_) * py_);
  for (int j = 0; j < grid_.ny; ++j)
    std::transform(real + static_cast<std::ptrdiff_t>(j) * pitch,
                   real + static_cast<std::ptrdiff_t>(j) * pitch + grid_.nx,
                   field + static_cast<std::ptrdiff_t>(j) * grid_.nx, [scale](double v) { return v * scale; });
}

void PaddedFft::forward_padded(const double* field, Complex* spectrum) const
{
  auto* real = reinterpret_cast<double*>(spectrum);
  const int pitch = 2 * kx();
  for (int j = 0; j < py_; ++j)
  {
    double* row = std::copy_n(field + static_cast<std::ptrdiff_t>(j) * px_, px_,
                              real + static_cast<std::ptrdiff_t>(j) * pitch);
    std::fill_n(row, pitch - px_, 0.0);
  }
  fftw_execute_dft_r2c(plans_->all_rows_forward, real, as_fftw(spectrum));
  fftw_execute_dft(plans_->columns_forward, as_fftw(spectrum), as_fftw(spectrum));
}

} // namespace brinell
