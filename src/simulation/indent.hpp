// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/simulation/indentation.hpp"

namespace brinell::simulation
{

/// Reads the load-depth curve of one indent while its steps come in.
class IndentReader
{
public:
  IndentReader() = default;
  /// @param touch  approach at which the surfaces touch: the curve begins there [m]
  IndentReader(double x, int place, int cycle, double touch);

  /// Adds a step.
  /// @param opening  approach at which the surfaces touch, if they do not [m]
  /// @returns the work of the drive in the step (trapezoidal rule) [J]
  double add(const IndentationRecord& record, double opening);
  [[nodiscard]] Indent result() const;

  void exchange(Archive& archive);

private:
  [[nodiscard]] double slope_at_peak(int direction) const;
  [[nodiscard]] int neighbour(int point, int direction) const;

  Indent indent_;
  std::vector<double> approach_, load_; ///< the curve
  int peak_ = 0;                        ///< its point of the largest load
};

} // namespace brinell::simulation
