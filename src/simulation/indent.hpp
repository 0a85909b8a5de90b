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
  IndentReader(double x, int place, int cycle, double touch);

  /// Adds a step.
  /// @param opening  approach at which the surfaces would touch, for a step without contact [m]
  /// @returns the work of the drive in the step (trapezoidal rule) [J]
  double add(const IndentationRecord& record, double opening);
  [[nodiscard]] Indent result() const;

  void exchange(Archive& archive);

private:
  [[nodiscard]] double slope_at_peak(int direction) const;
  [[nodiscard]] int neighbour(int point, int direction) const;

  Indent indent_;
  std::vector<double> approach_, load_; ///< the curve
  int peak_ = 0;                        ///< index of the point with the largest load
};

} // namespace brinell::simulation
