// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/deviator.hpp"
#include "brinell/foundation/fft.hpp"
#include "brinell/green/elastic.hpp"

#include <vector>

namespace brinell::halfspace
{

/// Plastic strain -> residual stress in a half space whose surface is free of traction.
///
/// In the wavenumber domain of x and y the field of a layer of plastic strain is a few exponentials of depth, so the
/// sum over all layers is two running sums, one downwards and one upwards, in O(nz) operations and without stored
/// kernels. With k = |(m, n)|, l the direction of the wavevector, t across it, g = sign(z - z'), s = k |z - z'|,
///   a = (1 - 2 nu)(eps_ll + eps_zz),  c_g = eps_ll - eps_zz + 2 i g eps_lz,  w_g = eps_lt + i g eps_tz,
/// and P = mu k / (2 (1 - nu)), a sheet of strain at z' gives (full space)
///   sigma_ll = P e^-s (a + 2 c_g - s c_g)       sigma_zz = P e^-s (-a + s c_g)
///   sigma_lz = i g P e^-s (a + c_g - s c_g)     sigma_tt = nu (sigma_ll + sigma_zz)
///   sigma_lt = mu k e^-s w_g                    sigma_tz = i g mu k e^-s w_g
/// plus, inside the layer, the stress of a uniform layer held in its plane. Mirror image and Boussinesq's pressure that
/// frees the surface are, with F = int (a - k z' c_-) e^-kz' dz', C = int c_- e^-kz' dz', W = int w_- e^-kz' dz' and
/// V = C + 2 F,
///   sigma_ll = P e^-kz (F + V + C - k z V)      sigma_zz = P e^-kz (F + k z V)
///   sigma_lz = i P e^-kz (F + C - k z V)        sigma_lt = mu k e^-kz W,   sigma_tz = i sigma_lt.
/// (Mura 1987, Eq. 11.30 for the potentials; derivation in docs/theory.md.) The stress of a layer is its mean over the
/// thickness, as the strain is constant in it: the operator is symmetric, and its energy exact for such a strain.
///
/// In the plane the strain is the trigonometric interpolant of the cell values, periodic over the padded lengths;
/// halfspace::ImageCorrection removes the images.
class EigenstrainStress
{
public:
  EigenstrainStress(const VolumeGrid& grid, const Elastic& elastic, const PaddedFft& fft);

  /// Non-local part of the residual stress (the caller adds `local_stress` in real space).
  /// @param strain_hat  5 * nz planes, traceless plastic strain.
  /// @param stress_hat  5 * nz planes, deviatoric stress [Pa]; overwritten in layers [0, layers).
  /// @param trace_hat   nullptr, or nz planes for the trace of the stress [Pa].
  void apply(const Complex* strain_hat, Complex* stress_hat, int layers, Complex* trace_hat = nullptr) const;

  /// Deviator of the local stress [Pa]: a uniform, unbounded layer held in its plane (plane stress across it).
  [[nodiscard]] Deviator local_stress(const Deviator& strain) const;
  /// Trace of the same [Pa].
  [[nodiscard]] double local_trace(const Deviator& strain) const;

private:
  struct Block;
  void apply_block(int row, int first, int count, const Complex* strain_hat, Complex* stress_hat, int layers,
                   Complex* trace_hat) const;

  VolumeGrid grid_;
  double nu_, mu_;
  const PaddedFft& fft_;
  /// Factors of one wavenumber, [row][kx]; rows of the quadrant ky >= 0.
  struct Factors
  {
    std::vector<double> lx, ly, lx2, ly2, lxly; ///< direction of the wavevector; products odd in a Nyquist index are 0
    std::vector<double> q;                      ///< e^{-k dz}
    std::vector<double> e0, e1, e2, e3;         ///< neighbouring layers
    std::vector<double> m0, m1, m2;             ///< a layer on itself
    std::vector<double> s0, s1, x;              ///< layer means of e^{-kz} and k z e^{-kz}; x = k dz
  } factor_;
};

} // namespace brinell::halfspace
