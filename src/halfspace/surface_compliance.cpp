// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/halfspace/surface_compliance.hpp"

#include "brinell/foundation/error.hpp"
#include "brinell/green/rectangle.hpp"
#include "foundation/blocked_fft.hpp"
#include "foundation/fft.hpp"
#include "foundation/sharing.hpp"
#include "require_surface.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <omp.h>
#include <vector>

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

struct SurfaceCompliance::Scratch::Buffers
{
  AlignedVector<Complex> rows;
  std::vector<BlockedFft::Scratch> threads; ///< one where the grid is too small to share
};

struct SurfaceCompliance::Operator
{
  BlockedFft fft;
  int rows;                       ///< stored rows of the spectrum, ky >= 0
  AlignedVector<double> spectrum; ///< of the operator [m/Pa], real and even: [block][row][lane]
  double contact_modulus;         ///< E' [Pa]
  double largest = 0.0, longest_wave = 0.0;

  Operator(const SurfaceGrid& grid, double modulus);
  void apply_to_block(int block, AlignedVector<Complex>& values, BlockedFft::Scratch& own) const;
};

SurfaceCompliance::Operator::Operator(const SurfaceGrid& grid, double modulus)
    : fft(grid, fast_length(2 * grid.nx - 1), fast_length(2 * grid.ny - 1), 1), rows(fft.py() / 2 + 1),
      spectrum(static_cast<std::size_t>(fft.blocks()) * static_cast<std::size_t>(rows) * lane_count, 0.0),
      contact_modulus(modulus)
{
  const PaddedFft padded(grid, fft.px(), fft.py());
  AlignedVector<double> kernel = wrapped_kernel(padded, contact_modulus);
  AlignedVector<Complex> transformed(padded.plane());
  padded.forward_padded(kernel, transformed.data());
  for (int row = 0; row < rows; ++row)
    for (int i = 0; i < padded.kx(); ++i)
    {
      // Even in x and y: the imaginary part is rounding.
      const double value =
          transformed[static_cast<std::size_t>(row) * static_cast<std::size_t>(padded.kx()) + i].real();
      const auto line = static_cast<std::size_t>(i / lane_count) * static_cast<std::size_t>(rows) + row;
      spectrum[line * lane_count + i % lane_count] = value;
    }
  largest = *std::max_element(spectrum.begin(), spectrum.end());
  longest_wave = spectrum[1];
}

/// From the rows of one block and back to them.
void SurfaceCompliance::Operator::apply_to_block(int block, AlignedVector<Complex>& values,
                                                 BlockedFft::Scratch& own) const
{
  fft.columns_forward(values.data(), block, 0, 1, own);
  const double* factors = spectrum.data() + static_cast<std::ptrdiff_t>(block) * rows * lane_count;
  Complex* line = own.columns.data();
  for (int row = 0; row < fft.py(); ++row, line += lane_count)
  {
    const double* factor = factors + std::min(row, fft.py() - row) * lane_count;
    for (int lane = 0; lane < lane_count; ++lane)
      line[lane] *= factor[lane];
  }
  fft.columns_inverse(own, block, 0, 1, values.data());
}

SurfaceCompliance::SurfaceCompliance(const SurfaceGrid& grid, double contact_modulus)
    : operator_(std::make_unique<Operator>(grid, contact_modulus))
{
}

SurfaceCompliance::~SurfaceCompliance() = default;
SurfaceCompliance::SurfaceCompliance(SurfaceCompliance&&) noexcept = default;
SurfaceCompliance& SurfaceCompliance::operator=(SurfaceCompliance&&) noexcept = default;

SurfaceCompliance::Scratch::Scratch(std::unique_ptr<Buffers> buffers) : buffers_(std::move(buffers)) {}
SurfaceCompliance::Scratch::~Scratch() = default;
SurfaceCompliance::Scratch::Scratch(Scratch&&) noexcept = default;
SurfaceCompliance::Scratch& SurfaceCompliance::Scratch::operator=(Scratch&&) noexcept = default;

const SurfaceGrid& SurfaceCompliance::grid() const
{
  return operator_->fft.grid();
}

SurfaceCompliance SurfaceCompliance::on(const SurfaceGrid& grid) const
{
  return {grid, operator_->contact_modulus};
}

double SurfaceCompliance::largest() const
{
  return operator_->largest;
}

double SurfaceCompliance::longest_wave() const
{
  return operator_->longest_wave;
}

SurfaceCompliance::Scratch SurfaceCompliance::make_scratch() const
{
  auto buffers = std::make_unique<Scratch::Buffers>();
  buffers->rows.resize(operator_->fft.rows_size());
  const int threads = is_shared(grid().size()) ? omp_get_max_threads() : 1;
  for (int thread = 0; thread < threads; ++thread)
    buffers->threads.push_back(operator_->fft.make_scratch());
  return Scratch(std::move(buffers));
}

void SurfaceCompliance::apply(const SurfaceLoad& load, const SurfaceDisplacement& displacement, Scratch& scratch) const
{
  const BlockedFft& fft = operator_->fft;
  require_load("SurfaceCompliance::apply", load, grid().size());
  require_displacement("SurfaceCompliance::apply", displacement, grid().size());
  Scratch::Buffers& buffers = *scratch.buffers_;
  if (buffers.rows.size() < fft.rows_size())
    throw InternalError("SurfaceCompliance::apply: the scratch is of another operator; make_scratch makes one");
  if (load.pressure.empty())
    return std::fill(displacement.z.begin(), displacement.z.end(), 0.0);
  const auto work = [&](BlockedFft::Scratch& own)
  {
#pragma omp for schedule(static)
    for (int batch = 0; batch < fft.batches(); ++batch)
      fft.rows_forward(load.pressure.data(), 0, batch, buffers.rows.data(), own);
#pragma omp for schedule(static)
    for (int block = 0; block < fft.blocks(); ++block)
      operator_->apply_to_block(block, buffers.rows, own);
#pragma omp for schedule(static)
    for (int batch = 0; batch < fft.batches(); ++batch)
      fft.rows_inverse(buffers.rows.data(), 0, batch, displacement.z.data(), own);
  };
  const auto threads = static_cast<int>(buffers.threads.size());
#pragma omp parallel num_threads(threads)
  work(buffers.threads[static_cast<std::size_t>(omp_get_thread_num())]);
}

} // namespace brinell::halfspace
