// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/simulation/indentation.hpp"

namespace brinell::simulation
{

/// Evaluates the load-depth curve of one indent step by step.
class IndentReader
{
public:
  IndentReader() = default;
  /// @param touch  approach at which the surfaces first touch, where the curve begins [m]
  IndentReader(double x, int place, double touch);

  /// The reader of the next cycle at this place.
  [[nodiscard]] IndentReader next_cycle(double touch) const;

  /// Adds a step.
  /// @param opening  approach at which the surfaces would touch, for a step without contact [m]
  /// @returns the work of the drive in the step (trapezoidal rule) [J]
  double add(const IndentationRecord& record, double opening);
  [[nodiscard]] Indent result() const;

  void exchange(Archive& archive);

private:
  /// Points of the curve on one side of the peak, beginning beside it, as long as the load decreases.
  struct Branch
  {
    std::vector<int> points; ///< each with less load than the one before, the first with less than the peak
    double origin = 0.0;     ///< approach at which the branch would reach zero load [m]; NaN if it is not known
    double lowest = 0.0;     ///< load below which the curve follows another law [N]
  };
  [[nodiscard]] Branch loading() const;
  [[nodiscard]] Branch unloading() const;
  [[nodiscard]] std::vector<int> descend(int direction) const;
  [[nodiscard]] double slope_at_peak(const Branch& branch) const;
  [[nodiscard]] double slope_of_power_law(const Branch& branch) const;
  [[nodiscard]] double slope_of_parabola(const Branch& branch) const;

  Indent indent_;
  std::vector<double> approach_, load_; ///< the curve
  int peak_ = 0;                        ///< index of the point with the largest load
  double first_touch_ = 0.0;            ///< in the first cycle at this place [m]
  double former_load_ = 0.0;            ///< largest load of earlier cycles at this place [N]
};

} // namespace brinell::simulation
