// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/halfspace/heat_response.hpp"

namespace brinell::halfspace
{

/// Time scales of a heating history.
struct HeatTimes
{
  double shortest_step = 0.0; ///< [s], > 0
  double duration = 0.0;      ///< of all steps together [s], >= shortest_step
};

/// Memory of the heat that has entered the surface of a half space: flux, step by step -> temperature rise of the surface at
/// later times.
///
/// The grid is fixed to the body, and the flux moves over it. The state has a fixed size, and every step costs the same
/// regardless of the number of steps before; a step is exact for a flux that is constant while it moves: docs/theory/heat.md
/// (memory). The temperature at the end of a step is the sum of the temperature that remains of all steps before (`remaining`)
/// and the temperature by the flux of the step itself (`HeatResponse` with the same motion).
class SurfaceTemperature
{
public:
  /// @throws InputError if a constant or a time is not above 0
  SurfaceTemperature(const SurfaceGrid& grid, const Thermal& thermal, const HeatTimes& times);

  [[nodiscard]] const SurfaceGrid& grid() const;
  [[nodiscard]] double time() const; ///< total duration of all steps so far [s]

  /// Temperature rise that remains of all steps so far, at the time `duration` after the end of the last one.
  /// @param duration     [s], >= HeatTimes::shortest_step: the length of the step that follows
  /// @param temperature  rise [K] per cell; overwritten
  void remaining(double duration, std::span<double> temperature) const;
  /// Adds a step.
  /// @param flux  into the body, at its position at the end of the step [W/m^2] per cell; earlier in the step the same flux was
  ///              further back along its motion
  /// @throws InputError if the step is shorter than the shortest or exceeds the duration of all steps
  void add_step(std::span<const double> flux, const HeatMotion& motion);

private:
  struct State;
  Hidden<State> state_;
};

} // namespace brinell::halfspace
