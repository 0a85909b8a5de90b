// SPDX-License-Identifier: BSD-3-Clause
#include "command_line.hpp"

#include <csignal>
#include <cstdlib>
#include <unistd.h>
#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace
{

/// How often a thread looks whether the others are done before it sleeps: for some 30 us, about as long as it takes to sleep and
/// be woken. Threads that never sleep make a run many times slower as soon as another program needs a core; threads that sleep
/// at once come too late for the next piece of work: docs/performance.md. The same number stands in python/brinell/__init__.py.
constexpr const char* looks_before_sleep = "1000";

/// OpenMP reads its environment before main: the program starts itself again. What a user has set stays.
void wait_a_moment_then_sleep(char** argv)
{
  constexpr const char* policy = "OMP_WAIT_POLICY";
  if (std::getenv(policy) == nullptr && setenv("GOMP_SPINCOUNT", looks_before_sleep, 0) == 0 &&
      setenv(policy, "passive", 0) == 0)
    execv("/proc/self/exe", argv); // comes back only if that is not possible: then as it is
}

/// What a step frees the next one asks for again. Given back to the system in between, it came as new pages, which one thread has to
/// clear: 5 to 9 % of a run (docs/performance.md). What a user has set stays.
void keep_freed_memory()
{
#ifdef __GLIBC__
  constexpr int largest_kept_block = 32 << 20; // that glibc itself may come to keep
  constexpr int most_kept = 1 << 30;
  if (std::getenv("MALLOC_TRIM_THRESHOLD_") == nullptr && std::getenv("MALLOC_MMAP_THRESHOLD_") == nullptr &&
      mallopt(M_MMAP_THRESHOLD, largest_kept_block) == 1)
    mallopt(M_TRIM_THRESHOLD, most_kept);
#endif
}

} // namespace

int main(int argc, char** argv)
{
  wait_a_moment_then_sleep(argv);
  keep_freed_memory();
  std::signal(SIGXFSZ, SIG_IGN); // a file beyond `ulimit -f` is told as one that cannot be written
  return brinell::app::command_line({argv + 1, argv + argc});
}
