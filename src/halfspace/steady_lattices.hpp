// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/grid.hpp"
#include "brinell/green/thermal.hpp"
#include "moving_wave.hpp"

#include <cmath>
#include <functional>
#include <span>
#include <vector>

namespace brinell::halfspace
{

/// What a unit flux through one cell, which has moved along x for ever, gives at the offsets between all cells:
/// docs/theory/heat.md (steady-lattices).
///
/// A periodic lattice sees the heat of the time in which the flux has come half of its period, and lattices of two, four, eight times its period
/// that of all times before, with what takes off its images: far away, smooth, and of few waves.
class SteadyLattices
{
public:
  /// @param velocity  along x [m/s]; 0 on open grids only
  SteadyLattices(const SurfaceGrid& grid, const Thermal& thermal, double velocity);

  /// Some fields at one depth.
  struct Fields
  {
    /// Their waves from those of the heat.
    std::function<void(const SurfaceWave&, double depth, const ThermalWave&, std::span<Complex> out)> waves;
    std::vector<bool> is_odd; ///< in y
  };
  /// The offsets, as cells of a grid with that of no offset in the middle; a periodic axis begins with it.
  [[nodiscard]] const SurfaceGrid& offsets() const { return offsets_; }
  /// @returns [depth][field][offset]
  [[nodiscard]] std::vector<std::vector<double>> tables(std::span<const double> depths, const Fields& fields) const;

private:
  /// One axis of the finest lattice.
  struct Axis
  {
    int length;       ///< cells of its period
    int first, count; ///< of the offsets [cells]
    double size;      ///< of a cell [m]
    bool is_open;
    [[nodiscard]] double extent() const { return count == 1 ? size : 0.5 * (count + 1) * size; }
    [[nodiscard]] double period(int level) const { return is_open ? std::ldexp(length * size, level) : length * size; }
  };
  /// Where fields that come from afar are computed, and from there to all offsets.
  struct Nodes
  {
    std::vector<double> places;  ///< [m]
    std::vector<double> weights; ///< [place][node]
    [[nodiscard]] std::size_t size() const { return places.size(); }
  };
  using Values = std::vector<double>;

  [[nodiscard]] Nodes nodes(const Axis& along) const;
  [[nodiscard]] Nodes nodes_in_depth(std::span<const double> depths) const;
  [[nodiscard]] MovingFlux flux(int level) const;
  [[nodiscard]] int levels(double deepest) const;
  [[nodiscard]] SurfaceWave wave(int a, int b, int level) const;
  void add_near(std::span<const double> depths, const Fields& fields, std::span<Values> out) const;
  void add_far(int level, double factor, std::span<const double> depths, const Fields& fields, const Nodes& along_x,
               const Nodes& along_y, std::vector<Values>& out) const;

  Thermal thermal_;
  double velocity_;
  Axis x_{}, y_{};
  SurfaceGrid offsets_;
  double clear_ = 0.0; ///< from what a lattice leaves out to the nearest offset: twice as far at each level [m]
};

} // namespace brinell::halfspace
