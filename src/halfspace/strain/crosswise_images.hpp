// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/green/stack.hpp"
#include "foundation/aligned.hpp"
#include "foundation/lane_functions.hpp"
#include "image_samples.hpp"
#include "wave_coupling.hpp"

#include <span>
#include <vector>

namespace brinell::halfspace
{

/// Residual stress of the images beside a long grid. With padding the nearest image is half a short period away, but the grid is
/// many times longer than that, so a polynomial cannot represent their stress along the grid; waves can. Images and body have the
/// same period along the long axis, so each wave is one term. Images at a distance d contribute only in proportion to e^{-m d} at
/// the wavenumber m, so the necessary number of waves is a few times the ratio of length to width. Across the grid and in depth,
/// the stress of a wave is a polynomial like that of ImageCorrection.
///
/// Removes the images of a lattice with the short period P except those that a lattice with the period `multiple` * P also has.
class CrosswiseImages
{
public:
  /// Number of times that the short period fits into the long one; 1: there are no images to remove.
  [[nodiscard]] static int multiple(double period_x, double period_y);

  /// @param period_x, period_y  padded lengths [m], not equal
  CrosswiseImages(const VolumeGrid& grid, const ElasticStack& stack, images::Source source, double period_x,
                  double period_y);

  /// Moments of the strain, and polynomial coefficients of the stress.
  struct Response
  {
    std::vector<double> of_layers;                    ///< [component][layer][power][wave]
    std::vector<double> moments;                      ///< [component][depth][power][wave]
    std::vector<double> stress;                       ///< [component or trace][depth][power][wave]
    AlignedVector<ComplexLanes> of_strain, of_stress; ///< moments of some waves, in the layout of WaveCoupling
  };
  [[nodiscard]] Response make_response() const;
  /// Sums over y (or x) of a field in one layer, times powers of the coordinate across the grid: [cell along][power].
  using Columns = Matrix;
  static constexpr int degree = 6; ///< largest power of the distance across the grid
  static constexpr int powers = degree + 1;
  [[nodiscard]] bool is_along_x() const { return along_x_; }
  [[nodiscard]] int waves() const { return 2 * waves_; }       ///< cosines and sines, for one power
  [[nodiscard]] const Matrix& along() const { return along_; } ///< their values, [cell][wave]

  /// As in ImageCorrection: moments of the strain, then the response to them.
  /// @param first, end  cells along the grid that are read; the strain is zero in the others
  void find_moments_of_layer(const Columns& strain, int first, int end, int component, int layer,
                             Response& response) const;
  void respond(int layers, Response& response, bool is_mirrored, bool with_trace) const;
  /// Amplitudes of the waves of the stress of the images in one layer, [power][wave].
  [[nodiscard]] AlignedVector<double> amplitudes(const Response& response, int component, int layer) const;
  /// Sums of the waves at neighbouring cells along the grid, for the powers `first_power`, `first_power + next`, ...
  template <int first_power, int next>
  [[nodiscard]] std::array<Lanes, powers> sums_of_waves(const AlignedVector<double>& amplitudes, int first,
                                                        std::size_t cells) const
  {
    std::array<Lanes, powers> sums{};
    for (int wave = 0; wave < waves(); ++wave)
    {
      const Lanes along = load_lanes(along_.column(wave) + first, cells);
      for (int b = first_power; b < powers; b += next)
        sums[static_cast<std::size_t>(b)] += amplitudes[static_cast<std::size_t>(b * waves() + wave)] * along;
    }
    return sums;
  }
  /// The stress of the images as a polynomial across the grid.
  [[nodiscard]] Columns stress(const Response& response, int component, int layer) const;

private:
  [[nodiscard]] int block() const { return 2 * waves_ * powers; } ///< values for one component and one depth
  [[nodiscard]] int lanes() const { return (2 * waves_ + lane_count - 1) / lane_count; } ///< of all waves of a cell
  void fit(int wave, const ElasticStack& stack, images::Source source, double period_along, double period_across);
  [[nodiscard]] std::vector<images::WaveRow> waves_across(int wave, double period_along, double period_across) const;
  void multiply(int part, Response& response, bool is_mirrored, int components) const;
  [[nodiscard]] const std::array<int, images::stresses>& odd_along() const;
  [[nodiscard]] const std::array<int, images::stresses>& odd_across() const;
  [[nodiscard]] bool is_odd_along(int component) const { return odd_along()[static_cast<std::size_t>(component)] != 0; }

  VolumeGrid grid_;
  bool along_x_; ///< whether the long axis is x
  int multiple_;
  int waves_; ///< number of wavenumbers 2 pi i / period, i < waves_, each with a cosine and a sine
  images::DepthBasis depth_;
  Matrix along_;                       ///< [cell][2 i: cos, 2 i + 1: sin]
  AlignedVector<Lanes> along_of_cell_; ///< values of along_ as [cell][wave], zero beyond the last wave
  WaveCoupling coupling_;
};

} // namespace brinell::halfspace
