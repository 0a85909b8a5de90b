// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/halfspace/surface_compliance.hpp"

#include "brinell/foundation/error.hpp"
#include "brinell/foundation/fft.hpp"
#include "brinell/green/rectangle.hpp"
#include "foundation/require_size.hpp"
#include "foundation/sharing.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <omp.h>

namespace brinell::halfspace
{

namespace
{

/// Displacement of a unit pressure on one cell, around the padded plane.
AlignedVector<double> wrapped_kernel(const PaddedFft& fft, double contact_modulus)
{
  const SurfaceGrid& grid = fft.grid();
  const int px = fft.px();
  const int py = fft.py();
  AlignedVector<double> kernel(static_cast<std::size_t>(px) * static_cast<std::size_t>(py), 0.0);
  const auto at = [&](int i, int j) -> double&
  { return kernel[static_cast<std::size_t>((j + py) % py) * static_cast<std::size_t>(px) + (i + px) % px]; };
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i)
    {
      const double u = green::rectangle_displacement(i * grid.dx, j * grid.dy, grid.dx, grid.dy);
      at(i, j) = at(-i, j) = at(i, -j) = at(-i, -j) = u / (std::numbers::pi * contact_modulus);
    }
  return kernel;
}

} // namespace

SurfaceCompliance::SurfaceCompliance(const SurfaceGrid& grid, double contact_modulus)
    : fft_(grid, fast_length(2 * grid.nx - 1), fast_length(2 * grid.ny - 1), 1), rows_(fft_.py() / 2 + 1),
      spectrum_(static_cast<std::size_t>(fft_.blocks()) * static_cast<std::size_t>(rows_) * lane_count, 0.0)
{
  const PaddedFft padded(grid, fft_.px(), fft_.py());
  AlignedVector<double> kernel = wrapped_kernel(padded, contact_modulus);
  AlignedVector<Complex> transformed(padded.plane());
  padded.forward_padded(kernel, transformed.data());
  for (int row = 0; row < rows_; ++row)
    for (int i = 0; i < padded.kx(); ++i)
    {
      // Even in x and y: the imaginary part is rounding.
      const double value =
          transformed[static_cast<std::size_t>(row) * static_cast<std::size_t>(padded.kx()) + i].real();
      const auto line = static_cast<std::size_t>(i / lane_count) * static_cast<std::size_t>(rows_) + row;
      spectrum_[line * lane_count + i % lane_count] = value;
    }
  largest_ = *std::max_element(spectrum_.begin(), spectrum_.end());
  longest_wave_ = spectrum_[1];
}

SurfaceCompliance::Scratch SurfaceCompliance::make_scratch() const
{
  Scratch scratch;
  scratch.rows.resize(fft_.rows_size());
  const int threads = is_shared(grid().size()) ? omp_get_max_threads() : 1;
  for (int thread = 0; thread < threads; ++thread)
    scratch.threads.push_back(fft_.make_scratch());
  return scratch;
}

/// From the rows of one block and back to them.
void SurfaceCompliance::apply_to_block(int block, Scratch& scratch, BlockedFft::Scratch& own) const
{
  fft_.columns_forward(scratch.rows.data(), block, 0, 1, own);
  const double* factors = spectrum_.data() + static_cast<std::ptrdiff_t>(block) * rows_ * lane_count;
  Complex* line = own.columns.data();
  for (int row = 0; row < fft_.py(); ++row, line += lane_count)
  {
    const double* factor = factors + std::min(row, fft_.py() - row) * lane_count;
    for (int lane = 0; lane < lane_count; ++lane)
      line[lane] *= factor[lane];
  }
  fft_.columns_inverse(own, block, 0, 1, scratch.rows.data());
}

void SurfaceCompliance::apply(std::span<const double> pressure, std::span<double> displacement, Scratch& scratch) const
{
  require_size("SurfaceCompliance::apply: the pressure", pressure, grid().size());
  require_size("SurfaceCompliance::apply: the displacement", displacement, grid().size());
  if (scratch.threads.empty() || scratch.rows.size() < fft_.rows_size())
    throw InternalError("SurfaceCompliance::apply: the scratch is of another operator; make_scratch makes one");
  const auto work = [&](BlockedFft::Scratch& own)
  {
#pragma omp for schedule(static)
    for (int batch = 0; batch < fft_.batches(); ++batch)
      fft_.rows_forward(pressure.data(), 0, batch, scratch.rows.data(), own);
#pragma omp for schedule(static)
    for (int block = 0; block < fft_.blocks(); ++block)
      apply_to_block(block, scratch, own);
#pragma omp for schedule(static)
    for (int batch = 0; batch < fft_.batches(); ++batch)
      fft_.rows_inverse(scratch.rows.data(), 0, batch, displacement.data(), own);
  };
  const auto threads = static_cast<int>(scratch.threads.size());
#pragma omp parallel num_threads(threads)
  work(scratch.threads[static_cast<std::size_t>(omp_get_thread_num())]);
}

} // namespace brinell::halfspace
