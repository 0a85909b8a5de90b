// SPDX-License-Identifier: BSD-3-Clause
#include "interrupt.hpp"

namespace brinell::app
{

namespace
{

// Global, because a signal handler can access nothing else.
volatile std::sig_atomic_t received_signal = 0;

/// Signal handler: records the signal and restores the default actions, so that the next signal of any kind ends the process.
void record_signal(int number)
{
  received_signal = number;
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
  std::signal(SIGHUP, SIG_DFL);
}

/// Installs the handler. A signal that the program was started to ignore, as by nohup or in the background of a script, stays
/// ignored.
void handle(int number, struct sigaction& before)
{
  sigaction(number, nullptr, &before);
  if (before.sa_handler != SIG_IGN)
    std::signal(number, record_signal);
}

} // namespace

InterruptGuard::InterruptGuard()
{
  received_signal = 0;
  handle(SIGINT, interrupt_);
  handle(SIGTERM, terminate_);
  handle(SIGHUP, hang_up_);
}

InterruptGuard::~InterruptGuard()
{
  sigaction(SIGINT, &interrupt_, nullptr);
  sigaction(SIGTERM, &terminate_, nullptr);
  sigaction(SIGHUP, &hang_up_, nullptr);
}

int InterruptGuard::signal()
{
  return received_signal;
}

} // namespace brinell::app
