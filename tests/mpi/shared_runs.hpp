// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../cli/program.hpp"
#include "io/results/hdf5.hpp"

#include <algorithm>
#include <string>
#include <vector>

/// Runs that mpirun starts, in a folder of their own.
namespace brinell::mpi_test
{

namespace fs = std::filesystem;
using cli::file_text;
using cli::Outcome;
using cli::Process;

/// Command of some ranks; 0: of the program without MPI, alone.
inline std::vector<std::string> command(int ranks)
{
  if (ranks == 0)
    return {BRINELL_PROGRAM};
  return {"mpirun", "-n", std::to_string(ranks), BRINELL_PROGRAM "-mpi"};
}

class SharedRuns : public cli::Program
{
protected:
  void SetUp() override
  {
    Program::SetUp();
    // As environment, so that an mpirun of another kind passes over it. More ranks than cores, which wait without taking a core
    // from those that compute, and may be anywhere, as others run as well.
    for (const char* name : {"OMPI_ALLOW_RUN_AS_ROOT", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM",
                             "OMPI_MCA_rmaps_base_oversubscribe", "OMPI_MCA_mpi_yield_when_idle"})
      setenv(name, "1", 1);
    setenv("OMPI_MCA_hwloc_base_binding_policy", "none", 1);
    setenv("PMIX_MCA_gds", "hash", 1); // docs/howto/ranks.md: otherwise mpirun may wait for a lock of a killed rank
  }

  [[nodiscard]] Process start(int ranks, const std::vector<std::string>& arguments, rlim_t largest_file = 0) const
  {
    return {folder(), arguments, largest_file, SIG_IGN, {}, command(ranks)};
  }
  [[nodiscard]] Outcome run(int ranks, const std::vector<std::string>& arguments) const
  {
    return start(ranks, arguments).wait();
  }

  /// Rows of the history in a folder of results.
  [[nodiscard]] int rows(const std::string& directory) const
  {
    const std::string text = file_text(folder() / directory / "history.csv");
    return static_cast<int>(std::count(text.begin(), text.end(), '\n')) - 1;
  }

  /// Expects history and datasets of two folders to be the same.
  void expect_same_results(const std::string& found, const std::string& expected) const
  {
    EXPECT_EQ(file_text(folder() / found / "history.csv"), file_text(folder() / expected / "history.csv"));
    ASSERT_TRUE(fs::exists(folder() / found / "summary.json"));
    const auto of = [&](const std::string& directory)
    { return io::h5::open_file(folder() / directory / "result.vtkhdf"); };
    const io::h5::Handle one = of(found), other = of(expected);
    for (const char* group : {"steps", "final"})
      EXPECT_NO_THROW(io::h5::require_same_datasets(io::h5::open_group(one, group), io::h5::open_group(other, group)));
  }
};

/// Number of times that a text has a part.
inline int times(const std::string& text, const std::string& part)
{
  int count = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
    ++count;
  return count;
}

} // namespace brinell::mpi_test
