// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mutex>

namespace brinell
{

/// Lock to be held while FFTW creates or destroys plans: several threads may transform concurrently, but only one may plan. The
/// planner state of FFTW is global to the process, and so is this lock.
[[nodiscard]] inline std::unique_lock<std::mutex> planner_lock()
{
  static std::mutex mutex;
  return std::unique_lock(mutex);
}

} // namespace brinell
