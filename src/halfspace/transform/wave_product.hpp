// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "foundation/blocked_fft.hpp"
#include "foundation/fft.hpp"
#include "foundation/lane_functions.hpp"
#include "foundation/sharing.hpp"

#include <array>
#include <omp.h>
#include <span>
#include <vector>

namespace brinell::halfspace
{

/// A value for each block of neighbouring wavenumbers along x and each wavenumber >= 0 along y of a transform.
template <typename Value>
class WaveTable
{
public:
  explicit WaveTable(const BlockedFft& fft)
      : py_(fft.py()), rows_(py_ / 2 + 1),
        values_(static_cast<std::size_t>(fft.blocks()) * static_cast<std::size_t>(rows_))
  {
  }
  [[nodiscard]] int rows() const { return rows_; }
  /// The values of one block.
  struct OfBlock
  {
    const Value* values;
    int py;
    /// @param row  wavenumber index along y, wrapped
    const Value& operator[](int row) const { return values[row > py / 2 ? py - row : row]; }
  };
  [[nodiscard]] OfBlock of_block(int block) const { return {values_.data() + place(block, 0), py_}; }
  /// The value that holds a column in its lane column % lane_count.
  [[nodiscard]] Value& of_column(int row, int column) { return values_[place(column / lane_count, row)]; }

private:
  [[nodiscard]] std::size_t place(int block, int row) const
  {
    return static_cast<std::size_t>(block) * static_cast<std::size_t>(rows_) + static_cast<std::size_t>(row);
  }

  int py_, rows_;
  AlignedVector<Value> values_;
};

/// Fields on a surface -> the same number of fields, by a matrix at each wave. Empty fields are skipped. On a mirrored grid only
/// the independent rows are read and written.
///
/// A block of neighbouring columns is transformed, multiplied and transformed back while it is in the cache.
template <std::size_t count>
class WaveProduct
{
public:
  using Values = std::array<ComplexLanes, count>; ///< of neighbouring wavenumbers
  using In = std::array<std::span<const double>, count>;
  using Out = std::array<std::span<double>, count>;

  /// @param lengths  of the transforms; beyond the grid the fields are zero
  /// @param is_odd   of a mirrored grid: which fields are odd in y
  WaveProduct(const SurfaceGrid& grid, const PaddedLengths& lengths, const std::array<bool, count>& is_odd = {})
      : fft_(grid, lengths.x, lengths.y, 1), is_odd_(is_odd)
  {
  }

  [[nodiscard]] const BlockedFft& fft() const { return fft_; }

  struct Scratch
  {
    std::array<AlignedVector<ComplexLanes>, count> rows;
    std::vector<std::array<BlockedFft::Scratch, count>> threads; ///< only one if the grid is too small to share
  };
  [[nodiscard]] Scratch make_scratch() const
  {
    Scratch scratch;
    for (AlignedVector<ComplexLanes>& rows : scratch.rows)
      rows.resize(fft_.rows_size());
    scratch.threads.resize(is_shared(fft_.grid().size()) ? static_cast<std::size_t>(omp_get_max_threads()) : 1U);
    for (auto& own : scratch.threads)
      for (BlockedFft::Scratch& of_field : own)
        of_field = fft_.make_scratch();
    return scratch;
  }
  /// Whether a scratch is large enough.
  [[nodiscard]] bool fits(const Scratch& scratch) const { return scratch.rows[0].size() >= fft_.rows_size(); }

  /// `in` and `out` may be the same fields.
  /// @param product  function (block) that returns a function (row, values), which returns the products at neighbouring
  ///                 wavenumbers
  template <typename Product>
  void apply(const In& in, const Out& out, Scratch& scratch, const Product& product) const
  {
    const auto work = [&](std::array<BlockedFft::Scratch, count>& own)
    {
      for (std::size_t f = 0; f < count; ++f)
      {
#pragma omp for schedule(static)
        for (int batch = 0; batch < (in[f].empty() ? 0 : fft_.batches()); ++batch)
          fft_.rows_forward(in[f].data(), 0, batch, scratch.rows[f].data(), own[f]);
      }
#pragma omp for schedule(static)
      for (int block = 0; block < fft_.blocks(); ++block)
        apply_to_block(block, in, out, scratch, own, product);
      for (std::size_t f = 0; f < count; ++f)
      {
#pragma omp for schedule(static)
        for (int batch = 0; batch < (out[f].empty() ? 0 : fft_.batches()); ++batch)
          fft_.rows_inverse(scratch.rows[f].data(), 0, batch, out[f].data(), own[f]);
      }
    };
    in_threads(static_cast<int>(scratch.threads.size()),
               [&](int thread) { work(scratch.threads[static_cast<std::size_t>(thread)]); });
  }

private:
  template <typename Product>
  void apply_to_block(int block, const In& in, const Out& out, Scratch& scratch,
                      std::array<BlockedFft::Scratch, count>& own, const Product& product) const
  {
    for (std::size_t f = 0; f < count; ++f)
      if (!in[f].empty())
        fft_.columns_forward(scratch.rows[f].data(), block, 0, own[f].column.data(), own[f], is_odd_[f]);
    const auto product_of_row = product(block);
    const int rows = fft_.waves_along_y();
    if constexpr (count == 1)
    {
      ComplexLanes* column = own[0].column.data(); // a single field is not empty
      for (int row = 0; row < rows; ++row)
        column[row] = product_of_row(row, {column[row]})[0];
    }
    else
      for (int row = 0; row < rows; ++row)
      {
        const auto line = static_cast<std::size_t>(row);
        Values values;
        for (std::size_t f = 0; f < count; ++f)
          if (!in[f].empty())
            values[f] = own[f].column[line];
        const Values result = product_of_row(row, values);
        for (std::size_t f = 0; f < count; ++f)
          if (!out[f].empty())
            own[f].column[line] = result[f];
      }
    for (std::size_t f = 0; f < count; ++f)
      if (!out[f].empty())
        fft_.columns_inverse(own[f].column.data(), block, 0, scratch.rows[f].data(), own[f], is_odd_[f]);
  }

  BlockedFft fft_;
  std::array<bool, count> is_odd_;
};

} // namespace brinell::halfspace
