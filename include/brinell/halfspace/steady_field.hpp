// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/green/elastic.hpp"
#include "brinell/halfspace/heat_response.hpp"
#include "brinell/halfspace/thermal_field.hpp"

#include <optional>
#include <vector>

namespace brinell::halfspace
{

/// How a flux moves that has always been there.
struct SteadyMotion
{
  double velocity = 0.0; ///< of the flux over the body, along x [m/s]
  /// Distance from a flux at rest at which the surface counts as not displaced [m], > 0. Of a flux that moves the displacement counts from
  /// far away.
  std::optional<double> reference{};

  bool operator==(const SteadyMotion&) const = default;
};

/// Flux into the surface of an elastic half space -> displacement of the surface, and temperature and stress in the body, where the
/// flux has always been there and has moved over the surface at one velocity: docs/theory/heat.md (steady-waves).
///
/// The surface is free of traction, and beside the flux insulated. The flux is the trigonometric polynomial through its values on the cells.
/// There are no images of open axes, to some 1e-5 of the largest value.
class SteadyField
{
public:
  /// @param depths  of the layers [m], >= 0, in any order
  /// @throws InputError if a constant is not above 0, a depth is below 0, a rigid body has depths, or there is no steady state: of a body
  ///         that is periodic along x, or along y under a flux at rest
  SteadyField(const SurfaceGrid& grid, const Thermal& thermal, const Elastic& elastic, const SteadyMotion& motion,
              std::vector<double> depths = {});

  [[nodiscard]] const SurfaceGrid& grid() const;
  [[nodiscard]] const std::vector<double>& depths() const;

  /// @param flux  [W/m^2] per cell
  /// @param out   displacement of the surface into the body [m] per cell; overwritten
  /// @throws InputError if the flux is at rest and there is no reference
  void displacement(std::span<const double> flux, std::span<double> out) const;
  /// The layers from the first one on, each as its parts are wanted.
  void layers(std::span<const double> flux, std::size_t first, std::span<const ThermalLayer> out) const;

private:
  struct State;
  Hidden<State> state_;
};

} // namespace brinell::halfspace
