// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/green/elastic.hpp"
#include "brinell/halfspace/heat_response.hpp"

#include <optional>

namespace brinell::halfspace
{

/// Flux into the surface of an elastic half space -> displacement of the surface along z at the end, where the flux has been constant
/// and has moved over a body that was cold.
///
/// Of a step whose flux is still looked for it is the part that follows the flux: with what remains of the steps before,
/// `ThermalField::displacement`, it is the displacement once the step is taken up, and it is planned as that of one cell.
class ThermalResponse
{
public:
  /// @param motion     without end: `SteadyField::displacement`
  /// @param reference  SteadyMotion::reference, of a flux without end
  /// @throws InputError if a constant or the duration is not above 0, or there is no steady displacement
  ThermalResponse(const SurfaceGrid& grid, const Thermal& thermal, const Elastic& elastic, const HeatMotion& motion,
                  std::optional<double> reference = {});

  [[nodiscard]] const SurfaceGrid& grid() const;

  /// Buffers of one call; make one per concurrent caller, once.
  struct Buffers;
  using Scratch = Hidden<Buffers>;
  [[nodiscard]] Scratch make_scratch() const;
  /// @param flux          [W/m^2] per cell
  /// @param displacement  into the body [m] per cell; overwritten
  void apply(std::span<const double> flux, std::span<double> displacement, Scratch& scratch) const;

private:
  struct Operator;
  Hidden<Operator> operator_;
};

} // namespace brinell::halfspace
