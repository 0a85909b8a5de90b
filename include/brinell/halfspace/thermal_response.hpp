// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/green/elastic_stack.hpp"
#include "brinell/green/thermal_stack.hpp"
#include "brinell/halfspace/heat_response.hpp"
#include "brinell/halfspace/surface_load.hpp"

#include <optional>

namespace brinell::halfspace
{

/// Flux into the surface of an elastic half space -> displacement of the surface at the end of the motion, for a flux that has
/// been constant while it moved over an initially cold body.
///
/// For a step whose flux is still unknown, this is the part of the displacement that depends on the flux: added to the
/// displacement that remains of the steps before (`ThermalField::displacement`), it is the displacement after the step. The
/// operator is planned from the displacement by one cell.
class ThermalResponse
{
public:
  /// @param motion     with an infinite duration the operator is `SteadyField::displacement`
  /// @param reference  SteadyMotion::reference, for an infinite duration
  /// @param components for an infinite duration only the normal one
  /// @throws InputError if a constant or the duration is not above 0, or no steady displacement exists
  ThermalResponse(const SurfaceGrid& grid, const Thermal& thermal, const Elastic& elastic, const HeatMotion& motion,
                  std::optional<double> reference = {}, Displacements components = Displacements::normal);
  /// Of a coated body, for a finite duration.
  ThermalResponse(const SurfaceGrid& grid, const ThermalStack& thermal, const ElasticStack& elastic,
                  const HeatMotion& motion, Displacements components = Displacements::normal);

  [[nodiscard]] const SurfaceGrid& grid() const;

  /// Buffers of one call; make one per concurrent caller, once.
  struct Buffers;
  using Scratch = Hidden<Buffers>;
  [[nodiscard]] Scratch make_scratch() const;
  /// @param flux          [W/m^2] per cell
  /// @param displacement  [m] per cell; overwritten; empty parts are not computed
  /// @throws InternalError for a component that is not prepared
  void apply(std::span<const double> flux, const SurfaceDisplacement& displacement, Scratch& scratch) const;

private:
  struct Operator;
  Hidden<Operator> operator_;
};

} // namespace brinell::halfspace
