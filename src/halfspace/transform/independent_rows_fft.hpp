// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/grid.hpp"
#include "foundation/row_fft.hpp"

#include <memory>
#include <mutex>
#include <span>
#include <vector>

namespace brinell::halfspace
{

/// All waves of a padded surface, [row][column], in the layout of PaddedFft: only wavenumbers >= 0 along x.
class PlaneOfWaves
{
public:
  PlaneOfWaves(const SurfaceGrid& grid, int px, int py) : grid_(grid), px_(px), py_(py) {}

  [[nodiscard]] const SurfaceGrid& grid() const { return grid_; }
  [[nodiscard]] int px() const { return px_; } ///< cells with the padding
  [[nodiscard]] int py() const { return py_; }
  [[nodiscard]] int kx() const { return px_ / 2 + 1; } ///< columns
  [[nodiscard]] std::size_t plane() const
  {
    return whole_lines(static_cast<std::size_t>(kx()) * static_cast<std::size_t>(py_));
  }
  [[nodiscard]] double wavenumber_x(int column) const; ///< [rad/m], >= 0
  [[nodiscard]] double wavenumber_y(int row) const;    ///< [rad/m], negative for row > py/2
  /// Number of values rounded up to whole cache lines, so that each of several consecutive fields begins on one.
  [[nodiscard]] static std::size_t whole_lines(std::size_t values) { return (values + 7) / 8 * 8; }

private:
  SurfaceGrid grid_;
  int px_, py_;
};

/// Transforms of surface fields that compute only the independent rows of the spectrum: all rows; on a grid that is mirrored,
/// whose fields are even or odd about the middle row, those with wavenumbers >= 0 along y. At -n the spectrum is w^n (even) or
/// -w^n (odd) times that at n, w = e^{2 pi i (ny - 1)/py}.
class IndependentRowsFft
{
public:
  IndependentRowsFft(const SurfaceGrid& grid, int px, int py);

  [[nodiscard]] const PlaneOfWaves& full_plane() const { return full_plane_; }
  [[nodiscard]] int rows() const { return rows_; } ///< number of independent rows, the first ones of the plane
  /// Complex values from one field of independent rows to the next: whole cache lines.
  [[nodiscard]] std::size_t plane() const { return plane_; }

  /// The independent rows of the spectrum of a field, which must be even on a grid that is mirrored.
  [[nodiscard]] AlignedVector<Complex> forward(std::span<const double> field) const;
  /// The independent rows of the spectrum of a field.
  struct Spectrum
  {
    const Complex* waves; ///< rows of kx values, and `slack` values more
    int columns;          ///< columns from this one on count as zero; their values are ignored
  };
  static constexpr std::size_t slack = lane_count;
  /// A window of cells of the grid. On a mirrored one it must be centred along y.
  struct Window
  {
    int first_column, columns, first_row, rows;
  };
  [[nodiscard]] Window whole() const { return {0, full_plane_.grid().nx, 0, full_plane_.grid().ny}; }
  /// Fields on the grid, or in a window of it, from the independent rows of their spectra.
  /// @param is_odd  parity of the first fields, which repeats for the following ones; ignored on a grid that is not mirrored
  /// @param adds    whether the result is added to `fields`; otherwise they are overwritten
  void inverse(std::span<const Spectrum> spectra, const std::vector<bool>& is_odd, bool adds,
               const std::vector<std::span<double>>& fields) const
  {
    inverse(spectra, is_odd, adds, fields, whole());
  }
  void inverse(std::span<const Spectrum> spectra, const std::vector<bool>& is_odd, bool adds,
               const std::vector<std::span<double>>& fields, const Window& window) const;

  /// All rows of an even field from the independent ones.
  void complete(const Complex* rows, Complex* all) const;

private:
  [[nodiscard]] bool is_mirrored() const { return full_plane_.grid().is_mirrored_y; }
  /// An even and an odd field that are transformed as their sum, or one of them alone. On a grid that is not mirrored `even` is any field.
  struct Pair
  {
    const Spectrum *even, *odd; ///< nullptr if there is none
  };
  struct Work
  {
    AlignedVector<ComplexLanes> column, lanes;
    AlignedVector<ComplexLanes> rows; ///< of the grid, waves along x: [block][row]
    RowFft::Work row;
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
  [[nodiscard]] int rows_of(std::size_t pair, const Batch& batch) const;
  void fill_column(const Pair& pair, int first, ComplexLanes* column) const;
  void invert_columns(const Pair& pair, int rows, ComplexLanes* to, int apart, Work& work) const;
  void invert(const Batch& batch, bool adds, Work& work) const;
  [[nodiscard]] std::unique_ptr<Work> acquire_work() const;

  PlaneOfWaves full_plane_;
  LaneFft columns_;
  std::unique_ptr<const RowFft> row_fft_;
  int rows_;
  std::size_t plane_;
  std::vector<Complex> phase_; ///< w^n of the independent rows
  std::unique_ptr<WorkPool> pool_ = std::make_unique<WorkPool>();
};

} // namespace brinell::halfspace
