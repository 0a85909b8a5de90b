// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/blocked_fft.hpp"

#include <span>
#include <vector>

namespace brinell::halfspace
{

/// Pressure -> sum of the elastic normal displacements of two half spaces on one surface grid, non-periodic
/// (DC-FFT of the rectangle's closed form, Love 1929): docs/theory/half-space.md (surface-displacement).
///
/// The work on a block of neighbouring columns, transform, product and transform back, is done in one go in the cache.
class SurfaceCompliance
{
public:
  /// @param contact_modulus  E' of the pair [Pa]: u = 1/(pi E') * integral of p / r.
  SurfaceCompliance(const SurfaceGrid& grid, double contact_modulus);

  /// Buffers of one application.
  struct Scratch
  {
    AlignedVector<Complex> rows;
    std::vector<BlockedFft::Scratch> threads; ///< one where the grid is too small to share
  };

  [[nodiscard]] const SurfaceGrid& grid() const { return fft_.grid(); }
  /// Displacement [m] of the pressure [Pa]; both one value per cell; symmetric and positive definite.
  /// `scratch` comes from make_scratch, one per concurrent caller.
  void apply(std::span<const double> pressure, std::span<double> displacement, Scratch& scratch) const;
  [[nodiscard]] Scratch make_scratch() const;
  /// Largest response of a wave [m/Pa], and that of the longest wave along x.
  [[nodiscard]] double largest() const { return largest_; }
  [[nodiscard]] double longest_wave() const { return longest_wave_; }

private:
  void apply_to_block(int block, Scratch& scratch, BlockedFft::Scratch& own) const;

  BlockedFft fft_;
  int rows_;                       ///< stored rows of the spectrum, ky >= 0
  AlignedVector<double> spectrum_; ///< of the operator [m/Pa], real and even: [block][row][lane]
  double largest_ = 0.0, longest_wave_ = 0.0;
};

} // namespace brinell::halfspace
