// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/simulation/sliding.hpp"
#include "column_sums.hpp"
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
  ColumnSums<SlidingRecord> sums_;                      ///< over the steps of the stroke
  double plastic_before_ = 0.0, friction_before_ = 0.0; ///< [J]
  double friction_ = 0.0;                               ///< heat of friction since the start [J]
};

} // namespace brinell::simulation
