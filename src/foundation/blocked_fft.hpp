// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/grid.hpp"
#include "foundation/aligned.hpp"
#include "foundation/lane_fft.hpp"
#include "foundation/lanes.hpp"
#include "foundation/row_fft.hpp"

namespace brinell
{

/// Neighbouring rows of a spectrum, wavenumbers along y.
struct SpectrumRows
{
  int first = 0, count = 0;
  /// Processed together, so that memory is read and written in pieces of four ComplexLanes.
  static constexpr int most = 4;
};

/// Zero-padded transforms (as PaddedFft) of many planes at once: the components of a field in every layer of a volume.
///
/// The operators of a layered body couple all planes at one wavenumber. The spectrum is therefore divided into blocks of
/// `lane_count` neighbouring wavenumbers along x, each small enough for the cache, and the transforms along x and y are separate:
///   rows      [block][plane][ny]      after the transform along x; the zero padding in y is not stored
///   spectrum  [plane][pitch]          of one block: py wavenumbers along y, wrapped; the pitch holds them
/// of ComplexLanes, the wavenumbers of a block. Lanes beyond the last wavenumber hold zeros. The pitch is odd, at the price of
/// one unused row: were it divisible by a power of two, the planes at one wavenumber would fall into few sets of the caches
/// and evict each other. Planned once; every function is const and may be called from several threads for different planes
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
  [[nodiscard]] int blocks() const { return rows_.blocks(); }
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
  [[nodiscard]] int batches() const { return (grid_.ny + RowFft::most_rows - 1) / RowFft::most_rows; }

  struct Scratch
  {
    RowFft::Work rows;
    AlignedVector<ComplexLanes> column; ///< [py]: buffer for the caller, between its forward and inverse transforms
    AlignedVector<ComplexLanes> work;   ///< of LaneFft
  };
  [[nodiscard]] Scratch make_scratch() const;

  /// Along x: one real field on the grid to its rows (unnormalised).
  void rows_forward(const double* field, int plane, ComplexLanes* rows, Scratch& scratch) const;
  /// One batch of these rows.
  void rows_forward(const double* field, int plane, int batch, ComplexLanes* rows, Scratch& scratch) const;
  /// Along y: the rows of one plane in one block to its py values.
  void columns_forward(const ComplexLanes* rows, int block, int plane, ComplexLanes* column, Scratch& scratch) const;
  /// Inverse along y.
  void columns_inverse(const ComplexLanes* column, int block, int plane, ComplexLanes* rows, Scratch& scratch) const;
  /// Inverse along x, to the field on the grid (scaled by 1/(px py)).
  void rows_inverse(const ComplexLanes* rows, int plane, double* field, Scratch& scratch) const;
  /// One batch of its rows.
  void rows_inverse(const ComplexLanes* rows, int plane, int batch, double* field, Scratch& scratch) const;

private:
  [[nodiscard]] std::ptrdiff_t rows_at(int block, int plane) const;
  [[nodiscard]] RowFft::Spectra rows_layout() const;

  SurfaceGrid grid_;
  int planes_ = 0;
  RowFft rows_;
  LaneFft columns_;
};

} // namespace brinell
