// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/simulation/tugging.hpp"

namespace brinell::simulation
{

/// Integrates the work and gathers the key numbers while the steps come in.
class Summariser
{
public:
  /// Adds a step; its work is set here (trapezoidal rule in X, from pass to pass without the way back).
  void add(StepRecord record);
  [[nodiscard]] const StepRecord& last() const { return last_; }
  [[nodiscard]] TuggingSummary result() const;

private:
  void at_alignment(const StepRecord& before, const StepRecord& now);

  TuggingSummary summary_;
  StepRecord last_;
  double largest_work_ = 0.0;
};

} // namespace brinell::simulation
