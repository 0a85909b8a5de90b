// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/foundation/error.hpp"
#include "brinell/io/feasibility.hpp"
#include "brinell/io/result_directory.hpp"
#include "brinell/io/snapshot_choice.hpp"
#include "brinell/io/summary_json.hpp"
#include "commands.hpp"
#include "interrupt.hpp"
#include "progress.hpp"
#include "scenario_text.hpp"

#include <chrono>
#include <filesystem>
#include <fmt/format.h>
#include <omp.h>

namespace brinell::app
{

namespace
{

namespace fs = std::filesystem;

fs::path result_path(const RunOptions& options, const io::Case& c)
{
  if (!options.directory.empty())
    return options.directory;
  return c.directory.value_or(fs::path("results") / c.name);
}

void print_warnings(const io::Case& c)
{
  for (const auto& warning : c.warnings)
    fmt::print(stderr, "brinell: warning: {}: {}\n", c.file.string(), warning);
}

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start)
{
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Runs one scenario and writes its steps; finishes the folder and prints what came out.
template <typename ScenarioCase>
void simulate(const ScenarioCase& scenario, const io::Case& c, io::ResultDirectory& results, const fs::path& folder,
              bool quiet)
{
  using Record = typename ScenarioCase::Record;
  const auto start = Clock::now();
  Progress progress(quiet, results.finished_steps());
  io::SnapshotChoice choice(c.snapshots);
  if (results.checkpoint())
  {
    Archive archive(*results.checkpoint());
    archive("snapshot_choice", choice);
  }
  auto checkpoint_time = start;
  simulation::Observer<Record> observer;
  observer.on_step = [&](const Record& record, int step_count)
  {
    results.add(io::columns(record));
    progress.step(record.step, step_count, step_text(c, record), record.iterations);
  };
  observer.wants_snapshot = [&](const Record& record) { return choice(scenario, record); };
  observer.on_snapshot = [&](const Record& record, const simulation::Snapshot& snapshot)
  { results.add(record.step, io::columns(record), snapshot); };
  observer.wants_checkpoint = [&](const Record&)
  { return InterruptGuard::signal() != 0 || seconds_since(checkpoint_time) >= c.checkpoint_interval; };
  observer.on_checkpoint = [&](const Record& record, Archive::Fields state)
  {
    Archive archive;
    archive("snapshot_choice", choice);
    state.merge(std::move(archive).fields());
    results.add_checkpoint(record.step, state);
    checkpoint_time = Clock::now();
    if (const int signal = InterruptGuard::signal())
      throw Interrupted{signal};
  };
  const auto summary = simulation::run(scenario, observer, results.checkpoint() ? &*results.checkpoint() : nullptr);
  const double seconds = seconds_since(start);
  results.finish(summary.final_state, io::columns(summary.last),
                 io::summary_text(c, simulation::plan(scenario), summary,
                                  {.wall_time = seconds, .threads = omp_get_max_threads()}));
  if (quiet)
    return;
  fmt::print("{} steps, {} iterations, {:.2f} s\n", summary.steps, summary.iterations, seconds);
  if (summary.split_increments > 0)
    fmt::print("{} increments had to be split\n", summary.split_increments);
  fmt::print("{}energy balance error {:.2e}\nresults in {}\n", summary_text(c, summary), summary.energy_balance_error,
             folder.string());
}

} // namespace

int run_command(const RunOptions& options)
{
  if (options.threads > 0)
    omp_set_num_threads(options.threads);
  const io::Case c = io::read_case(options.input.file, options.input.overrides);
  print_warnings(c);
  static_cast<void>(io::plan_case(c)); // is refused before anything is written
  const fs::path folder = result_path(options, c);
  const InterruptGuard guard;
  using Mode = io::ResultDirectory::Mode;
  io::ResultDirectory results(folder, c, options.resume ? Mode::resume : Mode::replace);
  if (results.replaced() && !options.quiet)
    fmt::print(stderr, "brinell: replacing the earlier result in {}\n", folder.string());
  if (options.resume && !options.quiet)
    fmt::print(stderr, "brinell: going on after {} finished steps\n", results.finished_steps());
  try
  {
    std::visit([&](const auto& scenario) { simulate(scenario, c, results, folder, options.quiet); }, c.scenario);
  }
  catch (const Interrupted& interrupted)
  {
    fmt::print(stderr, "brinell: interrupted; the finished steps are in {}, and --resume goes on\n", folder.string());
    return 128 + interrupted.signal;
  }
  catch (const std::runtime_error&) // no convergence, the grid turned out too small, the disk is full
  {
    fmt::print(stderr, "brinell: the finished steps are in {}\n", folder.string());
    throw;
  }
  return exit_ok;
}

int check_command(const CaseOptions& options)
{
  const io::Case c = io::read_case(options.file, options.overrides);
  print_warnings(c);
  fmt::print("{}", io::check_report(c, io::plan_case(c)));
  return exit_ok;
}

int schema_command(bool markdown)
{
  fmt::print("{}", markdown ? io::schema_markdown() : io::schema_text());
  return exit_ok;
}

} // namespace brinell::app
