// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/grid.hpp"
#include "foundation/aligned.hpp"
#include "foundation/lane_fft.hpp"
#include "foundation/row_fft.hpp"

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

  [[nodiscard]] const SurfaceGrid& grid() const { return grid_; }
  [[nodiscard]] int px() const { return px_; }               ///< padded cells along x
  [[nodiscard]] int py() const { return py_; }               ///< padded cells along y
  [[nodiscard]] int kx() const { return px_ / 2 + 1; }       ///< stored wavenumbers along x
  [[nodiscard]] std::size_t plane() const { return plane_; } ///< complex values from one plane to the next

  /// Angular wavenumber of column i [rad/m], >= 0.
  [[nodiscard]] double wavenumber_x(int i) const;
  /// Angular wavenumber of row j [rad/m], signed; negative for j > py/2.
  [[nodiscard]] double wavenumber_y(int j) const;

  /// Buffers of `forward` and `inverse`, one per thread.
  struct Scratch
  {
    RowFft::Work row;
    AlignedVector<ComplexLanes> rows;   ///< [block of wavenumbers along x][row of the grid]
    AlignedVector<ComplexLanes> column; ///< [py]
    AlignedVector<ComplexLanes> work;   ///< of the columns
  };
  [[nodiscard]] Scratch make_scratch() const { return make_scratch(grid_.ny); }
  /// Spectrum of one real field on the grid (unnormalised: sum of f e^{-i k x}).
  void forward(const double* field, Complex* spectrum, Scratch& scratch) const;
  /// Real field on the grid of one spectrum (scaled by 1/(px py)).
  void inverse(const Complex* spectrum, double* field, Scratch& scratch) const;
  /// Spectrum of a real field given on the whole padded plane px * py (kernels).
  void forward_padded(std::span<const double> field, Complex* spectrum) const;

private:
  [[nodiscard]] Scratch make_scratch(int rows) const;
  void forward(const RowFft& row_fft, int nx, int ny, const double* field, Complex* spectrum, Scratch& scratch) const;

  SurfaceGrid grid_;
  int px_ = 0, py_ = 0;
  std::size_t plane_ = 0;
  RowFft rows_, full_rows_; ///< of the grid, of the padded plane
  LaneFft columns_;
};

} // namespace brinell
