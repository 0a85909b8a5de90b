// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/grid.hpp"
#include "foundation/aligned.hpp"

#include <memory>
#include <span>

namespace brinell
{

/// Smallest even integer >= n whose only prime factors are 2, 3, 5 and 7: a fast transform length.
[[nodiscard]] int fast_length(int n);

/// Lengths of the transforms on which a product of spectra is the operator of a body on this grid. A periodic axis has the
/// length of the grid. An open one is padded to the fast length >= 2 n - 1; if the other axis is periodic, it is also padded
/// far enough for waves along that axis to decay before the next copy.
struct PaddedLengths
{
  int x = 0, y = 0;
};
[[nodiscard]] PaddedLengths padded_lengths(const SurfaceGrid& grid);

/// Real Fourier transforms of surface fields, zero-padded in x and y so that a product of spectra is a linear
/// (not a periodic) convolution within the grid (DC-FFT: Liu, Wang, Liu 2000).
///
/// A spectrum is a plane of py rows of kx = px/2 + 1 complex values (row = wavenumber index along y, wrapped;
/// column = wavenumber index along x, >= 0), stored with a pitch of `plane()` values so that planes can be batched.
/// Planned once; every function is const and may be called from several threads on different data.
class PaddedFft
{
public:
  /// Pads to the `padded_lengths`.
  explicit PaddedFft(const SurfaceGrid& grid);
  PaddedFft(const SurfaceGrid& grid, int px, int py);
  ~PaddedFft();
  PaddedFft(PaddedFft&&) noexcept;
  PaddedFft& operator=(PaddedFft&&) noexcept;
  PaddedFft(const PaddedFft&) = delete;
  PaddedFft& operator=(const PaddedFft&) = delete;

  [[nodiscard]] const SurfaceGrid& grid() const { return grid_; }
  [[nodiscard]] int px() const { return px_; }               ///< padded cells along x
  [[nodiscard]] int py() const { return py_; }               ///< padded cells along y
  [[nodiscard]] int kx() const { return px_ / 2 + 1; }       ///< stored wavenumbers along x
  [[nodiscard]] std::size_t plane() const { return plane_; } ///< complex values from one plane to the next

  /// Angular wavenumber of column i [rad/m], >= 0.
  [[nodiscard]] double wavenumber_x(int i) const;
  /// Angular wavenumber of row j [rad/m], signed; negative for j > py/2.
  [[nodiscard]] double wavenumber_y(int j) const;

  /// Number of real values that `forward` and `inverse` need as a buffer; one AlignedVector of this size per thread.
  [[nodiscard]] std::size_t scratch_size() const;
  /// Spectrum of one real field on the grid (unnormalised: sum of f e^{-i k x}).
  void forward(const double* field, Complex* spectrum, std::span<double> scratch) const;
  /// Real field on the grid of one spectrum (scaled by 1/(px py)); the spectrum is destroyed.
  void inverse(Complex* spectrum, double* field, std::span<double> scratch) const;
  /// Spectrum of a real field given on the whole padded plane px * py (kernels), cache-line aligned; it is destroyed.
  void forward_padded(std::span<double> field, Complex* spectrum) const;

private:
  struct Plans;
  SurfaceGrid grid_;
  int px_ = 0, py_ = 0;
  std::size_t plane_ = 0;
  std::unique_ptr<Plans> plans_;
};

} // namespace brinell
