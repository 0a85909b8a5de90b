// SPDX-License-Identifier: BSD-3-Clause
#include "command_line.hpp"
#include "session.hpp"

#include <csignal>
#include <cstdlib>
#include <unistd.h>
#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace
{

/// Number of checks (spins) of a waiting thread before it sleeps: about 30 us, as long as it takes to sleep and wake up. Threads
/// that never sleep make a run many times slower as soon as another program needs a core; threads that sleep at once wake up too
/// late for the next piece of work: bench/notebook/2026-11-24-threads.md. The same number is used in python/brinell/__init__.py.
constexpr const char* spins_before_sleep = "1000";

/// Sets how OpenMP threads wait. OpenMP reads its environment before main, so that the program restarts itself. Settings of the
/// user stay.
void set_thread_waiting(char** argv)
{
  constexpr const char* policy = "OMP_WAIT_POLICY";
  if (std::getenv(policy) == nullptr && setenv("GOMP_SPINCOUNT", spins_before_sleep, 0) == 0 &&
      setenv(policy, "passive", 0) == 0)
    execv("/proc/self/exe", argv); // returns only on failure; the program then continues with the default
}

/// Makes the allocator keep freed memory, because each step allocates again what the previous one freed. If the memory went back
/// to the system, new pages would have to be cleared by one thread: 5 to 9 % of a run
/// (bench/notebook/2026-11-24-outside-the-evaluations.md). Settings of the user stay.
void keep_freed_memory()
{
#ifdef __GLIBC__
  constexpr int largest_kept_block = 32 << 20; // the largest threshold to which glibc itself adapts
  constexpr int most_kept = 1 << 30;
  if (std::getenv("MALLOC_TRIM_THRESHOLD_") == nullptr && std::getenv("MALLOC_MMAP_THRESHOLD_") == nullptr &&
      mallopt(M_MMAP_THRESHOLD, largest_kept_block) == 1)
    mallopt(M_TRIM_THRESHOLD, most_kept);
#endif
}

} // namespace

int main(int argc, char** argv)
{
  set_thread_waiting(argv);
  keep_freed_memory();
  std::signal(SIGXFSZ, SIG_IGN); // a file larger than `ulimit -f` is then reported as an error of writing
  brinell::app::Session session;
  return session.end(brinell::app::command_line({argv + 1, argv + argc}, session.ranks()));
}
