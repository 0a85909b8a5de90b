// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <csignal>

namespace brinell::app
{

/// While it lives, the first SIGINT, SIGTERM or SIGHUP (a terminal that is gone) is only noted, so that a run can end after its
/// step; the second one kills.
class InterruptGuard
{
public:
  InterruptGuard();
  ~InterruptGuard();
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;

  /// The signal that came, or 0.
  [[nodiscard]] static int signal();

private:
  struct sigaction interrupt_ = {}, terminate_ = {}, hang_up_ = {}; ///< what was there before
};

} // namespace brinell::app
