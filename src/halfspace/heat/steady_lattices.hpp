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

/// Fields by a unit flux through one cell that has moved along x for an infinite time, at all offsets between cells:
/// docs/theory/heat.md (steady-lattices).
///
/// A periodic lattice accounts for the heat that has entered while the flux moved by half of the period. Lattices with two, four,
/// eight, ... times the period account for the heat of earlier times and remove the images of the lattice before; these far
/// fields are smooth and consist of few waves.
class SteadyLattices
{
public:
  /// @param velocity  along x [m/s]; may be 0 only on open grids
  SteadyLattices(const SurfaceGrid& grid, const Thermal& thermal, double velocity);

  /// Definition of some fields at one depth.
  struct Fields
  {
    /// Computes one wave of each field from the wave of the heat.
    std::function<void(const SurfaceWave&, double depth, const ThermalWave&, std::span<Complex> out)> waves;
    std::vector<bool> is_odd; ///< in y
  };
  /// All offsets, as cells of a grid; zero offset is in the middle along an open axis and first along a periodic one.
  [[nodiscard]] const SurfaceGrid& offsets() const { return offsets_; }
  /// @returns [depth][field][offset]
  [[nodiscard]] std::vector<std::vector<double>> tables(std::span<const double> depths, const Fields& fields) const;

private:
  /// One axis of the finest lattice.
  struct Axis
  {
    int length;       ///< cells of its period
    int first, count; ///< smallest offset and number of offsets [cells]
    double size;      ///< of a cell [m]
    bool is_open;
    [[nodiscard]] double extent() const { return count == 1 ? size : 0.5 * (count + 1) * size; }
    [[nodiscard]] double period(int level) const { return is_open ? std::ldexp(length * size, level) : length * size; }
  };
  /// Nodes along one axis at which far fields are computed, and weights that interpolate from them to all offsets.
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
  /// Distance from the heat that a lattice omits to the nearest offset; doubles with each level [m].
  double clear_ = 0.0;
};

} // namespace brinell::halfspace
