// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/deviator.hpp"
#include "brinell/green/traction.hpp"
#include "foundation/blocked_fft.hpp"
#include "foundation/fft.hpp"
#include "parity_spectrum.hpp"

#include <array>

namespace brinell::halfspace
{

/// One component of the traction on the surface -> stress under it, and the transpose: plastic strain -> displacement of the
/// surface along that component.
///
/// Closed form of the uniformly loaded rectangle (Love 1929, Cerruti), one convolution per layer; the value of a cell is the
/// mean over the layer's thickness at the middle of the cell in x and y. On a grid with two periodic axes, waves in their
/// place. The transpose is Betti's theorem,
///   u(x) = integral of s^(unit load at x) : eps_p dV,    docs/theory/half-space.md (residual-displacement),
/// with the same coefficients, so the discrete system stays symmetric.
///
/// Works on blocks of BlockedFft's spectra, on single rows of them where nothing else is said: there a stress or strain is
/// [5 * nz planes][lane], the components (order of Deviator) of one layer together.
class TractionStress
{
public:
  /// @param fft  transform of single planes on the surface of `grid`; must outlive this object.
  TractionStress(const VolumeGrid& grid, double poisson_ratio, const BlockedFft& fft, Traction traction);

  /// Adds the deviatoric stress of the traction [Pa] to all rows of one block in the layers [first, first + count).
  /// @param traction  [row][lane]
  /// @param stress    [5 * count planes][row][lane]
  void add_deviator(int block, int first, int count, const Complex* traction, Complex* stress) const;
  /// Adds the trace of the stress of the traction [Pa] to nz planes.
  void add_trace(int block, int row, const Complex* traction, Complex* trace_of_stress) const;
  /// Surface displacement [m] (one plane) of traceless plastic strain in the layers [0, layers): that which the traction
  /// works on.
  void displacement(int block, int row, const Complex* strain, Complex* displacement, int layers) const;

private:
  /// Kernels of a layer: those of a deviator, of which xx and yy hold their difference from zz, and the trace.
  enum : int
  {
    xx = Deviator::xx,
    yy = Deviator::yy,
    yz = Deviator::yz,
    xz = Deviator::xz,
    xy = Deviator::xy,
    trace,
    kernel_count
  };
  /// For `lane_count` wavenumbers. Every kernel is even or odd in x and in y: the imaginary parts of those that are odd in
  /// one of them alone, real parts otherwise.
  using Kernels = std::array<Lanes, kernel_count>;
  [[nodiscard]] Parity parity(int which) const;
  [[nodiscard]] ComplexLanes phased(int which, int row, const ComplexLanes& value) const;
  [[nodiscard]] const Kernels* kernels(int block, int row) const;
  [[nodiscard]] Kernels& kernels_at(int row, int column, int layer);
  void tabulate_cells(int layer, double poisson_ratio, const PaddedFft& fft);
  void tabulate_waves(int layer, double poisson_ratio, const PaddedFft& fft);

  VolumeGrid grid_;
  const BlockedFft& fft_;
  Traction traction_;
  int rows_;                       ///< stored rows, ky >= 0
  AlignedVector<Kernels> kernels_; ///< [block][row][layer]
};

} // namespace brinell::halfspace
