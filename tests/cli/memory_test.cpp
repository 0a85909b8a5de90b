// SPDX-License-Identifier: BSD-3-Clause
#include "program.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <ostream>
#include <regex>
#include <string>
#include <vector>

/// What `brinell check` foretells of the memory of a run, against what real ones take.
namespace brinell::cli::memory_test
{

namespace
{

/// A case of this repository, made to take some tens of megabytes and few steps.
struct Sized
{
  const char* name;
  std::vector<std::string> changes; ///< as for --set
  std::string variant{};            ///< of a case that is there more than once
};

/// A pass of few steps with the heat of friction, and without that of plastic work.
Sized heated_by_friction(const std::string& regime)
{
  return {"tugging-heat",
          {"grid.resolution=12", R"(tugging.shift="0.2 mm")", "thermal.heat_of_plastic_work=0",
           fmt::format("thermal.regime=\"{}\"", regime)},
          "-" + regime};
}

void PrintTo(const Sized& sized, std::ostream* stream)
{
  *stream << sized.name;
}

class Memory : public Program, public testing::WithParamInterface<Sized>
{
};

/// Megabytes in the line of `check`.
double foretold(const std::string& report)
{
  std::smatch found;
  return std::regex_search(report, found, std::regex("([0-9.]+) MB of memory")) ? std::stod(found[1]) : 0.0;
}

TEST_P(Memory, IsAsForetold)
{
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "sanitizers take memory of their own";
#endif
  const fs::path file = fs::path(BRINELL_SOURCE_DIR) / "cases" / GetParam().name / "case.toml";
  const auto arguments = [&](const std::string& command)
  {
    std::vector<std::string> all{command, file.string()};
    for (const std::string& change : GetParam().changes)
      all.insert(all.end(), {"--set", change});
    return all;
  };
  const Outcome checked = run(arguments("check"));
  ASSERT_EQ(checked.exit_code, 0) << checked.err;
  std::vector<std::string> with_folder = arguments("run");
  with_folder.insert(with_folder.end(), {"-q", "-o", "out"});
  const Outcome done = run(with_folder);
  ASSERT_EQ(done.exit_code, 0) << done.err;
  const double memory = 1e-6 * done.memory;
  ASSERT_GT(memory, 25.0) << "the program without a run takes 17 MB";
  EXPECT_NEAR(foretold(checked.out) / memory, 1.0, 0.2) << memory << " MB"; // what is promised
}

INSTANTIATE_TEST_SUITE_P(
    Cases, Memory,
    testing::Values(
        Sized{"tugging-paper",
              {R"(grid.spacing=["1.5 mm", "3 mm", "0.75 mm"])", R"(tugging.shift="12 mm")", "tugging.interference=4",
               "output.snapshots=all"}},
        Sized{"tugging", {"grid.resolution=12", R"(tugging.shift="0.2 um")"}},
        Sized{"rolling-sliding", {"grid.resolution=6", "rolling.passes=1"}},
        Sized{"sliding-rough",
              {"sliding.strokes=1", R"(sliding.distance="2 um")", "output.checkpoint_interval=0"}}, // after each step
        Sized{"fretting-sphere", {}}, Sized{"fretting-sphere", {R"(output.fields="all")"}, "-all-fields"}, // elastic
        Sized{"rough-periodic", {}}, Sized{"rough-periodic", {R"(output.fields="all")"}, "-all-fields"},
        Sized{"rough-periodic", {"grid.cells=[384, 384]", "indentation.steps=2"}, "-surfaces"},
        Sized{"rolling-sliding", // all cells are unknowns
              {"grid.resolution=6", "rolling.passes=1", "solver.shortcuts=false"},
              "-no-shortcuts"},
        Sized{
            "tugging", {"grid.resolution=12", R"(tugging.shift="0.2 um")", "solver.shortcuts=false"}, "-no-shortcuts"},
        Sized{"flash-temperature", {}}, // elastic
        Sized{"tugging-heat", {"grid.resolution=10", R"(tugging.shift="0.2 mm")"}}, heated_by_friction("transient"),
        heated_by_friction("steady"),
        Sized{"rolling-heat", // tracks so long that images need half as many cells
              {"grid.resolution=10", "thermal.heat_of_plastic_work=0"},
              "-long"},
        Sized{"rolling-heat", {"grid.resolution=10"}, "-long-plastic"},
        // heat that reaches far beyond the grids, so that many images are removed
        Sized{"fretting-heat",
              {"grid.resolution=8", R"(fretting.frequency="0.1 Hz")", "fretting.steps_per_cycle=8"},
              "-far"},
        Sized{"tugging", {"grid.resolution=8", R"(output.snapshots="all")"}, "-many-states"},
        // nothing yields
        Sized{"tugging-cylinders",
              {"grid.resolution=40", "tugging.interference=0.5", R"(output.snapshots="none")"},
              "-elastic"}),
    [](const auto& parameter)
    {
      std::string name = parameter.param.name + parameter.param.variant;
      std::replace(name.begin(), name.end(), '-', '_');
      return name;
    });

class MemoryOfRanks : public Program
{
protected:
  /// A rough contact of 512 x 512 x 64 cells.
  [[nodiscard]] Outcome check(const std::vector<std::string>& further) const
  {
    std::vector<std::string> all{"check", BRINELL_SOURCE_DIR "/cases/rough-plastic/case.toml",
                                 "--set", "grid.cells=[512, 512]",
                                 "--set", "grid.layer=\"0.56 um\""};
    all.insert(all.end(), further.begin(), further.end());
    return run(all);
  }
};

TEST_F(MemoryOfRanks, IsNearlyItsShareOfThatOfOne)
{
  const auto megabytes = [&](const std::string& ranks)
  {
    const Outcome outcome = check({"--ranks", ranks, "--machines", ranks});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    std::smatch found;
    if (!std::regex_search(outcome.out, found, std::regex("layers each, ([0-9.]+) (MB|GB) of memory each")))
      return 0.0;
    return std::stod(found[1]) * (found[2] == "GB" ? 1000.0 : 1.0);
  };
  const double two = megabytes("2"), four = megabytes("4"), eight = megabytes("8");
  ASSERT_GT(eight, 0.0);
  // What is not shared, the contact, is there once more for each.
  EXPECT_LT(four, 0.56 * two);
  EXPECT_LT(eight, 0.62 * four);
  EXPECT_GT(four, 0.5 * two);
  EXPECT_GT(eight, 0.5 * four);
}

/// Contact of 512 x 512 periodic cells: 34 values per cell, as docs/theory/ranks.md tells, for any number of ranks.
TEST_F(MemoryOfRanks, TellsWhatIsNotShared)
{
  for (const std::string ranks : {"2", "8"})
  {
    const Outcome outcome = check({"--ranks", ranks, "--machines", ranks});
    EXPECT_NE(outcome.out.find("71.3 MB of it for contact and heat, which are not shared"), std::string::npos)
        << outcome.out;
  }
}

TEST_F(MemoryOfRanks, IsRefusedIfAMachineHasLess)
{
  const std::vector<std::string> larger{"--set", "grid.cells=[4096, 4096]", "--ranks", "64"};
  const Outcome refused = check(larger);
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_NE(refused.err.find("64 ranks on a machine need"), std::string::npos) << refused.err;
  EXPECT_NE(refused.err.find("grid.cells"), std::string::npos) << refused.err;
  EXPECT_EQ(check({"--machines", "4"}).exit_code, 2) << "of which ranks?";
  const Outcome fatigue = run({"check", BRINELL_SOURCE_DIR "/cases/rolling-fatigue/case.toml", "--ranks", "2"});
  EXPECT_EQ(fatigue.exit_code, 2) << "no ranks can share it";
}

} // namespace

} // namespace brinell::cli::memory_test
