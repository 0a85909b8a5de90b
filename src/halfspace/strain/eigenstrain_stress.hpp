// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/deviator.hpp"
#include "brinell/green/elastic.hpp"
#include "foundation/blocked_fft.hpp"
#include "foundation/lane_functions.hpp"
#include "layer_waves.hpp"

#include <array>

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
/// plus, inside the layer, the stress of a uniform layer held in its plane. Mirror image and Boussinesq's pressure, which
/// free the surface, together decay downwards like one more wave that starts at the surface, with the amplitudes
///   a = -F,  c = C + 2 F,  w = W,   F = int (a - k z' c_-) e^-kz' dz',  C = int c_- e^-kz' dz',  W = int w_- e^-kz' dz'
/// of the waves that arrive from below: docs/theory/half-space.md (sheet-stress), (sheet-shear), (free-surface). The strain is
/// constant in a layer, and the stress of a layer is its mean over the thickness: the operator is therefore symmetric, and its
/// energy exact for such a strain.
///
/// In the plane the strain is the trigonometric interpolant of the cell values, periodic over the padded lengths;
/// halfspace::ImageCorrection removes the images.
class EigenstrainStress
{
public:
  /// @param fft  any transform of the surface of `grid`, which determines the padded lengths; must outlive this object.
  EigenstrainStress(const VolumeGrid& grid, const Elastic& elastic, const BlockedFft& fft,
                    const layer_waves::Shortest& shortest = {});
  EigenstrainStress(const EigenstrainStress&) = delete;
  EigenstrainStress& operator=(const EigenstrainStress&) = delete;

  using Layer = layer_waves::Layer;     ///< stored by the upward pass of `apply` for its downward pass
  using Scratch = AlignedVector<Layer>; ///< [layer][row]
  [[nodiscard]] Scratch make_scratch() const
  {
    return Scratch(static_cast<std::size_t>(grid_.nz) * static_cast<std::size_t>(SpectrumRows::most));
  }

  /// Strain and stress at the wavenumbers of one block.
  struct Spectra
  {
    const ComplexLanes* strain; ///< [layer][component][pitch], traceless plastic strain
    int strained;               ///< layers [0, strained) are read, the strain in the others is zero
    ComplexLanes* stress;       ///< deviatoric stress [Pa] in the same layout
    int layers;                 ///< layers [0, layers) are written
    ComplexLanes* trace;        ///< nullptr, or [layer][pitch] for the trace of the stress [Pa]
  };
  /// Non-local part of the residual stress at some rows of one block (the caller adds `layer_waves::add_local` in real space).
  void apply(int block, const SpectrumRows& rows, const Spectra& spectra, Scratch& scratch) const;

private:
  using Factors = layer_waves::Factors;
  struct Tile;
  void go_through(const SpectrumRows& rows, const Spectra& spectra, Tile& tile, Scratch& scratch) const;
  void go_up(const SpectrumRows& rows, const Spectra& spectra, Tile& tile, Scratch& scratch) const;
  void go_down(const SpectrumRows& rows, const Spectra& spectra, Tile& tile, const Scratch& scratch) const;

  VolumeGrid grid_;
  double nu_, mu_;
  const BlockedFft& fft_;
  std::size_t spectra_bytes_;      ///< of the stress at all wavenumbers
  AlignedVector<Factors> factors_; ///< [block][row], only rows with ky >= 0
};

} // namespace brinell::halfspace
