// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <csignal>

namespace brinell::app
{

/// During its lifetime, the first SIGINT, SIGTERM or SIGHUP (the terminal was closed) is only recorded, so that a run can end
/// after its step; the second signal ends the process.
class InterruptGuard
{
public:
  InterruptGuard();
  ~InterruptGuard();
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;

  /// The recorded signal; 0 if there is none.
  [[nodiscard]] static int signal();

private:
  struct sigaction interrupt_ = {}, terminate_ = {}, hang_up_ = {}; ///< previous actions
};

} // namespace brinell::app
