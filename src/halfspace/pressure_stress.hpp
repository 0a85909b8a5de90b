// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/deviator.hpp"
#include "foundation/blocked_fft.hpp"
#include "foundation/fft.hpp"

namespace brinell::halfspace
{

/// Surface pressure -> stress under it, and its transpose: plastic strain -> normal displacement of the surface.
///
/// Closed form of the uniformly loaded rectangle (Love 1929), one convolution per layer; the value of a cell is the mean
/// over the layer's thickness at the middle of the cell in x and y. On a grid with two periodic axes, waves in their place. The transpose is Betti's theorem,
///   u(x) = integral of s^(unit load at x) : eps_p dV,    docs/theory/half-space.md (residual-displacement),
/// with the same coefficients, so the discrete system stays symmetric.
///
/// Works on blocks of BlockedFft's spectra, on single rows of them where nothing else is said: there a stress or strain is
/// [5 * nz planes][lane], the components (order of Deviator) of one layer together.
class PressureStress
{
public:
  /// @param fft  transform of single planes on the surface of `grid`; must outlive this object.
  PressureStress(const VolumeGrid& grid, double poisson_ratio, const BlockedFft& fft);

  /// Adds the deviatoric stress of the pressure [Pa] to all rows of one block in the layers [first, first + count).
  /// @param pressure  [row][lane]
  /// @param stress    [5 * count planes][row][lane]
  void add_deviator(int block, int first, int count, const Complex* pressure, Complex* stress) const;
  /// Adds the trace of the stress of the pressure [Pa] to `trace`, nz planes.
  void add_trace(int block, int row, const Complex* pressure, Complex* trace) const;
  /// Normal surface displacement [m] (one plane), positive into the body, of traceless plastic strain in the layers
  /// [0, layers).
  void displacement(int block, int row, const Complex* strain, Complex* displacement, int layers) const;

private:
  static constexpr int kernel_count = 6;
  /// Kernels of one layer, for `lane_count` wavenumbers: imaginary parts for yz and xz, real parts otherwise.
  struct Kernels
  {
    Lanes xx, yy, yz, xz, xy; ///< xx and yy less zz
    Lanes trace;
  };
  [[nodiscard]] const Kernels* kernels(int block, int row) const;
  [[nodiscard]] Kernels& kernels_at(int row, int column, int layer);
  void tabulate_cells(int layer, double poisson_ratio, const PaddedFft& fft);
  void tabulate_waves(int layer, double poisson_ratio, const PaddedFft& fft);

  VolumeGrid grid_;
  const BlockedFft& fft_;
  int rows_;                       ///< stored rows, ky >= 0
  AlignedVector<Kernels> kernels_; ///< [block][row][layer]
};

} // namespace brinell::halfspace
