// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/grid.hpp"
#include "brinell/foundation/hidden.hpp"
#include "brinell/green/thermal.hpp"

#include <limits>
#include <span>

namespace brinell::halfspace
{

/// How long a flux acts on a body, and how it moves over the body meanwhile.
struct HeatMotion
{
  double duration = std::numeric_limits<double>::infinity(); ///< [s], > 0; without end: the steady state
  double velocity_x = 0.0, velocity_y = 0.0;                 ///< of the flux over the body [m/s]

  bool operator==(const HeatMotion&) const = default;
};

/// Flux into the surface of a half space -> rise of its temperature at the end, where the flux has been constant and has
/// moved over the surface; no heat leaves the surface elsewhere: docs/theory/heat.md (moving-cell).
///
/// Cells of uniform flux, convolved exactly: there are no images of open axes, at any Peclet number. Temperatures are those in the
/// centres of the cells, at the end, when the flux is on the cells that it is given on.
class HeatResponse
{
public:
  /// @throws InputError for a steady state that there is not: of a flux that goes on for ever and does not move, or moves
  ///         along a period, where an axis is periodic; or if a constant or the duration is not above 0
  HeatResponse(const SurfaceGrid& grid, const Thermal& thermal, const HeatMotion& motion);

  /// Of two bodies to the same flux: the sum of their temperatures.
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
