// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/halfspace/heat_response.hpp"
#include "depth_waves.hpp"
#include "foundation/fft.hpp"

#include <functional>
#include <vector>

namespace brinell::halfspace
{

/// One wave along the surface.
struct SurfaceWave
{
  double kx, ky, k; ///< [rad/m]
  double odd_x,
      odd_y; ///< kx, ky for what is odd in them: 0 for the shortest wave of an even number of cells, which cannot tell
};

/// One wave of the temperature at one depth, and what its potential psi, lap(psi) = -T with d psi/dz = 0 at the surface, is there.
struct HeatAtDepth
{
  Complex temperature;          ///< [K]
  Complex potential, slope;     ///< k psi and d psi/dz [K m]
  Complex potential_at_surface; ///< k psi for z = 0 [K m]
};

/// The weights of the waves in depth at one depth, in the sums of `HeatAtDepth`.
struct DepthFactors
{
  double depth; ///< [m]
  std::vector<double> temperature, potential, slope, at_surface;
};
[[nodiscard]] DepthFactors depth_factors(const DepthWaves& waves, double depth);

/// The memory of one periodic surface: for each wave in depth and in the plane, the heat that has decayed since it entered.
class HeatMemory
{
public:
  /// @param grid    where flux and temperature are; periods px, py cells of it
  HeatMemory(const SurfaceGrid& grid, int px, int py, const Thermal& thermal, DepthWaves waves);

  [[nodiscard]] const SurfaceGrid& grid() const { return fft_.grid(); }

  /// Adds `factor` times the temperature of the surface that remains after `duration`, of cells with a uniform flux each.
  /// @param heated  those cells
  void add_remaining(double duration, double factor, const SurfaceGrid& heated, std::span<double> temperature) const;

  /// The waves of some fields at one of several depths from that of the heat, one after the other.
  using FieldsOfHeat = std::function<void(double depth, const SurfaceWave&, const HeatAtDepth&, std::span<Complex>)>;
  /// Adds `factor` times the fields that remain after `duration`, of a flux that is the trigonometric polynomial through its values.
  /// For duration = 0 they are those at the end of the last step.
  /// @param depths  factors of all waves, of which those of this memory are the last ones; for each depth
  /// @param fields  as many at each depth, [depth][field][cell]
  void add_fields(double duration, double factor, std::span<const DepthFactors> depths,
                  const FieldsOfHeat& fields_of_heat, std::vector<std::vector<double>>& fields) const;

  /// All decays over the motion, and its flux comes in.
  void take_up(std::span<const double> flux, const HeatMotion& motion) { take_up(flux, motion, true); }
  /// More flux comes in over the last motion, which all has decayed over already.
  void amend(std::span<const double> flux, const HeatMotion& motion) { take_up(flux, motion, false); }

  [[nodiscard]] const AlignedVector<Complex>& heat() const { return heat_; }
  [[nodiscard]] AlignedVector<Complex>& heat() { return heat_; }

private:
  struct Row;
  struct Sums;
  [[nodiscard]] std::size_t index(int row, int column) const;
  [[nodiscard]] double in_plane(int row, int column) const; ///< kappa k^2 [1/s]
  [[nodiscard]] SurfaceWave surface_wave(int row, int column) const;
  [[nodiscard]] Row gather(int row, double duration, std::span<const DepthFactors> depths) const;

  void take_up(std::span<const double> flux, const HeatMotion& motion, bool decays);
  void add_slowest(std::size_t at, double k, double depth, HeatAtDepth& sum) const;

  PaddedFft fft_;
  double diffusivity_, conductivity_;
  DepthWaves waves_;
  AlignedVector<Complex> heat_;    ///< [wave][plane] [K m]
  std::vector<double> slow_share_; ///< of each wavenumber, for fields
};

} // namespace brinell::halfspace
