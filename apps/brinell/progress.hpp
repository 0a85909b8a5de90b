// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/simulation/tugging.hpp"

#include <chrono>

namespace brinell::app
{

/// Shows on stderr how far a run is: a bar on a terminal, one line per tenth of the steps elsewhere, nothing if quiet.
class Progress
{
public:
  Progress(double radius, bool quiet);
  ~Progress(); ///< leaves the terminal on a clean line
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void step(const simulation::StepRecord& record, int step_count);

private:
  using Clock = std::chrono::steady_clock;

  double m_radius; ///< of X/R [m]
  bool m_quiet, m_terminal;
  bool m_bar_is_shown = false;
  int m_tenths = 0;
  Clock::time_point m_start = Clock::now();
};

} // namespace brinell::app
