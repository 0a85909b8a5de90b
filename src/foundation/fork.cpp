// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/foundation/fork.hpp"

#include "fftw.hpp"

#include <omp.h>

namespace brinell
{

namespace
{

/// The planner lock while it is held from before a fork until after it; like the lock itself, there is one per process.
std::unique_lock<std::mutex>& held_lock()
{
  static std::unique_lock<std::mutex> lock;
  return lock;
}

} // namespace

void before_fork()
{
  omp_pause_resource_all(omp_pause_soft);
  if (!held_lock().owns_lock()) // a module that is imported twice registers these functions twice
    held_lock() = planner_lock();
}

void after_fork()
{
  held_lock() = {};
}

} // namespace brinell
