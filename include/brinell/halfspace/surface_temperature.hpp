// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/halfspace/heat_response.hpp"

namespace brinell::halfspace
{

/// The times that a body is heated for.
struct HeatTimes
{
  double shortest_step = 0.0; ///< [s], > 0
  double duration = 0.0;      ///< of all steps together [s], >= shortest_step
};

/// What a half space remembers of the heat that has entered its surface: flux, step by step, -> rise of the temperature of the
/// surface later on.
///
/// The grid is at rest on the body, on which the flux moves. A state of fixed size takes up step after step, exactly
/// for a flux that is constant over a step while it moves; a step costs the same however many there were: docs/theory/heat.md
/// (memory). To the temperature at the end of a step, what remains of all steps before, belongs that of the step's own flux,
/// `HeatResponse` of the same motion.
class SurfaceTemperature
{
public:
  /// @throws InputError if a constant or a time is not above 0
  SurfaceTemperature(const SurfaceGrid& grid, const Thermal& thermal, const HeatTimes& times);

  [[nodiscard]] const SurfaceGrid& grid() const;
  [[nodiscard]] double time() const; ///< of all steps taken up [s]

  /// What remains of all steps before, some time after the last one.
  /// @param duration     [s], >= HeatTimes::shortest_step: the length of the step that follows
  /// @param temperature  rise [K] per cell; overwritten
  void remaining(double duration, std::span<double> temperature) const;
  /// Takes up a step.
  /// @param flux  into the body at the end of the step [W/m^2] per cell; before, the same flux was further back
  /// @throws InputError if the step is shorter than the shortest or exceeds the duration of all steps
  void take_up(std::span<const double> flux, const HeatMotion& motion);

private:
  struct State;
  Hidden<State> state_;
};

} // namespace brinell::halfspace
