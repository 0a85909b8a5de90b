// SPDX-License-Identifier: BSD-3-Clause
#include "shared_runs.hpp"
#include "sweep.hpp"

#include <array>
#include <chrono>
#include <random>
#include <thread>

/// What may happen to several processes: they are killed, stopped, or cannot read or write. It is told once, no rank waits for ever, no
/// folder looks complete that is not, and other ranks go on to the result of one process that nothing has happened to.
namespace brinell::mpi_test
{
namespace
{

using namespace std::chrono_literals;

constexpr const char* steel =
    R"toml({young_modulus = "200 GPa", poisson_ratio = 0.3, hardening = {law = "linear", yield_stress = "1 GPa", modulus = "20 GPa", back_stresses = [{modulus = "20 GPa"}]}, thermal = {conductivity = "50 W/(m K)", density = 7800, specific_heat = 470, expansion = 12e-6}})toml";

/// Cases of some twenty steps: one whose grids grow, one with friction and heat in both bodies, and one with stick and slip. Then one
/// of many steps, which does not end before a signal has come.
constexpr std::size_t cases_of_few_steps = 3, long_case = 3;
std::string case_text(std::size_t number)
{
  const std::string flat = R"({type = "flat"})", ball = R"({type = "sphere", radius = "1 mm"})";
  static const std::array<std::string, 4> scenarios{
      "scenario = \"indentation\"\n[indentation]\nload = [\"60 N\", 0]\nsteps = 12\n[grid]\nresolution = 4\nextent = "
      "0.5\n",
      "scenario = \"tugging\"\n[tugging]\ninterference = 6\nspeed = \"1 m/s\"\n[interface]\nfriction = "
      "0.3\n[grid]\nresolution = 3\n",
      "scenario = \"rolling\"\n[rolling]\nload = \"20 N\"\ndistance = \"0.3 mm\"\nload_steps = 3\ncreepage = [0.004, "
      "0.001]\nspeed = \"5 m/s\"\n"
      "[interface]\nfriction = 0.3\n[grid]\nresolution = 3\n",
      "scenario = \"indentation\"\n[indentation]\nload = [\"60 N\", 0]\nsteps = 600\n[grid]\nresolution = 4\n"};
  return scenarios[number] + "[lower]\nshape = " + (number == 1 ? ball : flat) + "\nmaterial = " + steel +
         "\n[upper]\nshape = " + ball + "\nmaterial = " + steel +
         "\n[output]\nsnapshots = \"every 8\"\ncheckpoint_interval = 0\n";
}

/// Processes that a process has started and that have not ended.
std::vector<pid_t> children(pid_t parent)
{
  std::vector<pid_t> found;
  std::error_code ended;
  for (const auto& thread : fs::directory_iterator("/proc/" + std::to_string(parent) + "/task", ended))
  {
    std::ifstream list(thread.path() / "children");
    found.insert(found.end(), std::istream_iterator<pid_t>(list), {});
  }
  return found;
}

class Faults : public SharedRuns
{
protected:
  /// The results of a case by one process, in a folder of that number.
  [[nodiscard]] std::string reference(std::size_t number) const
  {
    const std::string name = "whole-" + std::to_string(number);
    write("case-" + std::to_string(number) + ".toml", case_text(number));
    if (!fs::exists(folder() / name))
    {
      const Outcome outcome = run(0, arguments(number, name));
      EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    }
    return name;
  }
  [[nodiscard]] static std::vector<std::string> arguments(std::size_t number, const std::string& output)
  {
    return {"run", "-q", "case-" + std::to_string(number) + ".toml", "-o", output};
  }

