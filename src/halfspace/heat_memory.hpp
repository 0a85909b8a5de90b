// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/halfspace/heat_response.hpp"
#include "foundation/fft.hpp"

#include <vector>

namespace brinell::halfspace
{

/// Waves in depth that share the memory of a conducting half space. Of a unit of heat, exp(-kappa k^2 t)/sqrt(pi kappa t) is left at the
/// surface at a wavenumber k, and
///     1/sqrt(pi kappa t) = 2/pi int_0^inf exp(-kappa s^2 t) ds,
/// a sum over waves cos(s z). In ln s the trapezoidal rule converges exponentially, so that few of them serve all times.
struct DepthWave
{
  double number = 0.0; ///< s [1/m]
  double weight = 0.0; ///< [1/m]
};

/// @param shortest, longest  times that the sum shall hold for [s]
[[nodiscard]] std::vector<DepthWave> depth_waves(double diffusivity, double shortest, double longest);

/// The memory of one periodic surface: for each wave in depth and in the plane, the heat that has decayed since it entered.
class HeatMemory
{
public:
  /// @param grid    where flux and temperature are; periods px, py cells of it
  /// @param heated  whose cells have a uniform flux each
  HeatMemory(const SurfaceGrid& grid, int px, int py, const SurfaceGrid& heated, const Thermal& thermal,
             std::vector<DepthWave> waves);

  [[nodiscard]] const SurfaceGrid& grid() const { return fft_.grid(); }

  /// Adds `factor` times the temperature that remains after `duration`.
  void add_remaining(double duration, double factor, std::span<double> temperature) const;
  /// All decays over the motion, and its flux comes in.
  void take_up(std::span<const double> flux, const HeatMotion& motion);

private:
  [[nodiscard]] std::size_t index(int row, int column) const;
  [[nodiscard]] double in_plane(int row, int column) const; ///< kappa k^2 [1/s]

  PaddedFft fft_;
  double cell_x_, cell_y_; ///< of uniform flux [m]
  double diffusivity_, conductivity_;
  std::vector<DepthWave> waves_;
  AlignedVector<Complex> heat_; ///< [wave][plane] [K m]
};

} // namespace brinell::halfspace
