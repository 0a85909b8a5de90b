// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/host_device.hpp"
#include "foundation/larger.hpp"

#include <cmath>

/// Terms of the sums over cells in the iteration of the elastic contact, each of one cell; without branches, so that loops over cells
/// need none.
namespace brinell::contact
{

/// Whether the iteration changes the pressure of a cell: the cell is under pressure, or the surfaces overlap there.
[[nodiscard]] BRINELL_HOST_DEVICE inline bool is_free(double pressure, double gap)
{
  return (pressure > 0.0) | (gap < 0.0);
}

/// A sum over the cells under pressure, and their number.
struct PressedSum
{
  double sum = 0.0, count = 0.0;
  BRINELL_HOST_DEVICE PressedSum& operator+=(const PressedSum& other)
  {
    sum += other.sum;
    count += other.count;
    return *this;
  }
  [[nodiscard]] double mean() const { return count > 0.0 ? sum / count : 0.0; }
};

/// The gap at zero approach of a cell under pressure.
[[nodiscard]] BRINELL_HOST_DEVICE inline PressedSum pressed_term(double p, double displacement, double distance)
{
  return {p > 0.0 ? displacement + distance : 0.0, p > 0.0 ? 1.0 : 0.0};
}

/// Errors of both parts of the complementarity condition: largest |gap| under pressure, and largest penetration elsewhere [m].
struct Errors
{
  double gap = 0.0, penetration = 0.0;
  BRINELL_HOST_DEVICE Errors& operator+=(const Errors& other)
  {
    gap = larger(gap, other.gap);
    penetration = larger(penetration, other.penetration);
    return *this;
  }
};

[[nodiscard]] BRINELL_HOST_DEVICE inline Errors error_term(double p, double gap)
{
  return {std::abs(p > 0.0 ? gap : 0.0), p > 0.0 ? 0.0 : -gap};
}

/// Sums over the free cells, from which the next direction follows.
struct Slopes
{
  double correction = 0.0, correction_descent = 0.0; ///< sum of the pressure that would close the gap; with the gap
  double before = 0.0, before_descent = 0.0;         ///< sum of the previous direction; with the gap
  double gap = 0.0, count = 0.0;
  BRINELL_HOST_DEVICE Slopes& operator+=(const Slopes& other)
  {
    correction += other.correction;
    correction_descent += other.correction_descent;
    before += other.before;
    before_descent += other.before_descent;
    gap += other.gap;
    count += other.count;
    return *this;
  }
};

/// @param correction pressure that would close the gap
/// @param direction  of the previous iteration
[[nodiscard]] BRINELL_HOST_DEVICE inline Slopes slope_term(double p, double gap, double correction, double direction)
{
  const double free = is_free(p, gap) ? 1.0 : 0.0;
  return {free * correction, free * gap * correction, free * direction, free * gap * direction, free * gap, free};
}

/// Number of cells whose pressure a step cuts off at zero, and the sum of the pressure after the step.
struct StepSums
{
  double cut = 0.0, pressure = 0.0;
  BRINELL_HOST_DEVICE StepSums& operator+=(const StepSums& other)
  {
    cut += other.cut;
    pressure += other.pressure;
    return *this;
  }
};

/// The pressure of a cell after a step along a direction, before it is cut off at zero.
[[nodiscard]] BRINELL_HOST_DEVICE inline double moved_pressure(double p, double gap, double step, double direction)
{
  return is_free(p, gap) ? p - step * direction : 0.0;
}

/// The step along the conjugate direction that minimises the energy, but for the curvature, and the direction itself:
/// correction + beta before - mean, in the free cells.
struct Descent
{
  double slope; ///< of the preconditioned gap
  double along; ///< slope along the direction
  double beta, mean;
};
/// @param slope  of the previous iteration, 0 to restart
[[nodiscard]] inline Descent descent_of(const Slopes& slopes, double slope, bool load_given)
{
  // An imposed load must not change: the mean over the free cells is subtracted.
  const double share = load_given && slopes.count > 0.0 ? 1.0 / slopes.count : 0.0;
  const double new_slope = slopes.correction_descent - share * slopes.correction * slopes.gap;
  const double before = slopes.before_descent - share * slopes.before * slopes.gap;
  double beta = slope > 0.0 ? new_slope / slope : 0.0;
  if (!(new_slope + beta * before > 0.0)) // the set of free cells has changed: restart
    beta = 0.0;
  return {new_slope, new_slope + beta * before, beta, share * (slopes.correction + beta * slopes.before)};
}

} // namespace brinell::contact
