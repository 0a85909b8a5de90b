// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/grid.hpp"
#include "foundation/aligned.hpp"
#include "foundation/lane_fft.hpp"
#include "foundation/lanes.hpp"
#include "foundation/row_fft.hpp"

#include <vector>

namespace brinell
{

/// w^n for n in [0, py/2], w = e^{2 pi i (ny - 1)/py}: on a grid whose sides of y = 0 are mirror images, the spectrum at the
/// wavenumber -n along y is w^n times that at n for a field that is even in y, and -w^n times for an odd one.
[[nodiscard]] std::vector<Complex> phases_of_mirror(int ny, int py);

/// Neighbouring rows of a spectrum, wavenumbers along y.
struct SpectrumRows
{
  int first = 0, count = 0;
  /// Processed together, so that memory is read and written in pieces of four ComplexLanes.
  static constexpr int most = 4;
};

/// Zero-padded transforms of many planes at once: the components of a field in every layer of a volume.
///
/// The operators of a layered body couple all planes at one wavenumber. The spectrum is therefore divided into blocks of
/// `lane_count` neighbouring wavenumbers along x, each small enough for the cache, and the transforms along x and y are separate:
///   rows      [block][plane][row]     after the transform along x; the zero padding in y is not stored
///   spectrum  [plane][pitch]          of one block: py wavenumbers along y, wrapped; the pitch holds them
/// of ComplexLanes, the wavenumbers of a block. Lanes beyond the last wavenumber hold zeros. The pitch is odd, at the price of
/// one unused row: were it divisible by a power of two, the planes at one wavenumber would fall into few sets of the caches
/// and evict each other.
///
/// On a mirrored grid only the independent rows of a field are read and written, and only the wavenumbers >= 0 along y of a
/// spectrum, [0, py/2] (`phases_of_mirror`).
///
/// Planned once; every function is const and may be called from several threads for different planes
/// or blocks, each with its own Scratch.
class BlockedFft
{
public:
  /// @param px, py  padded lengths (PaddedFft chooses them).
  BlockedFft(const SurfaceGrid& grid, int px, int py, int planes);

  [[nodiscard]] const SurfaceGrid& grid() const { return grid_; }
  [[nodiscard]] int px() const { return rows_.length(); }
  [[nodiscard]] int py() const { return columns_.length(); }
  [[nodiscard]] int kx() const { return rows_.wavenumbers(); } ///< along x
  [[nodiscard]] int planes() const { return planes_; }
  [[nodiscard]] const RowFft& along_x() const { return rows_; }
  [[nodiscard]] const LaneFft& along_y() const { return columns_; }
  [[nodiscard]] int blocks() const { return rows_.blocks(); }
  /// Number of wavenumbers along y of a spectrum, from the first one.
  [[nodiscard]] int waves_along_y() const { return grid_.is_mirrored_y ? py() / 2 + 1 : py(); }
  /// The row of the wavenumber along y with the same magnitude and a sign >= 0.
  [[nodiscard]] int folded(int row) const { return row > py() / 2 ? py() - row : row; }
  /// Values from one plane to the next in a spectrum.
  [[nodiscard]] int pitch() const { return py() | 1; }
  /// Values of all rows, and of the spectrum of one block.
  [[nodiscard]] std::size_t rows_size() const;
  [[nodiscard]] std::size_t block_size() const;
  /// Place of a plane in spectra of all blocks, one after the other.
  [[nodiscard]] std::ptrdiff_t plane_at(int block, int plane) const;

  /// Number of batches in which the rows of a plane are transformed.
  [[nodiscard]] int batches() const { return (stored_rows() + RowFft::most_rows - 1) / RowFft::most_rows; }

  struct Scratch
  {
    RowFft::Work rows;
    AlignedVector<ComplexLanes> column; ///< [py]: buffer for the caller, between its forward and inverse transforms
    AlignedVector<ComplexLanes> work;   ///< of LaneFft
    AlignedVector<ComplexLanes> both;   ///< both sides of a mirrored grid
  };
  [[nodiscard]] Scratch make_scratch() const;

  /// Along x: one real field on the grid to its rows (unnormalised).
  void rows_forward(const double* field, int plane, ComplexLanes* rows, Scratch& scratch) const;
  /// One batch of these rows.
  void rows_forward(const double* field, int plane, int batch, ComplexLanes* rows, Scratch& scratch) const;
  /// The rows of one plane alone.
  /// @param rows   of the first block
  /// @param apart  values from one block to the next
  void rows_forward_to(const double* field, ComplexLanes* rows, const RowFft::Spectra& apart, Scratch& scratch) const;
  /// Along y: the rows of one plane in one block to its py values.
  /// @param is_odd  of a mirrored grid: whether the field is odd in y
  void columns_forward(const ComplexLanes* rows, int block, int plane, ComplexLanes* column, Scratch& scratch,
                       bool is_odd = false) const;
  /// Inverse along y.
  void columns_inverse(const ComplexLanes* column, int block, int plane, ComplexLanes* rows, Scratch& scratch,
                       bool is_odd = false) const;
  /// Inverse along x, to the field on the grid (scaled by 1/(px py)).
  void rows_inverse(const ComplexLanes* rows, int plane, double* field, Scratch& scratch) const;
  /// One batch of its rows.
  void rows_inverse(const ComplexLanes* rows, int plane, int batch, double* field, Scratch& scratch) const;
  /// From the rows of one plane alone, see rows_forward_to.
  void rows_inverse_from(const ComplexLanes* rows, const RowFft::Spectra& apart, double* field, Scratch& scratch) const;

private:
  [[nodiscard]] int stored_rows() const { return grid_.independent_rows(); } ///< of a plane
  [[nodiscard]] std::ptrdiff_t rows_at(int block, int plane) const;
  [[nodiscard]] RowFft::Spectra rows_layout() const;
  const ComplexLanes* both_sides(const ComplexLanes* series, bool is_odd, ComplexLanes* both) const;
  const ComplexLanes* all_waves(const ComplexLanes* column, bool is_odd, ComplexLanes* all) const;

  SurfaceGrid grid_;
  int planes_ = 0;
  RowFft rows_;
  LaneFft columns_;
  std::vector<Complex> phase_; ///< of a mirrored grid
};

} // namespace brinell
