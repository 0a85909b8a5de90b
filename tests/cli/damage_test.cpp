// SPDX-License-Identifier: BSD-3-Clause
#include "program.hpp"

#include <algorithm>
#include <chrono>
#include <random>
#include <thread>

/// What a run must survive without a wrong number: signals, limits, folders of others, a disk that fails.
namespace brinell::cli::damage_test
{

namespace
{

constexpr const char* yielding_case = R"(scenario = "indentation"
[indentation]
load = ["20 N", 0]
steps = 20
[lower]
shape = {type = "flat"}
material = {young_modulus = "200 GPa", poisson_ratio = 0.3, hardening = {law = "linear", yield_stress = "1 GPa", modulus = "20 GPa"}}
[upper]
shape = {type = "sphere", radius = "1 mm"}
material = {young_modulus = "200 GPa", poisson_ratio = 0.3}
[grid]
resolution = 3
[output]
snapshots = "every 2"
checkpoint_interval = 0
)";

class Damage : public Program
{
protected:
  void SetUp() override
  {
    Program::SetUp();
    write("case.toml", yielding_case);
  }

  [[nodiscard]] int rows(const fs::path& history) const
  {
    const std::string text = file_text(folder() / history);
    return static_cast<int>(std::count(text.begin(), text.end(), '\n')) - 1;
  }

  /// Runs until there are some rows, then sends the signal.
  [[nodiscard]] int stopped_by(int signal) const
  {
    Process process = start({"run", "case.toml", "-q", "-o", "stopped", "--set", "output.checkpoint_interval=1000"});
    while (process.running() && rows("stopped/history.csv") < 5)
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    process.signal(signal);
    return process.wait().exit_code;
  }
};

// A terminal that is gone, as of a lost ssh.
TEST_F(Damage, HangUpLeavesACheckpoint)
{
  EXPECT_EQ(stopped_by(SIGHUP), 128 + SIGHUP);
  EXPECT_TRUE(fs::exists(folder() / "stopped" / "checkpoint.h5"));
}

TEST_F(Damage, LimitOfFileSizeIsTold)
{
  constexpr rlim_t limit = 20000;
  Process process(folder(), {"run", "case.toml", "-q", "-o", "out"}, limit, SIG_DFL);
  const Outcome outcome = process.wait();
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_NE(outcome.err.find("cannot be written"), std::string::npos) << outcome.err;
}

TEST_F(Damage, FilesOfOthersStay)
{
  write("mine/summary.json", "{}");
  write("mine/snapshots/2024.txt", "mine");
  for (const std::vector<std::string>& more :
       {std::vector<std::string>{"-o", "mine"}, {"--set", "output.directory=mine"}, {"-o", "mine", "--resume"}})
  {
    std::vector<std::string> arguments{"run", "case.toml", "-q"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.exit_code, 2) << outcome.err;
    EXPECT_EQ(file_text(folder() / "mine" / "summary.json"), "{}");
    EXPECT_EQ(file_text(folder() / "mine" / "snapshots" / "2024.txt"), "mine");
    EXPECT_FALSE(fs::exists(folder() / "mine" / "history.csv"));
  }
}

// The seeds are fixed; the fields of the state are most of the file.
TEST_F(Damage, DamagedCheckpointIsNeverComputedWith)
{
  Process process = start({"run", "case.toml", "-q", "-o", "stopped"});
  while (process.running() && rows("stopped/history.csv") < 8)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  process.signal(SIGKILL);
  ASSERT_EQ(process.wait().exit_code, 128 + SIGKILL);
  const std::string whole = file_text(folder() / "stopped" / "checkpoint.h5");
  ASSERT_FALSE(whole.empty());
  std::mt19937 random(1);
  for (int i = 0; i < 10; ++i)
  {
    std::string damaged = whole;
    const std::size_t place = random() % whole.size();
    if (i % 3 == 2) // a page that was never written
      damaged.replace(place, std::min<std::size_t>(512, whole.size() - place),
                      std::min<std::size_t>(512, whole.size() - place), '\0');
    else
      damaged[place] = static_cast<char>(damaged[place] ^ (1 << (random() % 8)));
    if (damaged == whole)
      continue;
    std::ofstream(folder() / "stopped" / "checkpoint.h5", std::ios::binary) << damaged;
    const Outcome outcome = run({"run", "case.toml", "-q", "-o", "stopped", "--resume"});
    EXPECT_EQ(outcome.exit_code, 1) << place;
    EXPECT_NE(outcome.err.find("checkpoint.h5: is damaged"), std::string::npos) << outcome.err;
  }
  std::ofstream(folder() / "stopped" / "checkpoint.h5", std::ios::binary) << whole;
  EXPECT_EQ(run({"run", "case.toml", "-q", "-o", "stopped", "--resume"}).exit_code, 0);
}

} // namespace

} // namespace brinell::cli::damage_test
