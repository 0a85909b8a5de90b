// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/foundation/error.hpp"
#include "brinell/io/feasibility.hpp"
#include "brinell/io/result_directory.hpp"
#include "brinell/io/snapshot_choice.hpp"
#include "commands.hpp"
#include "interrupt.hpp"
#include "progress.hpp"

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

void print_summary(const io::Case& c, const simulation::TuggingSummary& s, double seconds, const fs::path& folder)
{
  fmt::print("{} steps, {} iterations, {:.2f} s\n", s.steps, s.iterations, seconds);
  if (s.split_increments > 0)
    fmt::print("{} increments had to be split\n", s.split_increments);
  const double X = s.X_at_peak_F_X / io::equivalent_radius(c.tugging);
  if (c.first_yield)
  {
    const auto& critical = c.first_yield->critical;
    fmt::print("peak F_X  {:>11.5f} P_c at X/R = {:+.5f}\nmin F_X   {:>11.5f} P_c\npeak F_Z  {:>11.5f} P_c\nnet work  "
               "{:>11.5f} U_c\n",
               s.peak_F_X / critical.load, X, s.min_F_X / critical.load, s.peak_F_Z / critical.load,
               s.work / critical.energy);
  }
  else
    fmt::print(
        "peak F_X  {:>13.6e} N at X/R = {:+.5f}\nmin F_X   {:>13.6e} N\npeak F_Z  {:>13.6e} N\nnet work  {:>13.6e} J\n",
        s.peak_F_X, X, s.min_F_X, s.peak_F_Z, s.work);
  fmt::print("energy balance error {:.2e}\nresults in {}\n", s.energy_balance_error, folder.string());
}

/// Runs the case and writes its steps; the summary comes back, the folder stays open.
simulation::TuggingSummary simulate(const io::Case& c, io::ResultDirectory& results, bool quiet)
{
  Progress progress(io::equivalent_radius(c.tugging), quiet);
  io::SnapshotChoice choice(c.snapshots);
  simulation::TuggingObserver observer;
  observer.on_step = [&](const simulation::StepRecord& record, int step_count)
  {
    results.add(record);
    progress.step(record, step_count);
  };
  observer.wants_snapshot = [&](const simulation::StepRecord& record)
  {
    if (const int signal = InterruptGuard::signal())
      throw Interrupted{signal};
    return choice(record);
  };
  observer.on_snapshot = [&](const simulation::Snapshot& snapshot) { results.add(snapshot); };
  return simulation::run(c.tugging, observer);
}

/// Closes the results of a run that was left early, whose own reason is already on its way to the user.
void stop(io::ResultDirectory& results, const fs::path& folder)
{
  try
  {
    results.stop();
  }
  catch (const IoError& error)
  {
    fmt::print(stderr, "brinell: {}\n", error.what());
  }
  fmt::print(stderr, "brinell: the finished steps are in {}\n", folder.string());
}

} // namespace

int run_command(const RunOptions& options)
{
  if (options.threads > 0)
    omp_set_num_threads(options.threads);
  const io::Case c = io::read_case(options.input.file, options.input.overrides);
  print_warnings(c);
  const simulation::TuggingPlan plan = io::plan_case(c);
  const fs::path folder = result_path(options, c);
  const auto start = std::chrono::steady_clock::now();
  const InterruptGuard guard;
  io::ResultDirectory results(folder, c);
  if (results.replaced() && !options.quiet)
    fmt::print(stderr, "brinell: replacing the earlier result in {}\n", folder.string());
  try
  {
    const auto summary = simulate(c, results, options.quiet);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    results.finish(plan, summary, {.wall_time = seconds, .threads = omp_get_max_threads()});
    if (!options.quiet)
      print_summary(c, summary, seconds, folder);
  }
  catch (const Interrupted& interrupted)
  {
    fmt::print(stderr, "brinell: interrupted\n");
    stop(results, folder);
    return 128 + interrupted.signal;
  }
  catch (const ConvergenceError&)
  {
    stop(results, folder);
    throw;
  }
  catch (const InputError&) // the grid turned out too small
  {
    stop(results, folder);
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
