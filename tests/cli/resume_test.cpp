// SPDX-License-Identifier: BSD-3-Clause
#include "program.hpp"
#include "template_cases.hpp"

#include <chrono>
#include <nlohmann/json.hpp>
#include <thread>

/// A run that was stopped, however that came, goes on with --resume and ends as one that was not.
namespace brinell::cli::resume_test
{

namespace
{

constexpr const char* bodies = R"([lower]
shape = {type = "flat"}
material = {young_modulus = "200 GPa", poisson_ratio = 0.3, hardening = {law = "linear", yield_stress = "1 GPa", modulus = "20 GPa", back_stresses = [{modulus = "20 GPa"}]}}
[upper]
shape = {type = "sphere", radius = "1 mm"}
material = {young_modulus = "200 GPa", poisson_ratio = 0.3}
[grid]
resolution = 3
)";

std::string replaced(std::string text, const std::string& what, const std::string& by)
{
  return text.replace(text.find(what), what.size(), by);
}

/// Both bodies with friction and thermal constants.
std::string warm(const std::string& text, const std::string& upper_expansion)
{
  const auto steel = [](const std::string& expansion)
  {
    return "poisson_ratio = 0.3, thermal = {conductivity = \"50 W/(m K)\", density = 7800, specific_heat = 470, "
           "expansion = " +
           expansion + "}";
  };
  const std::string lower = replaced(text, "poisson_ratio = 0.3,", steel("12e-6") + ",");
  return replaced(replaced(lower, "poisson_ratio = 0.3}", steel(upper_expansion) + "}"), "[grid]",
                  "[interface]\nfriction = 0.3\n[grid]");
}

std::string scenario_case(const std::string& scenario)
{
  if (scenario == "indentation")
    return "scenario = \"indentation\"\n[indentation]\nload = [\"20 N\", 0]\nsteps = 12\ncycles = 2\n" +
           std::string(bodies);
  if (scenario == "rolling")
    return "scenario = \"rolling\"\n[rolling]\nload = \"20 N\"\ndistance = \"0.3 mm\"\npasses = 2\nload_steps = 3\n" +
           std::string(bodies);
  if (scenario == "sliding") // both bodies, each by its own shift, over a dent, by approach
    return replaced(
        "scenario = \"rolling\"\n[rolling]\napproach = \"1 um\"\ndistance = \"0.3 mm\"\nslide_to_roll = 0.3\n"
        "load_steps = 3\n" +
            std::string(bodies),
        "{type = \"flat\"}",
        "{type = \"flat\"}\ntexture = {type = \"dent\", depth = \"0.5 um\", edge_radius = \"25 um\"}");
  if (scenario == "growing") // grids too small for the second half of the way down
    return replaced("scenario = \"indentation\"\n[indentation]\nload = [\"60 N\", 0]\nsteps = 12\n" +
                        std::string(bodies),
                    "resolution = 3", "resolution = 4\nextent = 0.5");
  if (scenario == "heated") // by friction and by plastic work
    return "scenario = \"tugging\"\n[tugging]\ninterference = 6\npasses = 2\nspeed = \"1 m/s\"\n" +
           warm(replaced(bodies, "type = \"flat\"", "type = \"sphere\", radius = \"1 mm\""), "12e-6");
  if (scenario == "creeping") // they stick in places, and expand along each other
    return "scenario = \"rolling\"\n[rolling]\nload = \"20 N\"\ndistance = \"0.3 mm\"\nload_steps = 3\n"
           "creepage = [0.004, 0.001]\nspeed = \"5 m/s\"\n" +
           warm(bodies, "30e-6");
  const std::string drive = scenario == "loaded" ? "load = 8" : "interference = 4";
  const std::string text = "scenario = \"tugging\"\n[tugging]\n" + drive + "\npasses = 2\n" + std::string(bodies);
  return replaced(text, "type = \"flat\"", "type = \"sphere\", radius = \"1 mm\"");
}

class Stopping : public Program
{
protected:
  [[nodiscard]] int rows(const char* directory) const
  {
    const std::string text = file_text(folder() / directory / "history.csv");
    return static_cast<int>(std::count(text.begin(), text.end(), '\n')) - 1;
  }

