// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/grid.hpp"
#include "brinell/foundation/hidden.hpp"
#include "brinell/green/thermal_stack.hpp"

#include <limits>
#include <span>

namespace brinell::halfspace
{

/// Duration for which a flux acts on a body, and its motion over the body during that time.
struct HeatMotion
{
  double duration = std::numeric_limits<double>::infinity(); ///< [s], > 0; infinite: the steady state
  double velocity_x = 0.0, velocity_y = 0.0;                 ///< of the flux over the body [m/s]

  bool operator==(const HeatMotion&) const = default;
};

/// Memory that the response of a coated body takes while it is found, whose velocity is along x [bytes]; 0 of a homogeneous body.
[[nodiscard]] double memory_of_response(const SurfaceGrid& grid, const ThermalStack& thermal, double duration);

/// Checks that the cells represent the first layer of a coated body that conducts heat.
/// @throws InputError if it is thinner than a quarter of a cell
void require_resolved(const SurfaceGrid& grid, const ThermalStack& stack);

/// Flux into the surface of a half space -> temperature rise of the surface at the end of the motion, for a flux that has been
/// constant while it moved over the surface; outside the flux the surface is insulated: docs/theory/heat.md (moving-cell).
///
/// The flux is uniform in each cell and the convolution is exact: there are no images of open axes, at any Peclet number.
/// Temperatures are those at the centres of the cells at the end of the motion, when the flux has arrived at the cells on which
/// it is given.
class HeatResponse
{
public:
  /// @throws InputError if the duration is infinite but no steady state exists (on a grid with a periodic axis, for a flux that
  ///         is at rest or moves along periodic axes only), or if a constant or the duration is not above 0
  HeatResponse(const SurfaceGrid& grid, const Thermal& thermal, const HeatMotion& motion);

  /// Of a coated body, for a finite duration: the response of a half space of its first layer, and what the layers beneath add to it.
  /// @throws InputError also as `require_resolved`
  HeatResponse(const SurfaceGrid& grid, const ThermalStack& thermal, const HeatMotion& motion);

  /// Response of two bodies to the same flux: the sum of their temperature rises.
  /// @throws InputError if the grids are not the same
  [[nodiscard]] static HeatResponse of_both(const HeatResponse& one, const HeatResponse& other);

  [[nodiscard]] const SurfaceGrid& grid() const;

  /// Buffers of one call; make one per concurrent caller, once.
  struct Buffers;
  using Scratch = Hidden<Buffers>;
  [[nodiscard]] Scratch make_scratch() const;
  /// @param flux         [W/m^2] per cell
  /// @param temperature  rise [K] per cell; overwritten
  void apply(std::span<const double> flux, std::span<double> temperature, Scratch& scratch) const;

private:
  struct Operator;
  explicit HeatResponse(Hidden<Operator> given);
  Hidden<Operator> operator_;
};

} // namespace brinell::halfspace
