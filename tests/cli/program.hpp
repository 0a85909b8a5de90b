// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <string>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

/// Runs the built program as a user would, in a folder of its own.
namespace brinell::cli
{

namespace fs = std::filesystem;

inline std::string file_text(const fs::path& path)
{
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

struct Outcome
{
  int exit_code = -1; ///< 128 + signal if a signal ended it
  std::string out, err;
  double memory = 0.0; ///< largest resident set [bytes]
};

/// Of a program's environment.
struct Variable
{
  const char* name;
  const char* value; ///< nullptr: not there
};

/// A started program; stdout and stderr go to files.
class Process
{
public:
  /// @param largest_file  [bytes], as if the disk were full then; 0: no limit
  /// @param beyond        what the program finds to be done by a signal when a file grows beyond that
  /// @param changes       of the environment, beside that of the test, which stays as it is
  /// @param program       with the words before the arguments, such as mpirun and its own
  Process(const fs::path& folder, const std::vector<std::string>& arguments, rlim_t largest_file = 0,
          void (*beyond)(int) = SIG_IGN, const std::vector<Variable>& changes = {},
          const std::vector<std::string>& program = {BRINELL_PROGRAM})
      : out_(folder / "stdout"), err_(folder / "stderr")
  {
    std::fflush(nullptr); // so that what is printed here is not printed by both
    pid_ = fork();
    if (pid_ != 0)
      return;
    if (!freopen(out_.c_str(), "w", stdout) || !freopen(err_.c_str(), "w", stderr) || chdir(folder.c_str()) != 0)
      _exit(127);
    for (const auto& [name, value] : changes)
      if (value == nullptr ? unsetenv(name) : setenv(name, value, 1))
        _exit(127);
    if (largest_file > 0)
    {
      const rlimit limit{largest_file, largest_file};
      std::signal(SIGXFSZ, beyond); // if ignored, writing fails, and the process goes on
      setrlimit(RLIMIT_FSIZE, &limit);
    }
    std::vector<char*> argv;
    for (const auto* words : {&program, &arguments})
      for (const std::string& word : *words)
        argv.push_back(const_cast<char*>(word.c_str()));
    argv.push_back(nullptr);
    execvp(argv.front(), argv.data());
    _exit(127);
  }

  void signal(int number) const { kill(pid_, number); }
  [[nodiscard]] pid_t id() const { return pid_; }

  [[nodiscard]] bool running()
  {
    if (!ended_)
      ended_ = waitpid(pid_, &status_, WNOHANG) == pid_;
    return !ended_;
  }

  [[nodiscard]] Outcome wait()
  {
    rusage used{};
    if (!ended_)
      wait4(pid_, &status_, 0, &used);
    ended_ = true;
    const int code = WIFEXITED(status_) ? WEXITSTATUS(status_) : 128 + WTERMSIG(status_);
    return {code, file_text(out_), file_text(err_), 1024.0 * static_cast<double>(used.ru_maxrss)};
  }

private:
  fs::path out_, err_;
  pid_t pid_ = -1;
  int status_ = 0;
  bool ended_ = false;
};

/// Each test works in a new folder, which goes with it.
class Program : public testing::Test
{
protected:
  void SetUp() override
  {
    folder_ = fs::temp_directory_path() / (std::string("brinell-cli-") + std::to_string(getpid()));
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override
  {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
  }

  [[nodiscard]] const fs::path& folder() const { return folder_; }
  [[nodiscard]] Process start(const std::vector<std::string>& arguments) const { return {folder_, arguments}; }
  [[nodiscard]] Outcome run(const std::vector<std::string>& arguments) const { return start(arguments).wait(); }
  /// In another environment than that of the tests.
  [[nodiscard]] Outcome run(const std::vector<std::string>& arguments, const std::vector<Variable>& changes) const
  {
    return Process(folder_, arguments, 0, SIG_IGN, changes).wait();
  }

  void write(const fs::path& name, const std::string& text) const
  {
    fs::create_directories((folder_ / name).parent_path());
    std::ofstream(folder_ / name) << text;
  }

private:
  fs::path folder_;
};

/// Elastic bodies and large cells: done in a moment.
inline constexpr const char* quick_case = R"(scenario = "tugging"
[lower]
shape = {type = "sphere", radius = "1 m"}
material = {young_modulus = "200 GPa", poisson_ratio = 0.3}
[upper]
shape = {type = "sphere", radius = "1 m"}
material = {young_modulus = "200 GPa", poisson_ratio = 0.3}
[tugging]
normalised = false
interference = "1 mm"
[grid]
resolution = 4
)";

} // namespace brinell::cli
