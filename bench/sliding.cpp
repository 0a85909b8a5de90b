// SPDX-License-Identifier: BSD-3-Clause
// What does a step cost of two rough surfaces that yield and slide, and does that grow as N log N, the memory as N?
#include "brinell/io/case_file.hpp"
#include "brinell/simulation/run.hpp"

#include <benchmark/benchmark.h>

#include <cstdint>
#include <ctime>
#include <fmt/format.h>
#include <fstream>
#include <string>
#include <variant>

namespace
{

using namespace brinell;
using simulation::SlidingCase;

/// Memory of this process [bytes].
double memory()
{
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;)
    if (double kilobytes = 0.0; word == "VmRSS:" && status >> kilobytes)
      return 1024.0 * kilobytes;
  return 0.0;
}

/// Of all threads [s].
double processor_seconds()
{
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/// The steps of bench/sliding.toml that slide, on other cells; pressing, with less contact at first, is not counted.
void sliding_step(benchmark::State& state)
{
  const io::Case c =
      io::read_case(BRINELL_SOURCE_DIR "/bench/sliding.toml", {fmt::format("grid.cells={}", state.range(0))});
  const auto& sliding = std::get<SlidingCase>(c.scenario);
  const simulation::SlidingPlan plan = simulation::plan(sliding);
  const double before = memory();
  simulation::Run<SlidingCase> run(sliding);
  for (int n = 0; n < sliding.press_steps; ++n)
    static_cast<void>(run.step());
  double evaluations = 0.0, contact = 0.0, processor = 0.0;
  for (auto _ : state)
  {
    const double start = processor_seconds();
    const simulation::SlidingRecord& step = run.step();
    processor += processor_seconds() - start;
    evaluations += step.evaluations;
    contact += step.contact_fraction;
  }
  const auto steps = static_cast<double>(state.iterations());
  const auto cells = static_cast<double>(plan.lower.size() + plan.upper.size());
  state.SetComplexityN(static_cast<std::int64_t>(cells));
  state.counters["layers"] = plan.lower.nz;
  state.counters["evaluations_per_step"] = evaluations / steps;
  state.counters["contact_percent"] = 100.0 * contact / steps;
  state.counters["processor_s_per_step"] = processor / steps;
  state.counters["ns_per_cell_and_evaluation"] = 1e9 * processor / evaluations / cells;
  state.counters["bytes_per_cell"] = (memory() - before) / cells;
}
BENCHMARK(sliding_step)
    ->ArgName("cells")
    ->Arg(64)
    ->Arg(128)
    ->Arg(256)
    ->Iterations(4)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->Complexity(benchmark::oNLogN);

} // namespace
