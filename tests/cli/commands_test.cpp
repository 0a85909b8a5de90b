// SPDX-License-Identifier: BSD-3-Clause
#include "program.hpp"

#include <algorithm>
#include <chrono>
#include <thread>

namespace brinell::cli::commands_test
{

namespace
{

class Commands : public Program
{
};

long lines(const std::string& text)
{
  return std::count(text.begin(), text.end(), '\n');
}

TEST_F(Commands, VersionAndHelp)
{
  const Outcome version = run({"--version"});
  EXPECT_EQ(version.exit_code, 0);
  EXPECT_EQ(version.out.rfind("brinell ", 0), 0u);
  for (const std::vector<std::string>& arguments :
       std::vector<std::vector<std::string>>{{"--help"}, {"run", "--help"}, {"check", "-h"}})
  {
    const Outcome help = run(arguments);
    EXPECT_EQ(help.exit_code, 0);
    EXPECT_NE(help.out.find("Usage: brinell"), std::string::npos) << help.out;
  }
}

TEST_F(Commands, LicencesOfAllLibraries)
{
  const Outcome licences = run({"--licenses"});
  EXPECT_EQ(licences.exit_code, 0);
  EXPECT_EQ(licences.out.rfind("BSD 3-Clause License\n", 0), 0u);
  for (const char* library : {"fmt", "toml++", "JSON for Modern C++", "CLI11", "nanobind", "xxHash", "Eigen", "HDF5",
                              "zlib", "libaec", "libgomp, libstdc++"})
    EXPECT_NE(licences.out.find(std::string("\n") + library), std::string::npos) << library;
}

// The reference page is written by the program: make it anew with `brinell schema --markdown`.
TEST_F(Commands, SchemaIsTheReferencePage)
{
  const Outcome schema = run({"schema", "--markdown"});
  EXPECT_EQ(schema.exit_code, 0);
  EXPECT_EQ(schema.out, file_text(BRINELL_SOURCE_DIR "/docs/reference/case-file.md"))
      << "run: brinell schema --markdown > docs/reference/case-file.md";
  EXPECT_NE(run({"schema"}).out.find("tugging.interference\n"), std::string::npos);
}

TEST_F(Commands, SchemaTellsAKeyATableOrAllToAnEditor)
{
  EXPECT_EQ(run({"schema", "grid.extent"}).out.rfind("grid.extent\n", 0), 0u);
  const Outcome wrong = run({"schema", "grid.extnt"});
  EXPECT_EQ(wrong.exit_code, 2);
  EXPECT_NE(wrong.err.find("did you mean grid.extent?"), std::string::npos) << wrong.err;
  EXPECT_EQ(run({"schema", "--json"}).out.rfind("{\n", 0), 0u);
  EXPECT_EQ(run({"schema", "--json", "--markdown"}).exit_code, 2);
  EXPECT_EQ(run({"schema", "grid", "--json"}).exit_code, 2);
}

TEST_F(Commands, ConsoleCountsPassesAsTheHistoryDoes)
{
  ASSERT_EQ(run({"new", "rolling", "-o", "case.toml"}).exit_code, 0);
  const Outcome outcome =
      run({"run", "case.toml", "-o", "out", "--set", "rolling.distance=0.2 mm", "--set", "grid.resolution=3"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  const std::string told = outcome.out + outcome.err;
  EXPECT_NE(told.find("pass 1  x "), std::string::npos) << told;
  EXPECT_EQ(told.find("pass 2"), std::string::npos) << told;
}

TEST_F(Commands, CheckPrintsACaseThatChecksTheSame)
{
  write("case.toml", quick_case);
  const Outcome check = run({"check", "--set", "tugging.passes=2", "--set", "title=twice", "case.toml"});
  ASSERT_EQ(check.exit_code, 0) << check.err;
  EXPECT_NE(check.out.find("passes = 2\n"), std::string::npos);
  EXPECT_NE(check.out.find("There are no critical values: neither body can yield."), std::string::npos) << check.out;
  EXPECT_FALSE(fs::exists(folder() / "results")) << "check must not write";
  write("again.toml", check.out);
  std::string again = run({"check", "again.toml"}).out;
  const auto name = again.find("again.toml");
  ASSERT_NE(name, again.npos);
  EXPECT_EQ(again.replace(name, 10, "case.toml"), check.out);
}

TEST_F(Commands, RunWritesAllFiles)
{
  write("small/case.toml", quick_case);
  const Outcome outcome = run({"run", "small/case.toml"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("results in results/small"), std::string::npos) << outcome.out;
  EXPECT_EQ(outcome.err.find('\r'), std::string::npos) << "a progress bar, but no terminal";
  const fs::path results = folder() / "results" / "small"; // named after the folder of case.toml
  for (const char* file : {"history.csv", "summary.json", "result.vtkhdf", "resolved.toml"})
    EXPECT_TRUE(fs::exists(results / file)) << file;
  EXPECT_FALSE(fs::exists(results / "snapshots"));
  EXPECT_GT(lines(file_text(results / "history.csv")), 5);
}

TEST_F(Commands, FolderFromCommandLineWinsOverCase)
{
  write("case.toml", "output.directory = \"from-case\"\n" + std::string(quick_case));
  EXPECT_EQ(run({"run", "case.toml", "-q"}).exit_code, 0);
  EXPECT_TRUE(fs::exists(folder() / "from-case" / "summary.json"));
  EXPECT_EQ(run({"run", "case.toml", "-q", "-o", "from-line"}).exit_code, 0);
  EXPECT_TRUE(fs::exists(folder() / "from-line" / "summary.json"));
}

TEST_F(Commands, QuietIsQuietAndOldResultsAreNamed)
{
  write("case.toml", quick_case);
  const Outcome quiet = run({"run", "case.toml", "--quiet", "-o", "out"});
  EXPECT_EQ(quiet.out, "");
  EXPECT_EQ(lines(quiet.err), 1) << quiet.err; // of the few cells
  EXPECT_EQ(quiet.err.rfind("brinell: warning: ", 0), 0u) << quiet.err;
  const Outcome again = run({"run", "case.toml", "-o", "out"});
  EXPECT_EQ(again.exit_code, 0);
  EXPECT_NE(again.err.find("replacing the earlier result in out"), std::string::npos) << again.err;
  const Outcome kept = run({"run", "case.toml", "-o", "out", "--keep"});
  EXPECT_EQ(kept.exit_code, 2);
  EXPECT_NE(kept.err.find("out: holds an earlier result, which is to be kept; allowed: another folder"), kept.err.npos)
      << kept.err;
  EXPECT_EQ(run({"run", "case.toml", "-q", "-o", "new", "--keep"}).exit_code, 0);
  EXPECT_EQ(run({"run", "case.toml", "-q", "-o", "new", "--keep", "--resume"}).exit_code, 2);
}

TEST_F(Commands, ThreadsAreSetAndRecorded)
{
  write("case.toml", quick_case);
  ASSERT_EQ(run({"run", "case.toml", "-q", "-o", "out", "--threads", "2"}).exit_code, 0);
  EXPECT_NE(file_text(folder() / "out" / "summary.json").find("\"threads\": 2"), std::string::npos);
}

class Interruption : public Program
{
protected:
  /// Starts a run far longer than the test, sends the signal when some steps are written, returns what is left of it.
  Outcome interrupt(int signal)
  {
    write("case.toml", quick_case);
    Process process = start(
        {"run", "case.toml", "-q", "-o", "out", "--set", "tugging.passes=10000", "--set", "output.snapshots=every 3"});
    const auto patience = std::chrono::steady_clock::now() + std::chrono::minutes(2);
    while (process.running() && lines(file_text(folder() / "out" / "history.csv")) < 8 &&
           std::chrono::steady_clock::now() < patience)
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    process.signal(signal);
    return process.wait();
  }

  void expect_finished_steps() const
  {
    EXPECT_GE(lines(file_text(folder() / "out" / "history.csv")), 8);
    EXPECT_TRUE(fs::exists(folder() / "out" / "result.vtkhdf"));
    EXPECT_FALSE(fs::exists(folder() / "out" / "summary.json")) << "it would look complete";
  }
};

TEST_F(Interruption, EndsAfterTheStep)
{
  const Outcome outcome = interrupt(SIGINT);
  EXPECT_EQ(outcome.exit_code, 130) << outcome.err;
  EXPECT_NE(outcome.err.find("the finished steps are in out"), std::string::npos) << outcome.err;
  expect_finished_steps();
  EXPECT_TRUE(fs::exists(folder() / "out" / "checkpoint.h5")) << "to go on from";
}

TEST_F(Interruption, KilledRunKeepsItsSteps)
{
  EXPECT_EQ(interrupt(SIGKILL).exit_code, 128 + SIGKILL);
  expect_finished_steps();
  EXPECT_TRUE(fs::exists(folder() / "out" / "snapshots" / "000000.h5"));
}

} // namespace

} // namespace brinell::cli::commands_test
