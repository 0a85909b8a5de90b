// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/halfspace/heat_response.hpp"
#include "foundation/fft.hpp"
#include "halfspace/transform/depth_sums.hpp"
#include "heat_coat.hpp"

#include <memory>
#include <span>
#include <vector>

namespace brinell::halfspace
{

/// Sums over the waves in depth at the surface, without the factors that are the same for all of them; [row][column].
struct SurfaceSums
{
  double duration;
  AlignedVector<Complex> temperature; ///< temperature that remains after `duration`
  /// After `duration`, and now; and the heat of the slowest wave in depth. Empty if only the temperature is wanted.
  AlignedVector<Complex> potential, potential_now, slowest;
};

/// Weights of the waves in depth in these sums.
struct SurfaceWeights
{
  std::size_t first_left = 0; ///< first wave that has not decayed after the duration
  std::vector<double> temperature, potential, potential_now;
  std::vector<double> left; ///< decay factors of all waves
};

/// Waves along the surface and in depth in which a periodic surface remembers its heat: how they decay, how their heat lies in
/// memory, and sums over them. On a grid that is mirrored only the independent rows of waves are stored.
struct HeatWaves
{
  /// @param grid     grid of flux and temperature
  /// @param px, py   periods, in cells of the grid
  /// @param surface  factors of all waves in depth at the surface, of which `waves` are the last ones
  /// @param coat_of_body  nullptr: a homogeneous body
  HeatWaves(const SurfaceGrid& grid, int px, int py, const Thermal& thermal, DepthWaves waves,
            const DepthFactors& surface, std::shared_ptr<const HeatCoat> coat_of_body = nullptr);

  [[nodiscard]] std::size_t columns() const { return static_cast<std::size_t>(fft.kx()); }
  /// Index of the first wave of a row.
  [[nodiscard]] std::size_t begin_of(int row) const { return static_cast<std::size_t>(row) * columns(); }
  [[nodiscard]] std::span<const SurfaceWave> row_of_waves(int row) const;
  /// Number of blocks of `lane_count` columns in a row; lanes beyond the last column are zero.
  [[nodiscard]] std::size_t blocks() const { return (columns() + lane_count - 1) / lane_count; }
  [[nodiscard]] std::size_t block_of(int row) const { return static_cast<std::size_t>(row) * blocks(); }

  /// Decay factor e^{-kappa s^2 t} of each wave in depth after the time t = `duration`.
  [[nodiscard]] std::vector<double> left_in_depth(double duration) const;
  /// The heat that a flux brings to each wave in a step, if none decayed.
  [[nodiscard]] AlignedVector<Complex> heat_of(std::span<const double> flux, const HeatMotion& motion) const;
  [[nodiscard]] SurfaceWeights surface_weights(double duration) const;
  [[nodiscard]] SurfaceSums empty_sums(double duration) const;
  // A run that goes on from a checkpoint computes the sums anew, and must find the same digits. Inlined at two places, the same
  // lines may be compiled to other orders of multiplication and addition.
  /// @param heat  of the row: [block][wave]
  [[gnu::noinline]] void sum_row(int row, const ComplexLanes* heat, const SurfaceWeights& weights,
                                 SurfaceSums& sums) const;

  /// Sum over the waves in depth for a part of what heat does in a coated body, of the columns of a block.
  /// @param heat    [wave]
  /// @param left    decay factors of the waves
  /// @param buffer  as many values as waves
  [[nodiscard]] ComplexLanes coated_sum(HeatCoat::Part part, std::size_t depth, const HeatCoat::Place& place,
                                        const ComplexLanes* heat, std::span<const double> left,
                                        std::span<Lanes> buffer) const;

  /// Planes of waves in the layout of a grid that is not mirrored; real and imaginary parts alternate.
  [[nodiscard]] std::vector<double> whole(const AlignedVector<Complex>& planes) const;
  /// Inverse of `whole`.
  [[nodiscard]] AlignedVector<Complex> independent_rows_of(std::span<const double> values) const;

  PaddedFft fft;
  double diffusivity, conductivity;
  std::shared_ptr<const HeatCoat> coat; ///< nullptr: a homogeneous body
  DepthWaves in_depth;
  std::vector<double> at_surface;  ///< weights of all waves except the last one in the potential at the surface
  std::vector<SurfaceWave> along;  ///< [plane]
  AlignedVector<Lanes> k;          ///< [row][block]
  AlignedVector<Lanes> slow_share; ///< [row][block], only for fields
};

} // namespace brinell::halfspace
