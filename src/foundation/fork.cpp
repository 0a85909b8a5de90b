// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/foundation/fork.hpp"

#include "planner_lock.hpp"

#include <omp.h>

namespace brinell
{

namespace
{

/// Held from before a fork until after it; as the lock itself, of the whole process.
std::unique_lock<std::mutex>& held_lock()
{
  static std::unique_lock<std::mutex> lock;
  return lock;
}

} // namespace

void before_fork()
{
  omp_pause_resource_all(omp_pause_soft);
  if (!held_lock().owns_lock()) // a module that is imported again registers itself again
    held_lock() = planner_lock();
}

void after_fork()
{
  held_lock() = {};
}

} // namespace brinell
