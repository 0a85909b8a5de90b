// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/archive.hpp"

#include <algorithm>

/// How far evaluations may be restricted to a window: docs/theory/elastoplastic.md (windows).
namespace brinell::elastoplastic
{

/// Estimates the error of windows, as a yield error, from the first evaluation of all columns after those of a window: it finds
/// what the window has left out. Smooth strain leaves out a hundredth of what a sharp edge does.
class WindowError
{
public:
  /// Learns from the yield errors of the last evaluation of a window and of the next one of all columns.
  void compare(double of_window, double of_all)
  {
    constexpr double progress = 0.7; // ratio of the errors of two evaluations where the iteration progresses
    estimate_ = of_all > progress * of_window ? of_all : 0.5 * std::min(estimate_, of_all);
  }
  /// Yield error below which further evaluations of a window would gain little.
  [[nodiscard]] double limit() const { return 3.0 * estimate_; }
  void exchange(Archive& archive) { archive("estimate", estimate_); }

private:
  double estimate_ = 7e-4; // that of a single cell with strain
};

} // namespace brinell::elastoplastic
