// SPDX-License-Identifier: BSD-3-Clause
#include "interrupt.hpp"

namespace brinell::app
{

namespace
{

// Global, because a signal handler can access nothing else.
volatile std::sig_atomic_t noted_signal = 0;

/// The next one of any kind kills.
void note(int number)
{
  noted_signal = number;
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
  std::signal(SIGHUP, SIG_DFL);
}

/// A signal that the program was started to ignore, as by nohup or in the background of a script, stays ignored.
void take(int number, struct sigaction& before)
{
  sigaction(number, nullptr, &before);
  if (before.sa_handler != SIG_IGN)
    std::signal(number, note);
}

} // namespace

InterruptGuard::InterruptGuard()
{
  noted_signal = 0;
  take(SIGINT, interrupt_);
  take(SIGTERM, terminate_);
  take(SIGHUP, hang_up_);
}

InterruptGuard::~InterruptGuard()
{
  sigaction(SIGINT, &interrupt_, nullptr);
  sigaction(SIGTERM, &terminate_, nullptr);
  sigaction(SIGHUP, &hang_up_, nullptr);
}

int InterruptGuard::signal()
{
  return noted_signal;
}

} // namespace brinell::app
