// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "foundation/blocked_fft.hpp"
#include "foundation/fft.hpp"

#include <span>
#include <vector>

namespace brinell::halfspace
{

/// A field on a surface -> the field with each wave multiplied by a factor.
///
/// A block of neighbouring columns is transformed, multiplied and transformed back while it is in the cache.
class WaveProduct
{
public:
  /// @param lengths  of the transforms; beyond the grid the field is zero.
  /// @param factors  real and even: row by row, [lengths.y / 2 + 1][lengths.x / 2 + 1].
  WaveProduct(const SurfaceGrid& grid, const PaddedLengths& lengths, std::span<const double> factors);

  struct Scratch
  {
    AlignedVector<ComplexLanes> rows;
    std::vector<BlockedFft::Scratch> threads; ///< only one if the grid is too small to share
  };
  [[nodiscard]] Scratch make_scratch() const;
  /// Whether a scratch is large enough.
  [[nodiscard]] bool fits(const Scratch& scratch) const { return scratch.rows.size() >= fft_.rows_size(); }

  [[nodiscard]] const SurfaceGrid& grid() const { return fft_.grid(); }
  /// `in` and `out` may be the same field.
  void apply(std::span<const double> in, std::span<double> out, Scratch& scratch) const;

private:
  void apply_to_block(int block, AlignedVector<ComplexLanes>& values, BlockedFft::Scratch& own) const;

  BlockedFft fft_;
  int rows_;                     ///< stored rows of the factors, ky >= 0
  AlignedVector<Lanes> factors_; ///< [block][row]
};

} // namespace brinell::halfspace
