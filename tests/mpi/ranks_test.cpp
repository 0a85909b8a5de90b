// SPDX-License-Identifier: BSD-3-Clause
#include "io/results/hdf5.hpp"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <string>
#include <sys/wait.h>
#include <unistd.h>

/// Cases that mpirun computes with several processes, and one process computes alone.
namespace brinell::mpi_test
{
namespace
{

namespace fs = std::filesystem;

std::string file_text(const fs::path& path)
{
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

class Ranks : public testing::TestWithParam<const char*>
{
protected:
  void SetUp() override
  {
    folder_ = fs::temp_directory_path() / ("brinell-mpi-" + std::to_string(getpid()));
    fs::create_directories(folder_);
    setenv("OMPI_ALLOW_RUN_AS_ROOT", "1", 1);
    setenv("OMPI_ALLOW_RUN_AS_ROOT_CONFIRM", "1", 1);
  }
  void TearDown() override { fs::remove_all(folder_); }

  /// Runs a case of cases/.
  /// @param ranks  0: without mpirun
  /// @returns the exit code
  [[nodiscard]] int run(int ranks, const std::string& name, const std::string& output) const
  {
    const std::string start =
        ranks > 0 ? "mpirun --oversubscribe -n " + std::to_string(ranks) + " " BRINELL_PROGRAM : BRINELL_PROGRAM;
    const std::string command = "cd '" + folder_.string() + "' && " + start + " run -q '" BRINELL_SOURCE_DIR "/cases/" +
                                name + "/case.toml' -o " + output + " >" + output + ".out 2>" + output + ".err";
    return WEXITSTATUS(std::system(command.c_str()));
  }
  [[nodiscard]] const fs::path& folder() const { return folder_; }

private:
  fs::path folder_;
};

TEST_P(Ranks, HaveTheDigitsOfOneProcess)
{
  ASSERT_EQ(run(0, GetParam(), "alone"), 0);
  const io::h5::Handle alone = io::h5::open_file(folder() / "alone" / "result.vtkhdf");
  for (const int ranks : {2, 3})
  {
    const std::string output = "ranks-" + std::to_string(ranks);
    ASSERT_EQ(run(ranks, GetParam(), output), 0) << file_text(folder() / (output + ".err"));
    EXPECT_EQ(file_text(folder() / output / "history.csv"), file_text(folder() / "alone" / "history.csv"));
    const io::h5::Handle shared = io::h5::open_file(folder() / output / "result.vtkhdf");
    for (const char* group : {"steps", "final"})
      EXPECT_NO_THROW(
          io::h5::require_same_datasets(io::h5::open_group(alone, group), io::h5::open_group(shared, group)));
  }
}

INSTANTIATE_TEST_SUITE_P(Cases, Ranks, testing::Values("indentation", "tugging-heat", "rolling-friction"));

TEST_F(Ranks, RefuseWhatTheyCannotShare)
{
  EXPECT_EQ(run(2, "rolling-fatigue", "refused"), 2);
  const std::string text = file_text(folder() / "refused.err");
  const auto at = text.find("is not available where 2 processes");
  ASSERT_NE(at, std::string::npos) << text;
  EXPECT_EQ(text.find("is not available", at + 1), std::string::npos) << "told by one rank only";
  EXPECT_FALSE(fs::exists(folder() / "refused"));
}

} // namespace
} // namespace brinell::mpi_test
