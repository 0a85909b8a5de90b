// SPDX-License-Identifier: BSD-3-Clause
#include "session.hpp"

#include "mpi_communicator.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <fcntl.h>
#include <string>
#include <thread>
#include <unistd.h>
#include <vector>

/// A program with MPI.
namespace brinell::app
{

namespace
{

/// Whether a starter such as mpirun or srun has started this process, by what they leave in the environment. Otherwise MPI need not
/// be started, which takes a while.
bool is_started_with_others()
{
  constexpr std::array names{"OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "PMI_RANK", "PMIX_RANK", "MPI_LOCALRANKID"};
  return std::any_of(names.begin(), names.end(), [](const char* name) { return std::getenv(name) != nullptr; });
}

/// Keeps back what this process prints.
/// @returns the descriptor of the real stderr
int kept_back()
{
  std::fflush(stdout);
  std::fflush(stderr);
  const int shown = dup(STDERR_FILENO);
  if (const int nothing = open("/dev/null", O_WRONLY | O_CLOEXEC); nothing >= 0)
  {
    dup2(nothing, STDOUT_FILENO);
    close(nothing);
  }
  if (std::FILE* kept = std::tmpfile(); kept != nullptr)
    dup2(fileno(kept), STDERR_FILENO); // the file ends with the process
  return shown;
}

/// Shows what has been kept back.
void show(int shown, int rank)
{
  std::fflush(stderr);
  std::string text = "brinell: of rank " + std::to_string(rank) + ":\n";
  lseek(STDERR_FILENO, 0, SEEK_SET);
  std::array<char, 4096> part;
  for (ssize_t count = 0; (count = read(STDERR_FILENO, part.data(), part.size())) > 0;)
    text.append(part.data(), static_cast<std::size_t>(count));
  static_cast<void>(!write(shown, text.data(), text.size()));
}

} // namespace

Session::Session()
{
  if (!is_started_with_others())
  {
    ranks_ = std::make_shared<const Communicator>();
    return;
  }
  int given = 0;
  MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &given);
  ranks_ = std::make_shared<const MpiCommunicator>(MPI_COMM_WORLD);
  if (ranks_->rank() > 0)
    shown_ = kept_back();
}

Session::~Session() = default;

int Session::end(int code)
{
  int is_initialized = 0;
  MPI_Initialized(&is_initialized);
  if (is_initialized == 0)
    return code;
  using Clock = std::chrono::steady_clock;
  constexpr std::chrono::seconds patience{5};
  std::vector<int> codes(static_cast<std::size_t>(ranks_->size()));
  MPI_Request request = MPI_REQUEST_NULL;
  MPI_Iallgather(&code, 1, MPI_INT, codes.data(), 1, MPI_INT, MPI_COMM_WORLD, &request);
  int all_have_ended = 0;
  for (const auto start = Clock::now(); all_have_ended == 0;)
  {
    MPI_Test(&request, &all_have_ended, MPI_STATUS_IGNORE);
    if (all_have_ended == 0 && code != 0 && Clock::now() - start > patience)
    {
      if (shown_ >= 0)
        show(shown_, ranks_->rank());
      MPI_Abort(MPI_COMM_WORLD, code);
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  if (shown_ >= 0 && code != 0 && codes.front() == 0)
    show(shown_, ranks_->rank());
  ranks_.reset();
  MPI_Finalize();
  return code;
}

} // namespace brinell::app
