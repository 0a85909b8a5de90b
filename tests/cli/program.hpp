// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <csignal>
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
};

/// A started program; stdout and stderr go to files.
class Process
{
public:
  /// @param largest_file  [bytes], as if the disk were full then; 0: no limit
  /// @param beyond        what the program finds to be done by a signal when a file grows beyond that
  Process(const fs::path& folder, const std::vector<std::string>& arguments, rlim_t largest_file = 0,
          void (*beyond)(int) = SIG_IGN)
      : m_out(folder / "stdout"), m_err(folder / "stderr")
  {
    m_pid = fork();
    if (m_pid != 0)
      return;
    if (!freopen(m_out.c_str(), "w", stdout) || !freopen(m_err.c_str(), "w", stderr) || chdir(folder.c_str()) != 0)
      _exit(127);
    if (largest_file > 0)
    {
      const rlimit limit{largest_file, largest_file};
      std::signal(SIGXFSZ, beyond); // if ignored, writing fails, and the process goes on
      setrlimit(RLIMIT_FSIZE, &limit);
    }
    std::vector<char*> argv{const_cast<char*>(BRINELL_PROGRAM)};
    for (const auto& argument : arguments)
      argv.push_back(const_cast<char*>(argument.c_str()));
    argv.push_back(nullptr);
    execv(BRINELL_PROGRAM, argv.data());
    _exit(127);
  }

  void signal(int number) const { kill(m_pid, number); }

  [[nodiscard]] bool running()
  {
    if (!m_ended)
      m_ended = waitpid(m_pid, &m_status, WNOHANG) == m_pid;
    return !m_ended;
  }

  [[nodiscard]] Outcome wait()
  {
    if (!m_ended)
      waitpid(m_pid, &m_status, 0);
    m_ended = true;
    const int code = WIFEXITED(m_status) ? WEXITSTATUS(m_status) : 128 + WTERMSIG(m_status);
    return {code, file_text(m_out), file_text(m_err)};
  }

private:
  fs::path m_out, m_err;
  pid_t m_pid = -1;
  int m_status = 0;
  bool m_ended = false;
};

/// Each test works in a new folder, which goes with it.
class Program : public testing::Test
{
protected:
  void SetUp() override
  {
    m_folder = fs::temp_directory_path() / (std::string("brinell-cli-") + std::to_string(getpid()));
    fs::remove_all(m_folder);
    fs::create_directories(m_folder);
  }
  void TearDown() override
  {
    std::error_code ignored;
    fs::remove_all(m_folder, ignored);
  }

  [[nodiscard]] const fs::path& folder() const { return m_folder; }
  [[nodiscard]] Process start(const std::vector<std::string>& arguments) const { return {m_folder, arguments}; }
  [[nodiscard]] Outcome run(const std::vector<std::string>& arguments) const { return start(arguments).wait(); }

  void write(const fs::path& name, const std::string& text) const
  {
    fs::create_directories((m_folder / name).parent_path());
    std::ofstream(m_folder / name) << text;
  }

private:
  fs::path m_folder;
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
