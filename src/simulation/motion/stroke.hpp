// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/simulation/sliding.hpp"
#include "simulation/stepping/stepper.hpp"

namespace brinell::simulation
{

/// Evaluates a stroke of sliding: means over its steps, and the state at its end.
class StrokeReader
{
public:
  void begin_stroke(const Stepper& stepper);
  void add(const SlidingRecord& record);
  /// @param last  last row of the stroke
  [[nodiscard]] SlidingStroke end_stroke(const Stepper& stepper, const SlidingRecord& last) const;

  void exchange(Archive& archive);

private:
  /// Sums over the steps of the stroke; names as in the rows.
  struct Sums
  {
    double F_n = 0.0, F_ploughing = 0.0, F_friction = 0.0, contact_area = 0.0, contact_fraction = 0.0, patches = 0.0,
           largest_patch = 0.0, mean_gap = 0.0, max_pressure = 0.0;
    int steps = 0;

    void exchange(Archive& archive);
  };
  Sums sums_;
  double plastic_before_ = 0.0, friction_before_ = 0.0; ///< [J]
  double friction_ = 0.0;                               ///< heat of friction since the start [J]
};

} // namespace brinell::simulation
