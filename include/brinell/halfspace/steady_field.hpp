// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/green/elastic.hpp"
#include "brinell/halfspace/heat_response.hpp"
#include "brinell/halfspace/thermal_field.hpp"

#include <optional>
#include <vector>

namespace brinell::halfspace
{

/// Motion of a flux that has acted for an infinite time.
struct SteadyMotion
{
  double velocity = 0.0; ///< of the flux over the body, along x [m/s]
  /// Distance from a flux at rest at which the displacement of the surface is taken as zero [m], > 0. For a moving flux the
  /// displacement is relative to a distant point.
  std::optional<double> reference{};

  bool operator==(const SteadyMotion&) const = default;
};

/// Flux into the surface of an elastic half space -> displacement of the surface, and temperature and stress in the body, for a
/// flux that has acted for an infinite time and moved over the surface at a constant velocity: docs/theory/heat.md
/// (steady-waves).
///
/// The surface is free of traction, and insulated outside the flux. The flux is the trigonometric interpolant of its cell values.
/// Images of open axes are removed, to about 1e-5 of the largest value.
class SteadyField
{
public:
  /// @param depths  of the layers [m], >= 0, in any order
  /// @throws InputError if a constant is not above 0, a depth is below 0, depths are given for a rigid body, or no steady state
  ///         exists: on a grid that is periodic along x, or along y with the flux at rest
  SteadyField(const SurfaceGrid& grid, const Thermal& thermal, const Elastic& elastic, const SteadyMotion& motion,
              std::vector<double> depths = {});

  [[nodiscard]] const SurfaceGrid& grid() const;
  [[nodiscard]] const std::vector<double>& depths() const;

  /// @param flux  [W/m^2] per cell
  /// @param out   displacement of the surface into the body [m] per cell; overwritten
  /// @throws InputError if the flux is at rest and `SteadyMotion::reference` is empty
  void displacement(std::span<const double> flux, std::span<double> out) const;
  /// Fields in the layers `first`, `first + 1`, ...: in each, the fields whose spans in `out` are not empty.
  void layers(std::span<const double> flux, std::size_t first, std::span<const ThermalLayer> out) const;

private:
  struct State;
  Hidden<State> state_;
};

} // namespace brinell::halfspace
