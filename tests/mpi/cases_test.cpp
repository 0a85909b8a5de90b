// SPDX-License-Identifier: BSD-3-Clause
#include "shared_runs.hpp"

#include <map>

/// The cases of this repository, shorter and on fewer cells: ranks compute them with the digits of one process.
namespace brinell::mpi_test
{
namespace
{

/// Settings that make a case short, as for --set.
std::vector<std::string> shortening(const std::string& name)
{
  static const std::map<std::string, std::vector<std::string>> of_some{
      {"connector-plated", {R"(grid.spacing=["4 um", "4 um", "0.6 um"])", "indentation.steps=4"}},
      {"electrical-connector", {"grid.cells=[36, 36]", "indentation.steps=4"}},
      {"rough-periodic", {"grid.cells=[48, 48]", "indentation.steps=6"}},
      {"rough-plastic", {"grid.cells=[36, 36]", "indentation.steps=4"}},
      {"sliding", {R"(grid.spacing=["10 um", "10 um", "6 um"])", R"(sliding.distance="50 um")"}},
      {"sliding-rough", {"grid.cells=[20, 20]", "sliding.strokes=1", "sliding.press_steps=2"}},
      {"tugging-paper", {"tugging.interference=4"}},
      {"tugging-rough", {R"(grid.spacing=["0.3 um", "0.3 um", "0.2 um"])"}},
  };
  if (const auto found = of_some.find(name); found != of_some.end())
    return found->second;
  std::vector<std::string> settings{"grid.resolution=3"};
  const std::string text = file_text(fs::path(BRINELL_SOURCE_DIR) / "cases" / name / "case.toml");
  for (const std::string scenario : {"fretting", "indentation", "rolling", "tugging"})
    for (const std::string repetition : {"cycles", "passes"})
      if (text.find("scenario = \"" + scenario + "\"") != std::string::npos &&
          text.find("\n" + repetition + " = ") != std::string::npos)
        settings.push_back(scenario + "." + repetition + "=1");
  return settings;
}

/// All cases but those of fatigue and of inclusions, which ranks refuse.
std::vector<std::string> shareable_cases()
{
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(BRINELL_SOURCE_DIR "/cases"))
    if (const std::string name = entry.path().filename().string();
        fs::exists(entry.path() / "case.toml") && name != "rolling-fatigue" && name != "rolling-inclusion")
      names.push_back(name);
  std::sort(names.begin(), names.end());
  return names;
}

class SharedCases : public SharedRuns, public testing::WithParamInterface<std::string>
{
protected:
  [[nodiscard]] Outcome run_case(int ranks, const std::string& name, const std::string& output) const
  {
    std::vector<std::string> arguments{"run", "-q", BRINELL_SOURCE_DIR "/cases/" + name + "/case.toml", "-o", output};
    for (const std::string& setting : shortening(name))
      arguments.insert(arguments.end(), {"--set", setting});
    return run(ranks, arguments);
  }
};

TEST_P(SharedCases, HaveTheDigitsOfOneProcess)
{
  const Outcome alone = run_case(0, GetParam(), "alone");
  ASSERT_EQ(alone.exit_code, 0) << alone.err;
  for (const int ranks : {2, 3})
  {
    SCOPED_TRACE(ranks);
    const std::string output = "ranks-" + std::to_string(ranks);
    const Outcome shared = run_case(ranks, GetParam(), output);
    ASSERT_EQ(shared.exit_code, 0) << shared.err;
    expect_same_results(output, "alone");
  }
}

INSTANTIATE_TEST_SUITE_P(Cases, SharedCases, testing::ValuesIn(shareable_cases()),
                         [](const auto& parameter)
                         {
                           std::string name = parameter.param;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

} // namespace
} // namespace brinell::mpi_test
