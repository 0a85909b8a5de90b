// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/fft.hpp"

#include <span>
#include <vector>

namespace brinell::halfspace
{

/// Pressure -> sum of the elastic normal displacements of two half spaces on one surface grid, non-periodic
/// (DC-FFT of the rectangle's closed form, Love 1929): docs/theory/half-space.md (surface-displacement).
class SurfaceCompliance
{
public:
  /// @param contact_modulus  E' of the pair [Pa]: u = 1/(pi E') * integral of p / r.
  SurfaceCompliance(const SurfaceGrid& grid, double contact_modulus);

  /// Buffers of one application.
  struct Scratch
  {
    AlignedVector<Complex> spectrum;
    AlignedVector<double> real;
  };

  [[nodiscard]] const SurfaceGrid& grid() const { return fft_.grid(); }
  /// Displacement [m] of the pressure [Pa]; both one value per cell; symmetric and positive definite.
  /// `scratch` comes from make_scratch, one per concurrent caller.
  void apply(std::span<const double> pressure, std::span<double> displacement, Scratch& scratch) const;
  [[nodiscard]] Scratch make_scratch() const
  {
    return {AlignedVector<Complex>(fft_.plane()), AlignedVector<double>(fft_.scratch_size())};
  }
  /// Spectrum of the operator [m/Pa], real and even, one value per stored wavenumber.
  [[nodiscard]] std::span<const double> spectrum() const { return spectrum_; }
  [[nodiscard]] const PaddedFft& fft() const { return fft_; }

private:
  PaddedFft fft_;
  std::vector<double> spectrum_;
};

} // namespace brinell::halfspace
