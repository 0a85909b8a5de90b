// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/grid.hpp"
#include "foundation/aligned.hpp"
#include "foundation/blocked_fft.hpp"

#include <memory>
#include <mutex>
#include <span>
#include <vector>

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
/// A spectrum is a plane of rows of kx = px/2 + 1 complex values (row = wavenumber index along y, wrapped; column = wavenumber
/// index along x, >= 0): all py rows, on a mirrored grid only those >= 0 (BlockedFft). Planned once; every function is const and
/// may be called from several threads.
class PaddedFft
{
public:
  /// Pads to the `padded_lengths`.
  explicit PaddedFft(const SurfaceGrid& grid);
  PaddedFft(const SurfaceGrid& grid, int px, int py);

  [[nodiscard]] const SurfaceGrid& grid() const { return fft_.grid(); }
  [[nodiscard]] int px() const { return fft_.px(); }                ///< padded cells along x
  [[nodiscard]] int py() const { return fft_.py(); }                ///< padded cells along y
  [[nodiscard]] int kx() const { return fft_.kx(); }                ///< stored wavenumbers along x
  [[nodiscard]] int rows() const { return fft_.waves_along_y(); }   ///< stored wavenumbers along y
  [[nodiscard]] std::size_t plane() const { return plane(rows()); } ///< complex values from one spectrum to the next
  [[nodiscard]] std::size_t whole_plane() const { return plane(py()); } ///< of all rows of a mirrored grid

  /// Angular wavenumber of column i [rad/m], >= 0.
  [[nodiscard]] double wavenumber_x(int i) const;
  /// Angular wavenumber of row j [rad/m], signed; negative for j > py/2.
  [[nodiscard]] double wavenumber_y(int j) const;

  /// Spectrum of a real field on the grid, even on a mirrored one (unnormalised: sum of f e^{-i k x}).
  void forward(std::span<const double> field, Complex* spectrum) const;
  [[nodiscard]] AlignedVector<Complex> forward(std::span<const double> field) const;
  /// Spectrum of a real field given on the whole padded plane px * py (kernels).
  [[nodiscard]] AlignedVector<Complex> forward_padded(std::span<const double> field) const;

  struct Spectrum
  {
    const Complex* waves; ///< rows of kx values
    int columns;          ///< columns from this one on count as zero; their values are ignored
  };
  /// A window of cells of the grid. On a mirrored one it must be centred along y.
  struct Window
  {
    int first_column, columns, first_row, rows;
  };
  [[nodiscard]] Window whole() const { return {0, grid().nx, 0, grid().ny}; }
  /// Fields on the grid, or in a window of it, from their spectra (scaled by 1/(px py)). All rows of a mirrored grid are written.
  /// @param is_odd  parity of the first fields, which repeats for the following ones; ignored on a grid that is not mirrored
  /// @param adds    whether the result is added to `fields`; otherwise they are overwritten
  void inverse(std::span<const Spectrum> spectra, const std::vector<bool>& is_odd, bool adds,
               const std::vector<std::span<double>>& fields, const Window& window) const;
  void inverse(std::span<const Spectrum> spectra, const std::vector<bool>& is_odd, bool adds,
               const std::vector<std::span<double>>& fields) const
  {
    inverse(spectra, is_odd, adds, fields, whole());
  }
  /// One field.
  void inverse(const Complex* spectrum, std::span<double> field, bool is_odd = false) const;

  /// All rows of the spectrum of an even field from those that are stored.
  void complete(const Complex* stored, Complex* all) const;

private:
  /// An even and an odd field that are transformed as their sum, or one of them alone. On a grid that is not mirrored `even` is
  /// any field.
  struct Pair
  {
    const Spectrum *even, *odd; ///< nullptr if there is none
  };
  struct Work
  {
    BlockedFft::Scratch blocked;
    AlignedVector<ComplexLanes> rows; ///< of the grid, waves along x: [block][row]
    std::vector<double> field;
  };
  /// Pool of buffers, one per concurrent caller. They are reused, because for small surfaces allocating them takes as long as a
  /// transform.
  class WorkPool
  {
  public:
    [[nodiscard]] std::unique_ptr<Work> acquire();
    void release(std::unique_ptr<Work> work);

  private:
    std::mutex mutex_;
    std::vector<std::unique_ptr<Work>> idle_;
  };
  /// Fields that are transformed back together.
  struct Batch
  {
    std::span<const Spectrum> spectra;
    std::span<const std::span<double>> fields;
    std::span<const std::size_t> even, odd; ///< numbers of those
    Window window;
  };
  /// Rounded up to whole cache lines.
  [[nodiscard]] std::size_t plane(int rows) const
  {
    return (static_cast<std::size_t>(kx()) * static_cast<std::size_t>(rows) + 7) / 8 * 8;
  }
  [[nodiscard]] bool is_mirrored() const { return grid().is_mirrored_y; }
  [[nodiscard]] std::unique_ptr<Work> acquire_work() const;
  void forward(const BlockedFft& fft, std::span<const double> field, Complex* spectrum) const;
  [[nodiscard]] int rows_of(std::size_t pair, const Batch& batch) const;
  void fill_column(const Pair& pair, int first, ComplexLanes* column) const;
  void invert_columns(const Pair& pair, int rows, ComplexLanes* to, int apart, Work& work) const;
  void invert(const Batch& batch, bool adds, Work& work) const;

  BlockedFft fft_, full_; ///< of the grid, of the padded plane
  std::vector<Complex> phase_;
  std::unique_ptr<WorkPool> pool_ = std::make_unique<WorkPool>();
};

} // namespace brinell