  /// Runs case.toml until there are some rows, then sends the signal.
  [[nodiscard]] int stopped(int after, int signal) const
  {
    Process process = start({"run", "case.toml", "-q", "-o", "stopped"});
    while (process.running() && rows("stopped") < after)
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    process.signal(signal);
    return process.wait().exit_code;
  }

  void expect_same_as_uninterrupted() const
  {
    ASSERT_EQ(run({"run", "case.toml", "-q", "-o", "whole"}).exit_code, 0);
    for (const char* file : {"history.csv", "resolved.toml"})
      EXPECT_EQ(file_text(folder() / "stopped" / file), file_text(folder() / "whole" / file)) << file;
    auto resumed = nlohmann::json::parse(file_text(folder() / "stopped" / "summary.json"));
    auto whole = nlohmann::json::parse(file_text(folder() / "whole" / "summary.json"));
    for (auto* summary : {&resumed, &whole})
      (*summary)["run"].erase("wall_time_s");
    EXPECT_EQ(resumed, whole);
    EXPECT_FALSE(fs::exists(folder() / "stopped" / "checkpoint.h5"));
    EXPECT_FALSE(fs::exists(folder() / "stopped" / "snapshots"));
  }
};

class Resume : public Stopping, public testing::WithParamInterface<const char*>
{
protected:
  void SetUp() override
  {
    Program::SetUp();
    write("case.toml", scenario_case(GetParam()) + "[output]\nsnapshots = \"every 4\"\ncheckpoint_interval = 0\n");
  }
};

TEST_P(Resume, AfterAnInterrupt)
{
  EXPECT_EQ(stopped(5, SIGINT), 130);
  const Outcome resumed = run({"run", "case.toml", "-o", "stopped", "--resume"});
  EXPECT_EQ(resumed.exit_code, 0) << resumed.err;
  EXPECT_NE(resumed.err.find("resuming after"), std::string::npos) << resumed.err;
  expect_same_as_uninterrupted();
}

TEST_P(Resume, KilledAgainAndAgain)
{
  EXPECT_EQ(stopped(3, SIGKILL), 128 + SIGKILL);
  for (const int more : {2, 7})
  {
    const int before = rows("stopped");
    Process process = start({"run", "case.toml", "-q", "-o", "stopped", "--resume"});
    while (process.running() && rows("stopped") < before + more)
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    process.signal(SIGKILL);
    EXPECT_EQ(process.wait().exit_code, 128 + SIGKILL);
  }
  EXPECT_EQ(run({"run", "case.toml", "-q", "-o", "stopped", "--resume"}).exit_code, 0);
  expect_same_as_uninterrupted();
}

TEST_P(Resume, AfterAFullDisk)
{
  constexpr rlim_t too_small = 100000; // for a checkpoint; the history fits
  EXPECT_EQ(stopped(5, SIGINT), 130);
  Process full(folder(), {"run", "case.toml", "-q", "-o", "stopped", "--resume"}, too_small);
  const Outcome outcome = full.wait();
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_NE(outcome.err.find("stopped"), std::string::npos) << outcome.err; // the file
  EXPECT_FALSE(fs::exists(folder() / "stopped" / "summary.json"));
  EXPECT_EQ(run({"run", "case.toml", "-q", "-o", "stopped", "--resume"}).exit_code, 0);
  expect_same_as_uninterrupted();
}

TEST_P(Resume, WithGridsThatBeginLarger)
{
  EXPECT_EQ(stopped(3, SIGINT), 130);
  const Outcome resumed = run({"run", "case.toml", "-q", "-o", "stopped", "--resume", "--set", "grid.extent=1.2"});
  EXPECT_EQ(resumed.exit_code, 0) << resumed.err;
  EXPECT_FALSE(fs::exists(folder() / "stopped" / "checkpoint.h5"));
}

TEST_P(Resume, OnlyTheSameCaseThatIsNotComplete)
{
  EXPECT_EQ(run({"run", "case.toml", "-o", "nowhere", "--resume"}).exit_code, 2);
  EXPECT_FALSE(fs::exists(folder() / "nowhere"));
  EXPECT_EQ(stopped(3, SIGINT), 130);
  const Outcome other = run({"run", "case.toml", "-o", "stopped", "--resume", "--set", "grid.resolution=5"});
  EXPECT_EQ(other.exit_code, 2);
  const std::string difference =
      "of another case: grid.resolution = " + std::string(std::string(GetParam()) == "growing" ? "4.0" : "3.0") +
      " there, 5.0 here; ";
  EXPECT_NE(other.err.find("that was stopped there is " + difference), std::string::npos) << other.err;
  EXPECT_EQ(run({"run", "case.toml", "-q", "-o", "stopped", "--resume"}).exit_code, 0);
  const Outcome again = run({"run", "case.toml", "-o", "stopped", "--resume"});
  EXPECT_EQ(again.exit_code, 2);
  EXPECT_NE(again.err.find("complete, there is nothing to resume"), std::string::npos) << again.err;
  const Outcome finer = run({"run", "case.toml", "-o", "stopped", "--resume", "--set", "grid.resolution=5"});
  EXPECT_EQ(finer.exit_code, 2);
  EXPECT_NE(finer.err.find("that is complete there is " + difference), std::string::npos) << finer.err;
}

INSTANTIATE_TEST_SUITE_P(Cases, Resume,
                         testing::Values("tugging", "loaded", "indentation", "rolling", "sliding", "growing", "heated",
                                         "creeping"),
                         [](const auto& parameter) { return std::string(parameter.param); });

TEST_F(Stopping, ACheckpointOfAnotherRunIsRefused)
{
  const std::string text = scenario_case("rolling") + "[output]\nsnapshots = \"none\"\ncheckpoint_interval = 0\n";
  write("case.toml", replaced(text, "resolution = 3", "resolution = 4"));
  EXPECT_EQ(stopped(3, SIGINT), 130);
  fs::rename(folder() / "stopped", folder() / "other");
  write("case.toml", text);
  EXPECT_EQ(stopped(3, SIGINT), 130);
  fs::rename(folder() / "stopped" / "checkpoint.h5", folder() / "checkpoint.h5");
  fs::copy_file(folder() / "other" / "checkpoint.h5", folder() / "stopped" / "checkpoint.h5");
  // Its grids can be taken over, as those of a run whose grids have grown: the result would be that of no case.
  const Outcome outcome = run({"run", "case.toml", "-q", "-o", "stopped", "--resume"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_NE(outcome.err.find("checkpoint.h5: is of another case: grid.resolution = 4.0 there, 3.0 here; run without "
                             "--resume"),
            std::string::npos)
      << outcome.err;
  EXPECT_FALSE(fs::exists(folder() / "stopped" / "summary.json"));
  fs::rename(folder() / "checkpoint.h5", folder() / "stopped" / "checkpoint.h5");
  EXPECT_EQ(run({"run", "case.toml", "-q", "-o", "stopped", "--resume"}).exit_code, 0);
}

class ResumeEveryScenario : public Stopping, public testing::WithParamInterface<std::string>
{
protected:
  void SetUp() override
  {
    Program::SetUp();
    const Outcome made = run({"new", GetParam(), "-o", "new.toml"});
    ASSERT_EQ(made.exit_code, 0) << made.err;
    const Outcome checked = run({"check", "new.toml", "--set", test::few_cells(GetParam()), "--set",
                                 "output.checkpoint_interval=0"}); // what it prints is a case file
    ASSERT_EQ(checked.exit_code, 0) << checked.err;
    write("case.toml", checked.out);
  }
};

// Also of one that is new.
TEST_P(ResumeEveryScenario, IsTakenUpAfterAKill)
{
  EXPECT_EQ(stopped(4, SIGKILL), 128 + SIGKILL);
  const Outcome resumed = run({"run", "case.toml", "-q", "-o", "stopped", "--resume"});
  EXPECT_EQ(resumed.exit_code, 0) << resumed.err;
  expect_same_as_uninterrupted();
}

INSTANTIATE_TEST_SUITE_P(Scenarios, ResumeEveryScenario, testing::ValuesIn(io::scenario_names()),
                         [](const auto& parameter) { return parameter.param; });

} // namespace

} // namespace brinell::cli::resume_test
