// SPDX-License-Identifier: BSD-3-Clause
// What does the paper's case cost, all in all, and how many evaluations of the elastic-plastic operator a step?
#include "brinell/io/case_file.hpp"
#include "brinell/simulation/run.hpp"

#include <benchmark/benchmark.h>

namespace
{

/// Two equal elastic-plastic spheres at nine critical interferences on the paper's mesh (cases/tugging-paper).
void tugging_paper(benchmark::State& state)
{
  const brinell::io::Case c = brinell::io::read_case(BRINELL_SOURCE_DIR "/cases/tugging-paper/case.toml");
  brinell::simulation::TuggingSummary summary;
  for (auto _ : state)
    summary = brinell::simulation::run(std::get<brinell::simulation::TuggingCase>(c.scenario));
  state.counters["steps"] = summary.steps;
  state.counters["evaluations_per_step"] = static_cast<double>(summary.evaluations) / summary.steps;
  state.counters["split_increments"] = summary.split_increments;
}
BENCHMARK(tugging_paper)->Unit(benchmark::kMillisecond);

} // namespace
