// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mutex>

namespace brinell
{

/// To be held while FFTW makes or destroys plans: several threads may transform at once, but only one may plan. FFTW keeps what it knows for the whole
/// process, so this lock cannot belong to anybody.
[[nodiscard]] inline std::unique_lock<std::mutex> planner_lock()
{
  static std::mutex mutex;
  return std::unique_lock(mutex);
}

} // namespace brinell
