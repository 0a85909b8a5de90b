// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "foundation/blocked_fft.hpp"
#include "foundation/lane_functions.hpp"
#include "foundation/sharing.hpp"

#include <array>
#include <omp.h>
#include <span>
#include <vector>

namespace brinell::halfspace
{

/// Several fields on a surface -> the same number of fields, by a matrix at each wavenumber: the analogue of WaveProduct for
/// coupled fields. Empty fields are skipped.
template <std::size_t count>
struct CoupledProduct
{
  using Values = std::array<ComplexLanes, count>; ///< of neighbouring wavenumbers

  struct Scratch
  {
    std::array<AlignedVector<ComplexLanes>, count> rows;
    std::vector<std::array<BlockedFft::Scratch, count>> threads; ///< only one if the grid is too small to share
  };

  [[nodiscard]] static Scratch make_scratch(const BlockedFft& fft)
  {
    Scratch scratch;
    for (AlignedVector<ComplexLanes>& rows : scratch.rows)
      rows.resize(fft.rows_size());
    scratch.threads.resize(is_shared(fft.grid().size()) ? static_cast<std::size_t>(omp_get_max_threads()) : 1U);
    for (auto& own : scratch.threads)
      for (BlockedFft::Scratch& of_field : own)
        of_field = fft.make_scratch();
    return scratch;
  }

  [[nodiscard]] static bool fits(const BlockedFft& fft, const Scratch& scratch)
  {
    return scratch.rows[0].size() >= fft.rows_size();
  }

  /// @param product  function (block, row, values) that returns the products at neighbouring wavenumbers
  template <typename Product>
  static void apply(const BlockedFft& fft, const std::array<std::span<const double>, count>& in,
                    const std::array<std::span<double>, count>& out, Scratch& scratch, const Product& product)
  {
    const auto work = [&](std::array<BlockedFft::Scratch, count>& own)
    {
      for (std::size_t f = 0; f < count; ++f)
      {
#pragma omp for schedule(static)
        for (int batch = 0; batch < (in[f].empty() ? 0 : fft.batches()); ++batch)
          fft.rows_forward(in[f].data(), 0, batch, scratch.rows[f].data(), own[f]);
      }
#pragma omp for schedule(static)
      for (int block = 0; block < fft.blocks(); ++block)
        apply_to_block(fft, block, in, out, scratch, own, product);
      for (std::size_t f = 0; f < count; ++f)
      {
#pragma omp for schedule(static)
        for (int batch = 0; batch < (out[f].empty() ? 0 : fft.batches()); ++batch)
          fft.rows_inverse(scratch.rows[f].data(), 0, batch, out[f].data(), own[f]);
      }
    };
    in_threads(static_cast<int>(scratch.threads.size()),
               [&](int thread) { work(scratch.threads[static_cast<std::size_t>(thread)]); });
  }

private:
  /// Transforms one block along y, multiplies it and transforms it back, while it is in the cache.
  template <typename Product>
  static void apply_to_block(const BlockedFft& fft, int block, const std::array<std::span<const double>, count>& in,
                             const std::array<std::span<double>, count>& out, Scratch& scratch,
                             std::array<BlockedFft::Scratch, count>& own, const Product& product)
  {
    for (std::size_t f = 0; f < count; ++f)
      if (!in[f].empty())
        fft.columns_forward(scratch.rows[f].data(), block, 0, own[f].column.data(), own[f]);
    for (int row = 0; row < fft.py(); ++row)
    {
      const auto line = static_cast<std::size_t>(row);
      Values values;
      for (std::size_t f = 0; f < count; ++f)
        if (!in[f].empty())
          values[f] = own[f].column[line];
      const Values result = product(block, row, values);
      for (std::size_t f = 0; f < count; ++f)
        if (!out[f].empty())
          own[f].column[line] = result[f];
    }
    for (std::size_t f = 0; f < count; ++f)
      if (!out[f].empty())
        fft.columns_inverse(own[f].column.data(), block, 0, scratch.rows[f].data(), own[f]);
  }
};

} // namespace brinell::halfspace
