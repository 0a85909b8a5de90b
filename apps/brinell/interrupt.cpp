// SPDX-License-Identifier: BSD-3-Clause
#include "interrupt.hpp"

namespace brinell::app
{

namespace
{

// The one global of the program: a signal handler can reach nothing else.
volatile std::sig_atomic_t noted_signal = 0;

void note(int number)
{
  noted_signal = number;
  std::signal(number, SIG_DFL);
}

} // namespace

InterruptGuard::InterruptGuard()
{
  noted_signal = 0;
  m_interrupt = std::signal(SIGINT, note);
  m_terminate = std::signal(SIGTERM, note);
}

InterruptGuard::~InterruptGuard()
{
  std::signal(SIGINT, m_interrupt);
  std::signal(SIGTERM, m_terminate);
}

int InterruptGuard::signal()
{
  return noted_signal;
}

} // namespace brinell::app
