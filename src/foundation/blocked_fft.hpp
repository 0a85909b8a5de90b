// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/grid.hpp"
#include "foundation/aligned.hpp"
#include "foundation/lanes.hpp"

#include <memory>

namespace brinell
{

/// Zero-padded transforms (as PaddedFft) of many planes at once: the components of a field in every layer of a volume.
///
/// Work on a layered body couples all planes at one wavenumber. So the spectrum is cut into blocks of `lane_count`
/// neighbouring wavenumbers along x, each small enough for the cache, and the transforms along x and y are apart:
///   rows      [block][plane][ny][lane]         after the transform along x; the zero padding in y is not stored
///   spectrum  [block][row][pitch][lane]        row = wavenumber index along y, wrapped; the pitch holds the planes
/// Lanes beyond the last wavenumber hold zeros. The pitch is odd, at the price of one unused plane: were it divisible by
/// a power of two, the rows of a column would fall into few sets of the caches and evict each other. Planned once; every function is const and may be called from several
/// threads for different planes or blocks, each with its own Scratch.
class BlockedFft
{
public:
  /// @param px, py  padded lengths (PaddedFft chooses them).
  BlockedFft(const SurfaceGrid& grid, int px, int py, int planes);
  ~BlockedFft();
  BlockedFft(const BlockedFft&) = delete;
  BlockedFft& operator=(const BlockedFft&) = delete;

  [[nodiscard]] const SurfaceGrid& grid() const { return grid_; }
  [[nodiscard]] int px() const { return px_; }
  [[nodiscard]] int py() const { return py_; }
  [[nodiscard]] int kx() const { return px_ / 2 + 1; } ///< wavenumbers along x
  [[nodiscard]] int planes() const { return planes_; }
  /// Places for planes in one row of the spectrum: from one row to the next, pitch() * lane_count complex values.
  [[nodiscard]] int pitch() const { return planes_ | 1; }
  /// The row of the opposite wavenumber along y.
  [[nodiscard]] int mirrored(int row) const { return row == 0 ? 0 : py_ - row; }
  [[nodiscard]] int blocks() const { return (kx() + lane_count - 1) / lane_count; }
  /// Complex values of all rows, and of the spectrum of one block.
  [[nodiscard]] std::size_t rows_size() const;
  [[nodiscard]] std::size_t block_size() const;

  /// The rows of a plane are transformed in batches that stay in the cache, so many of them:
  [[nodiscard]] int batches() const { return (grid_.ny + batch_rows_ - 1) / batch_rows_; }

  /// The columns of neighbouring planes are transformed together, so that the spectrum is read and written in pieces long
  /// enough for the memory. Ten planes: the components of two layers.
  static constexpr int group_planes = 10;
  /// Groups of the first `planes` planes.
  [[nodiscard]] static int groups(int planes) { return (planes + group_planes - 1) / group_planes; }

  struct Scratch
  {
    AlignedVector<double> real;     ///< [px]
    AlignedVector<Complex> half;    ///< [row of a batch][blocks][lane]
    AlignedVector<Complex> padded;  ///< [py][lane], zero beyond row ny
    AlignedVector<Complex> column;  ///< [py][lane]
    AlignedVector<Complex> columns; ///< [plane of a group][py][lane]: the spectrum of a group
  };
  [[nodiscard]] Scratch make_scratch() const;

  /// Along x: one real field on the grid to its rows (unnormalised).
  void rows_forward(const double* field, int plane, Complex* rows, Scratch& scratch) const;
  /// One batch of them.
  void rows_forward(const double* field, int plane, int batch, Complex* rows, Scratch& scratch) const;
  /// Along y: the rows of one group of the first `planes` planes in one block to `scratch.columns`,
  void columns_forward(const Complex* rows, int block, int group, int planes, Scratch& scratch) const;
  /// and from there into the spectrum of the block.
  void scatter(const Scratch& scratch, int group, int planes, Complex* spectrum) const;
  /// The way back along y: from the spectrum to `scratch.columns`,
  void gather(const Complex* spectrum, int group, int planes, Scratch& scratch) const;
  /// and from there, which is left as it is, to the rows.
  void columns_inverse(Scratch& scratch, int block, int group, int planes, Complex* rows) const;
  /// The way back along x, to the field on the grid (scaled by 1/(px py)).
  void rows_inverse(const Complex* rows, int plane, double* field, Scratch& scratch) const;
  /// One batch of its rows.
  void rows_inverse(const Complex* rows, int plane, int batch, double* field, Scratch& scratch) const;

private:
  struct Plans;
  [[nodiscard]] int width() const { return blocks() * lane_count; } ///< wavenumbers along x with the unused lanes
  [[nodiscard]] std::size_t rows_at(int block, int plane) const;
  [[nodiscard]] int rows_in(int batch) const;
  [[nodiscard]] bool past_caches() const { return rows_size() * sizeof(Complex) > cached_bytes; }
  /// Complex values of one column, and of its part on the grid.
  [[nodiscard]] std::ptrdiff_t column_size() const { return static_cast<std::ptrdiff_t>(py_) * lane_count; }
  [[nodiscard]] std::ptrdiff_t grid_column_size() const { return static_cast<std::ptrdiff_t>(grid_.ny) * lane_count; }

  SurfaceGrid grid_;
  int px_ = 0, py_ = 0, planes_ = 0;
  int batch_rows_ = 1; ///< the last batch may have fewer
  std::unique_ptr<Plans> plans_;
};

} // namespace brinell