  [[nodiscard]] bool is_complete(const std::string& output) const
  {
    return fs::exists(folder() / output / "summary.json");
  }
  /// What goes on in a folder, or begins there if nothing has been stored.
  [[nodiscard]] std::vector<std::string> going_on(std::size_t number, const std::string& output) const
  {
    std::vector<std::string> words = arguments(number, output);
    if (fs::exists(folder() / output / "checkpoint.h5"))
      words.emplace_back("--resume");
    return words;
  }
  /// Ends what was stopped, and compares.
  void expect_going_on(int ranks, std::size_t number, const std::string& output) const
  {
    const Outcome outcome = run(ranks, going_on(number, output));
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    expect_same_results(output, reference(number));
    EXPECT_FALSE(fs::exists(folder() / output / "checkpoint.h5"));
  }
  void wait_for_rows(Process& process, const std::string& output, int count) const
  {
    while (process.running() && rows(output) < count)
      std::this_thread::sleep_for(1ms);
  }
};

/// Whether a process computes no more: it is gone, or its parent has yet to ask for its exit code.
bool has_ended(pid_t process)
{
  std::ifstream file("/proc/" + std::to_string(process) + "/stat");
  std::string text;
  std::getline(file, text);
  const auto name_ends = text.rfind(") ");
  return name_ends == std::string::npos || text[name_ends + 2] == 'Z';
}

/// Waits for mpirun. That of Open MPI 4.1 sometimes never ends once a rank has been killed while MPI began (docs/howto/ranks.md): if all
/// ranks have long ended, it is killed, too.
/// @param hung  counts those
Outcome waited_for(Process& mpirun, const std::vector<pid_t>& ranks, int& hung)
{
  using clock = std::chrono::steady_clock;
  for (auto last = clock::now(); mpirun.running(); std::this_thread::sleep_for(1ms))
    if (!std::ranges::all_of(ranks, has_ended))
      last = clock::now();
    else if (clock::now() - last > 20s)
    {
      ++hung;
      mpirun.signal(SIGKILL);
      break;
    }
  return mpirun.wait();
}

/// Kills a rank at a time of which nothing is known, unless all has ended before.
/// @param hung  counts what waited_for counts
/// @returns what became of mpirun
Outcome killed(Process& process, std::mt19937_64& random, std::chrono::milliseconds latest, int& hung)
{
  std::this_thread::sleep_for(std::chrono::milliseconds(random() % static_cast<unsigned long>(latest.count())));
  std::vector<pid_t> ranks;
  while (ranks.empty() && process.running())
    ranks = children(process.id());
  if (!ranks.empty())
    kill(ranks[random() % ranks.size()], SIGKILL);
  Outcome outcome = waited_for(process, ranks, hung);
  // The others do not compute on: they have ended with it, or do so at once.
  for (const pid_t rank : ranks)
    for (int waited = 0; !has_ended(rank) && waited < 5000; ++waited)
    {
      EXPECT_LT(waited, 4999) << "rank " << rank << " has not ended";
      std::this_thread::sleep_for(1ms);
    }
  return outcome;
}

TEST_F(Faults, KilledAtAnyTimeOthersGoOn)
{
  constexpr int count = 100;
  const test::Sweep kills(count);
  std::array<std::chrono::milliseconds, cases_of_few_steps> duration{};
  int done = 0, completed = 0, begun = 0, resumed = 0, hung = 0;
  for (int number = 0; number < count; ++number)
  {
    if (!kills.has(number) || (!kills.is_whole() && number / test::Sweep::parts % 3 != 0))
      continue; // of a day's part a third, since each takes several starts of mpirun
    ++done;
    SCOPED_TRACE(number);
    std::mt19937_64 random(static_cast<unsigned>(number));
    const std::size_t which = random() % duration.size();
    const std::string expected = reference(which), output = "killed-" + std::to_string(number);
    if (duration[which] == 0ms)
    {
      const auto start = std::chrono::steady_clock::now();
      EXPECT_EQ(run(2, arguments(which, "timed")).exit_code, 0);
      duration[which] = std::chrono::duration_cast<std::chrono::milliseconds>(std::chrono::steady_clock::now() - start);
    }
    for (int more = 1 + static_cast<int>(random() % 2); more > 0 && !is_complete(output); --more)
    {
      const std::vector<std::string> words = going_on(which, output);
      resumed += words.back() == "--resume" ? 1 : 0;
      Process process = start(2 + static_cast<int>(random() % 3), words);
      const bool computes = number % 2 == 1; // most of the others die while MPI begins, which takes most of the time
      if (computes)
        wait_for_rows(process, output, 1);
      const Outcome outcome = killed(process, random, computes ? 20ms : duration[which], hung);
      if (outcome.exit_code == 0)
      {
        EXPECT_TRUE(is_complete(output));
      }
    }
    begun += fs::exists(folder() / output) ? 1 : 0;
    if (is_complete(output))
    {
      ++completed;
      expect_same_results(output, expected);
    }
    else
      expect_going_on(static_cast<int>(random() % 5), which, output); // 0: the program without MPI
    fs::remove_all(folder() / output);
  }
  std::printf(
      "%d times killed: %d had begun to write, %d were complete, %d began with a resume; mpirun hung %d times\n", done,
      begun, completed, resumed, hung);
  EXPECT_LE(hung, 1 + done / 25) << "of mpirun, whose ranks had ended";
  EXPECT_GT(begun, completed) << "no kill came while ranks computed";
}

// The ranks alone, and once MPI has started, which has files of its own.
TEST_F(Faults, FullDiskIsToldOnce)
{
  static_cast<void>(reference(1));
  int failed = 0;
  for (const rlim_t largest : {0, 200000}) // no file grows; large ones do not
  {
    SCOPED_TRACE(largest);
    const std::string output = "full-" + std::to_string(largest);
    Process process = start(2, arguments(1, output));
    wait_for_rows(process, output, 2);
    const rlimit limit{largest, largest};
    for (const pid_t rank : children(process.id()))
      prlimit(rank, RLIMIT_FSIZE, &limit, nullptr);
    const Outcome outcome = process.wait();
    EXPECT_TRUE(outcome.exit_code == 1 || (outcome.exit_code == 0 && is_complete(output))) << outcome.exit_code;
    if (outcome.exit_code == 0) // has written all before
      continue;
    ++failed;
    EXPECT_FALSE(is_complete(output));
    EXPECT_EQ(times(outcome.err, "brinell: the finished steps are in " + output), 1) << outcome.err;
    EXPECT_NE(outcome.err.find(output + "/"), std::string::npos) << outcome.err; // names the file
    expect_going_on(3, 1, output);
  }
  EXPECT_GE(failed, 1);
}

TEST_F(Faults, StoppedTogetherOthersGoOn)
{
  // Between SIGTERM and SIGKILL, as in docs/howto/ranks.md; Open MPI waits for all of it.
  setenv("OMPI_MCA_odls_base_sigkill_timeout", "5", 1);
  static_cast<void>(reference(long_case));
  Process process = start(2, arguments(long_case, "stopped"));
  wait_for_rows(process, "stopped", 3);
  process.signal(SIGTERM);
  const Outcome outcome = process.wait();
  EXPECT_NE(outcome.exit_code, 0);
  EXPECT_EQ(times(outcome.err, "brinell: interrupted"), 1) << outcome.err;
  EXPECT_FALSE(is_complete("stopped"));
  EXPECT_TRUE(fs::exists(folder() / "stopped" / "checkpoint.h5"));
  expect_going_on(3, long_case, "stopped");
  unsetenv("OMPI_MCA_odls_base_sigkill_timeout");
}

// As of a batch system that warns one process, or each a moment after the other.
TEST_F(Faults, StoppedByOneRankAllStop)
{
  static_cast<void>(reference(long_case));
  Process process = start(2, arguments(long_case, "one"));
  wait_for_rows(process, "one", 3);
  const std::vector<pid_t> ranks = children(process.id());
  ASSERT_EQ(ranks.size(), 2U);
  kill(ranks[1], SIGTERM); // does not write
  const Outcome outcome = process.wait();
  EXPECT_EQ(outcome.exit_code, 128 + SIGTERM);
  EXPECT_EQ(times(outcome.err, "brinell: interrupted"), 1) << outcome.err;
  EXPECT_FALSE(is_complete("one"));
  expect_going_on(0, long_case, "one");
}

TEST_F(Faults, BadInputIsToldOnce)
{
  write("case-0.toml", case_text(0));
  write("unknown.toml", case_text(0) + "[nonsense]\n");
  write("file", "");
  for (const auto& [words, what] : std::vector<std::pair<std::vector<std::string>, std::string>>{
           {{"run", "-q", "unknown.toml", "-o", "out"}, "nonsense"},
           {{"run", "-q", "missing.toml", "-o", "out"}, "missing.toml"},
           {{"run", "-q", "case-0.toml", "-o", "out", "--resume"}, "there is no stopped run"},
           {{"run", "-q", "case-0.toml", "-o", "file/out"}, "file/out"},
           {{"run", "-q", BRINELL_SOURCE_DIR "/cases/rolling-fatigue/case.toml", "-o", "out"},
            "is not available where 3 processes"},
           {{"run", "-q", BRINELL_SOURCE_DIR "/cases/rolling-inclusion/case.toml", "-o", "out"},
            "lower.inclusion is not available where 3 processes"}})
  {
    SCOPED_TRACE(what);
    const Outcome outcome = run(3, words);
    EXPECT_EQ(outcome.exit_code, what == "file/out" ? 1 : 2);
    EXPECT_EQ(times(outcome.err, "brinell: error: "), 1) << outcome.err;
    EXPECT_EQ(times(outcome.err, what), 1) << outcome.err;
    fs::remove_all(folder() / "out");
  }
}

/// Two ranks of one mpirun with a case each, as where machines have files of their own.
TEST_F(Faults, RanksWithoutTheSameCase)
{
  write("case-0.toml", case_text(0));
  write("other.toml", case_text(0) + "# the same\n");
  const auto together = [&](const std::string& second, const std::vector<std::string>& more)
  {
    std::vector<std::string> words{"-n", "1", BRINELL_PROGRAM "-mpi", "run", "-q", "case-0.toml", "-o", "out", ":",
                                   "-n", "1", BRINELL_PROGRAM "-mpi", "run", "-q", second,        "-o", "out"};
    words.insert(words.end(), more.begin(), more.end());
    return Process(folder(), words, 0, SIG_IGN, {}, {"mpirun"}).wait();
  };
  EXPECT_EQ(together("other.toml", {}).exit_code, 0);
  fs::remove_all(folder() / "out");
  const Outcome differs = together("other.toml", {"--set", "grid.resolution=5"});
  EXPECT_EQ(differs.exit_code, 2);
  EXPECT_EQ(times(differs.err, "process 1 has another case than the first"), 1) << differs.err;
  EXPECT_FALSE(fs::exists(folder() / "out"));
  const Outcome missing = together("missing.toml", {});
  EXPECT_EQ(missing.exit_code, 2);
  EXPECT_EQ(times(missing.err, "of rank 1:"), 1) << missing.err;
  EXPECT_EQ(times(missing.err, "missing.toml"), 1) << missing.err;
  EXPECT_FALSE(is_complete("out"));
}

} // namespace
} // namespace brinell::mpi_test
