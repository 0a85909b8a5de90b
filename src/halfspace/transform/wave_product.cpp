// SPDX-License-Identifier: BSD-3-Clause
#include "wave_product.hpp"

#include "foundation/lane_functions.hpp"
#include "foundation/sharing.hpp"

#include <omp.h>

namespace brinell::halfspace
{

WaveProduct::WaveProduct(const SurfaceGrid& grid, const PaddedLengths& lengths, std::span<const double> factors)
    : fft_(grid, lengths.x, lengths.y, 1), rows_(fft_.py() / 2 + 1),
      factors_(static_cast<std::size_t>(fft_.blocks()) * static_cast<std::size_t>(rows_))
{
  const double* factor = factors.data();
  for (int row = 0; row < rows_; ++row)
    for (int i = 0; i < fft_.kx(); ++i, ++factor)
    {
      const auto line =
          static_cast<std::size_t>(i / lane_count) * static_cast<std::size_t>(rows_) + static_cast<std::size_t>(row);
      factors_[line][i % lane_count] = *factor;
    }
}

WaveProduct::Scratch WaveProduct::make_scratch() const
{
  Scratch scratch;
  scratch.rows.resize(fft_.rows_size());
  const int threads = is_shared(grid().size()) ? omp_get_max_threads() : 1;
  for (int thread = 0; thread < threads; ++thread)
    scratch.threads.push_back(fft_.make_scratch());
  return scratch;
}

/// Transforms the rows of one block along y, multiplies them and transforms them back.
void WaveProduct::apply_to_block(int block, AlignedVector<ComplexLanes>& values, BlockedFft::Scratch& own) const
{
  fft_.columns_forward(values.data(), block, 0, own.column.data(), own);
  const Lanes* factors = factors_.data() + static_cast<std::ptrdiff_t>(block) * rows_;
  for (int row = 0; row < fft_.py(); ++row)
  {
    ComplexLanes& value = own.column[static_cast<std::size_t>(row)];
    value = factors[fft_.folded(row)] * value;
  }
  fft_.columns_inverse(own.column.data(), block, 0, values.data(), own);
}

void WaveProduct::apply(std::span<const double> in, std::span<double> out, Scratch& scratch) const
{
  const auto work = [&](BlockedFft::Scratch& own)
  {
#pragma omp for schedule(static)
    for (int batch = 0; batch < fft_.batches(); ++batch)
      fft_.rows_forward(in.data(), 0, batch, scratch.rows.data(), own);
#pragma omp for schedule(static)
    for (int block = 0; block < fft_.blocks(); ++block)
      apply_to_block(block, scratch.rows, own);
#pragma omp for schedule(static)
    for (int batch = 0; batch < fft_.batches(); ++batch)
      fft_.rows_inverse(scratch.rows.data(), 0, batch, out.data(), own);
  };
  in_threads(static_cast<int>(scratch.threads.size()),
             [&](int thread) { work(scratch.threads[static_cast<std::size_t>(thread)]); });
}

} // namespace brinell::halfspace
