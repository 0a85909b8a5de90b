// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "foundation/aligned.hpp"

#include <fftw3.h>
#include <mutex>

namespace brinell
{

/// The same numbers, as FFTW names their type.
[[nodiscard]] inline fftw_complex* as_fftw(Complex* c)
{
  return reinterpret_cast<fftw_complex*>(c);
}

/// Lock to be held while FFTW creates or destroys plans: several threads may transform concurrently, but only one may plan. The
/// planner state of FFTW is global to the process, and so is this lock.
[[nodiscard]] inline std::unique_lock<std::mutex> planner_lock()
{
  static std::mutex mutex;
  return std::unique_lock(mutex);
}

} // namespace brinell
