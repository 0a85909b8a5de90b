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
  void add(TuggingRecord record);
  [[nodiscard]] const TuggingRecord& last() const { return last_; }
  [[nodiscard]] int steps() const { return summary_.steps; }
  [[nodiscard]] TuggingSummary result() const;
  void exchange(Archive& archive);

private:
  void at_alignment(const TuggingRecord& before, const TuggingRecord& now);

  TuggingSummary summary_;
  TuggingRecord last_;
  double largest_work_ = 0.0;
};

} // namespace brinell::simulation
