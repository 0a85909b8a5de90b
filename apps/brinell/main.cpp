// SPDX-License-Identifier: BSD-3-Clause
#include "command_line.hpp"

#include <csignal>
#include <cstdlib>
#include <unistd.h>

namespace
{

/// Threads that wait for each other actively make a run several times slower as soon as another program needs a core, and
/// gain little on an idle machine. OpenMP reads its environment before main: the program starts itself again.
void wait_passively(char** argv)
{
  constexpr const char* policy = "OMP_WAIT_POLICY";
  if (std::getenv(policy) == nullptr && setenv(policy, "passive", 0) == 0)
    execv("/proc/self/exe", argv); // comes back only if that is not possible: then as it is
}

} // namespace

int main(int argc, char** argv)
{
  wait_passively(argv);
  std::signal(SIGXFSZ, SIG_IGN); // a file beyond `ulimit -f` is told as one that cannot be written
  return brinell::app::command_line({argv + 1, argv + argc});
}
