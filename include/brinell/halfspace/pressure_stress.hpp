// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/deviator.hpp"
#include "brinell/foundation/fft.hpp"

#include <vector>

namespace brinell::halfspace
{

/// Surface pressure -> stress under it, and its transpose: plastic strain -> normal displacement of the surface.
///
/// Closed form of the uniformly loaded rectangle (Love 1929), one convolution per layer; the value of a cell is the mean
/// over the layer's thickness at the middle of the cell in x and y. The transpose is Betti's theorem,
///   u(x) = integral of s^(unit load at x) : eps_p dV,
/// with the same coefficients, so the discrete system stays symmetric.
///
/// Everything here works on spectra of one PaddedFft: a stress or strain is 5 * nz planes, component by component
/// (order of Deviator), layer by layer.
class PressureStress
{
public:
  /// @param fft  transform of the surface of `grid`; must outlive this object.
  PressureStress(const VolumeGrid& grid, double poisson_ratio, const PaddedFft& fft);

  /// Adds the deviatoric stress of the pressure [Pa] to `stress_hat` (layers [0, layers)).
  void add_deviator(const Complex* pressure_hat, Complex* stress_hat, int layers) const;
  /// Trace of the stress of the pressure [Pa], nz planes.
  void trace(const Complex* pressure_hat, Complex* trace_hat) const;
  /// Normal surface displacement [m], positive into the body, of traceless plastic strain (layers [0, layers)): one plane.
  void displacement(const Complex* strain_hat, Complex* displacement_hat, int layers) const;

private:
  enum Kernel : int
  {
    xx_minus_zz,
    yy_minus_zz,
    yz,
    xz,
    xy,
    tr,
    kernel_count
  };
  [[nodiscard]] const double* kernel(int which, int layer, int row) const;
  void tabulate(int layer, double poisson_ratio);

  VolumeGrid grid_;
  const PaddedFft& fft_;
  int rows_;                    ///< stored rows of a kernel's quadrant
  std::vector<double> spectra_; ///< [kernel][layer][row][kx]; imaginary parts for yz and xz, real parts otherwise
};

} // namespace brinell::halfspace
