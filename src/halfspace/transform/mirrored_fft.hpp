// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/deviator.hpp"
#include "brinell/foundation/grid.hpp"
#include "foundation/aligned.hpp"
#include "foundation/lane_fft.hpp"
#include "foundation/row_fft.hpp"

#include <array>
#include <vector>

namespace brinell::halfspace
{

/// Transforms of deviator fields whose two sides about the plane y = 0 are mirror images (SurfaceGrid::is_mirrored_y): half the
/// work of BlockedFft, between half of the rows and half of the wavenumbers along y.
///
/// The spectrum at -n is w^n times that at n for a field that is even in y, and -w^n times for an odd field, where
/// w = e^{2 pi i (ny - 1)/py} accounts for the position of the plane y = 0. An even and an odd field are therefore transformed
/// together as their sum, from whose spectrum both are recovered:
///   even(n) = (both(n) + w^{-n} both(-n)) / 2      odd(n) = (both(n) - w^{-n} both(-n)) / 2
/// Three components are even and two odd: in each layer xx is paired with xy and yy with yz. The remaining half rows of xz are
/// combined from two layers for the transform along x.
class MirroredFft
{
public:
  /// @param px, py  padded lengths
  MirroredFft(const VolumeGrid& grid, int px, int py);

  [[nodiscard]] int independent_rows() const { return half_; } ///< rows of a field that are read and written
  [[nodiscard]] int rows() const
  {
    return 2 * half_;
  } ///< of a plane: even, so that half of them are the independent ones
  /// Number of values in the rows of all planes, between the transforms along x and y.
  [[nodiscard]] std::size_t rows_size() const;

  /// Two layers form a group, which has five planes.
  static constexpr int layers_of_group = 2;
  static constexpr int planes_of_group = 5;
  [[nodiscard]] static int groups(int layers) { return (layers + layers_of_group - 1) / layers_of_group; }

  /// A component of the field in one layer.
  struct Part
  {
    int layer = -1, component = 0; ///< layer -1: none
    [[nodiscard]] bool is_there() const { return layer >= 0; }
  };
  /// Contents of a plane: an even part and an odd one, or two even ones.
  struct Plane
  {
    Part first, second;
    bool
        is_shared; ///< true: each part has half of the rows (two even parts); false: the plane is the sum of both parts
    [[nodiscard]] bool is_empty() const { return !first.is_there(); }
  };
  /// @param layers  number of layers of the field that are transformed
  [[nodiscard]] static Plane plane(int number, int layers);

  struct Scratch
  {
    RowFft::Work row_work;
    AlignedVector<ComplexLanes> column_work;
    AlignedVector<double> field;                         ///< of one plane
    AlignedVector<ComplexLanes> rows, series, spectrum;  ///< of one plane
    std::array<AlignedVector<ComplexLanes>, 2> of_parts; ///< spectra of the parts of a plane, for the caller
  };
  [[nodiscard]] Scratch make_scratch() const;

  /// Along x: one plane of a field of deviators.
  /// @param first_rows  for each part of the plane, the first independent row that is not zero; rows before it are not read
  /// @param out         rows of all planes; if two parts share a plane, those of the second are in reverse order, so that the
  ///                    nonzero rows of both are contiguous
  void rows_forward(const double* deviators, int number, int layers, const std::array<int, 2>& first_rows,
                    ComplexLanes* out, Scratch& scratch) const;
  /// Rows of this plane alone, as above.
  /// @param out   of the first block
  /// @param apart  values from one block to the next
  void rows_forward_to(const double* deviators, int number, int layers, const std::array<int, 2>& first_rows,
                       ComplexLanes* out, const RowFft::Spectra& apart, Scratch& scratch) const;
  /// Along y: transforms the planes of one group in one block to the spectrum of the block at the wavenumbers >= 0,
  /// [layer][component][pitch].
  void columns_forward(const ComplexLanes* in, int block, int group, int layers, ComplexLanes* spectrum, int pitch,
                       Scratch& scratch) const;
  /// Inverse along y: the parts of a plane at the wavenumbers >= 0 in one block to the rows of the plane in the scratch.
  /// @param second  nullptr if there is none
  void columns_inverse(const Plane& parts, const ComplexLanes* first, const ComplexLanes* second, int block,
                       Scratch& scratch) const
  {
    columns_inverse_to(parts, first, second, scratch.rows.data() + static_cast<std::ptrdiff_t>(block) * rows(),
                       scratch);
  }
  /// Inverse to the rows of a plane in this block, as above.
  void columns_inverse_to(const Plane& parts, const ComplexLanes* first, const ComplexLanes* second, ComplexLanes* out,
                          Scratch& scratch) const;
  /// Inverse along x: from the rows in the scratch to the independent rows of the parts.
  void rows_inverse(const Plane& parts, double* deviators, Scratch& scratch) const
  {
    rows_inverse_from(parts, scratch.rows.data(), layout(1), deviators, scratch);
  }
  /// Inverse from rows elsewhere, as above.
  void rows_inverse_from(const Plane& parts, const ComplexLanes* rows_of_plane, const RowFft::Spectra& apart,
                         double* deviators, Scratch& scratch) const;

private:
  [[nodiscard]] int py() const { return columns_.length(); }
  [[nodiscard]] RowFft::Spectra layout(int planes) const;
  [[nodiscard]] std::ptrdiff_t field_at(const Part& part) const;
  void complete_even(ComplexLanes* spectrum) const;
  void pack(const double* even, const double* odd, int first_row, double* plane) const;
  void pack_shared(const Plane& parts, const double* deviators, const std::array<int, 2>& first_rows,
                   double* plane) const;
  void unpack(const double* plane, double* even, double* odd) const;
  void split(const ComplexLanes* both, ComplexLanes* even, ComplexLanes* odd) const;
  void join(const ComplexLanes* even, const ComplexLanes* odd, ComplexLanes* both) const;

  VolumeGrid grid_;
  int half_;
  RowFft rows_;
  LaneFft columns_;
  std::vector<Complex> phase_; ///< w^n
};

} // namespace brinell::halfspace
