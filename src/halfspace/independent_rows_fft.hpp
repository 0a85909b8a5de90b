// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/grid.hpp"
#include "brinell/foundation/symmetry.hpp"
#include "foundation/row_fft.hpp"

#include <memory>
#include <mutex>
#include <span>
#include <vector>

namespace brinell::halfspace
{

/// All waves of a surface with its padding: those along x that are not negative, [row][column], as PaddedFft has them.
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
  /// Complex values from one field to the next, each of which begins on a cache line.
  [[nodiscard]] static std::size_t whole_lines(std::size_t values) { return (values + 7) / 8 * 8; }

private:
  SurfaceGrid grid_;
  int px_, py_;
};

/// Transforms of surface fields of which some wavenumbers tell all: without symmetry all of them; of fields that are even or odd about
/// the middle row those along y that are not negative. At -n their spectrum is w^n or -w^n times that at n, w = e^{2 pi i (ny - 1)/py}.
class IndependentRowsFft
{
public:
  IndependentRowsFft(const SurfaceGrid& grid, int px, int py, Symmetry symmetry);

  [[nodiscard]] const PlaneOfWaves& all() const { return all_; }
  [[nodiscard]] int rows() const { return rows_; } ///< that tell all, the first ones of the plane
  /// Complex values of them; from one field to the next: whole cache lines.
  [[nodiscard]] std::size_t plane() const { return plane_; }

  /// Spectrum rows of the spectrum of a field, which with symmetry is even.
  [[nodiscard]] AlignedVector<Complex> forward(std::span<const double> field) const;
  /// The independent rows of the spectrum of a field.
  struct Spectrum
  {
    const Complex* waves; ///< rows of kx values, and `slack` values more
    int columns;          ///< beyond which there is nothing; what values there are does not matter
  };
  static constexpr std::size_t slack = lane_count;
  /// Cells in the middle of the grid. With symmetry as many rows lie before as behind them.
  struct Window
  {
    int first_column, columns, first_row, rows;
  };
  [[nodiscard]] Window whole() const { return {0, all_.grid().nx, 0, all_.grid().ny}; }
  /// Fields on the grid, or in a window of it, from the independent rows of their spectra.
  /// @param is_odd  of so many fields, again and again; without symmetry it does not matter
  /// @param adds    to what is there; otherwise it is overwritten
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
  /// An even and an odd field, whose sum is one; or one of them alone. Without symmetry the first one is any field.
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
  /// Where to work. What has been made is kept, as surfaces are so small that making it takes as long as a transform; every thread has
  /// its own.
  class Works
  {
  public:
    [[nodiscard]] std::unique_ptr<Work> take();
    void give(std::unique_ptr<Work> work);

  private:
    std::mutex mutex_;
    std::vector<std::unique_ptr<Work>> idle_;
  };
  /// Fields that are transformed back together.
  struct Together
  {
    std::span<const Spectrum> spectra;
    std::span<const std::span<double>> fields;
    std::span<const std::size_t> even, odd; ///< numbers of those
    Window window;
  };
  [[nodiscard]] int rows_of(std::size_t pair, const Together& together) const;
  void fill_column(const Pair& pair, int first, ComplexLanes* column) const;
  void put_in_rows(const Pair& pair, int rows, ComplexLanes* to, int apart, Work& work) const;
  void invert(const Together& together, bool adds, Work& work) const;
  [[nodiscard]] std::unique_ptr<Work> take_work() const;

  PlaneOfWaves all_;
  LaneFft columns_;
  std::unique_ptr<const RowFft> row_fft_;
  Symmetry symmetry_;
  int rows_;
  std::size_t plane_;
  std::vector<Complex> turn_; ///< w^n of the independent rows
  std::unique_ptr<Works> works_ = std::make_unique<Works>();
};

} // namespace brinell::halfspace
