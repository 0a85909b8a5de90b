// SPDX-License-Identifier: BSD-3-Clause
#include "run_case.hpp"

#include "accuracy.hpp"
#include "brinell/foundation/error.hpp"
#include "brinell/io/point_history.hpp"
#include "brinell/io/result_image.hpp"
#include "brinell/io/scenario_text.hpp"
#include "brinell/io/snapshot_choice.hpp"
#include "brinell/io/summary_json.hpp"
#include "brinell/quality/quality.hpp"
#include "brinell/simulation/run.hpp"

#include <chrono>
#include <fmt/format.h>
#include <functional>
#include <omp.h>
#include <optional>
#include <utility>

namespace brinell::app
{

namespace
{

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start)
{
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// A request to stop: honoured after the current step, or within the step if it takes too long.
class Stop
{
public:
  explicit Stop(const std::function<bool()>& wanted) : wanted_(wanted) {}

  [[nodiscard]] bool after_step()
  {
    if (!is_wanted_ && wanted_ && wanted_())
    {
      is_wanted_ = true;
      since_ = Clock::now();
    }
    return is_wanted_;
  }
  [[nodiscard]] bool at_once()
  {
    constexpr double grace = 2.0; // [s]
    return after_step() && seconds_since(since_) > grace;
  }

private:
  const std::function<bool()>& wanted_;
  bool is_wanted_ = false;
  Clock::time_point since_;
};

/// Text that the program prints about a finished run.
template <typename Summary>
std::string report_text(const io::Case& c, const io::ScenarioPlan& plan, const Summary& summary,
                        const io::RunInfo& info)
{
  std::string text =
      fmt::format("{} steps, {} evaluations, {:.2f} s\n", summary.steps, summary.evaluations, info.wall_time);
  if (summary.split_increments > 0)
    text += fmt::format("{} increments had to be split\n", summary.split_increments);
  text += fmt::format("{}energy balance error {:.2e}\n{}\n", io::results_text(c, summary), summary.energy_balance_error,
                      quality::resolution_text(info.quality.resolution));
  if (const std::string left_out = io::left_out_text(c, plan); !left_out.empty())
    text += left_out + "\n";
  return info.accuracy ? text + accuracy_text(*info.accuracy) : text;
}

/// Runs one scenario, writes its steps and finishes the results.
/// @param Results  io::ResultDirectory or io::ResultImage
template <typename ScenarioCase, typename Results>
LevelReport simulate(const ScenarioCase& scenario, const io::Case& c, const io::ScenarioPlan& any_plan,
                     Results& results, const RunMonitor& monitor, const LevelsBefore& before)
{
  const auto& plan = std::get<typename ScenarioCase::Plan>(any_plan);
  using Record = typename ScenarioCase::Record;
  const auto start = Clock::now();
  io::SnapshotChoice choice(c.snapshots);
  std::optional<Archive::Fields> checkpoint = results.take_checkpoint();
  if (checkpoint)
  {
    Archive archive(*checkpoint);
    archive("snapshot_choice", choice);
  }
  Stop stop(monitor.wants_stop);
  auto checkpoint_time = start;
  simulation::Observer<Record> observer;
  observer.on_step = [&](const Record& record, int step_count)
  {
    results.add(io::columns(record));
    if (monitor.on_step)
      monitor.on_step(record.step, step_count, io::step_text(c, record), record.evaluations);
  };
  bool is_stored = false; // whether the fields of the step are
  observer.wants_snapshot = [&](const Record& record)
  {
    is_stored = choice(c.scenario, record);
    return is_stored || !c.output.points.empty();
  };
  observer.on_snapshot = [&](const Record& record, const simulation::StepFields& fields)
  {
    for (const auto& row : io::point_rows(c.output.points, record.step, fields))
      results.add_point(row);
    if (is_stored)
      results.add(record.step, io::columns(record), fields);
  };
  observer.wants_checkpoint = [&](const Record&)
  {
    return stop.after_step() || (Results::keeps_checkpoints && seconds_since(checkpoint_time) >= c.checkpoint_interval);
  };
  observer.on_checkpoint = [&](const Record&, const std::function<void(Archive&)>& state)
  {
    const auto with_choice = [&](Archive& archive)
    {
      state(archive);
      archive("snapshot_choice", choice);
    };
    results.add_checkpoint(with_choice);
    checkpoint_time = Clock::now();
    if (stop.after_step())
      throw Interrupted();
  };
  observer.wants_stop = [&] { return stop.at_once(); };
  observer.available_memory = io::machine_memory();
  observer.on_grid_change = [&](const simulation::GridChange& change)
  {
    if (monitor.on_remark)
      monitor.on_remark(text(change));
  };
  std::optional<simulation::Run<ScenarioCase>> run(std::in_place, scenario, observer,
                                                   checkpoint ? &*checkpoint : nullptr, plan);
  // Cells that have been asked for before are followed in the evaluations, with other rounding: as if the run had not stopped.
  if (checkpoint && !c.output.points.empty())
    static_cast<void>(io::point_rows(c.output.points, 0, run->fields()));
  checkpoint.reset();
  simulation::finish(*run, observer);
  const auto summary = run->totals();
  const double seconds = seconds_since(start);
  results.add_final(run->fields(), io::columns(summary.last));
  run.reset(); // frees its memory
  io::RunInfo info{
      .wall_time = seconds, .threads = omp_get_max_threads(), .quality = quality::judged(scenario, plan, summary)};
  info.quality.warnings.insert(info.quality.warnings.begin(), c.warnings.begin(), c.warnings.end());
  for (io::Warning& warning : io::result_warnings(c, any_plan))
    info.quality.warnings.push_back(std::move(warning));
  if (const auto missing = io::missing_steps(c.snapshots, summary.last.step))
    info.quality.warnings.push_back(*missing);
  LevelReport report{{}, io::level_of(c, plan, summary, info, before.cells), {}};
  judge(c, before, report, info);
  results.finish(io::summary_text(c, plan, summary, info));

  report.report = {report_text(c, any_plan, summary, info), info.quality.warnings};
  return report;
}

/// Sets the number of threads for its lifetime.
class Threads
{
public:
  explicit Threads(int count) : before_(omp_get_max_threads())
  {
    if (count > 0)
      omp_set_num_threads(count);
  }
  ~Threads() { omp_set_num_threads(before_); }
  Threads(const Threads&) = delete;
  Threads& operator=(const Threads&) = delete;

private:
  int before_;
};

} // namespace

std::filesystem::path default_folder(const io::Case& c)
{
  return c.directory.value_or(std::filesystem::path("results") / c.name);
}

LevelReport run_level(const io::Case& c, const io::ScenarioPlan& plan, const std::filesystem::path& folder,
                      io::ResultDirectory::Mode mode, const RunMonitor& monitor, const LevelsBefore& before)
{
  io::ResultDirectory results(folder, c, io::stored_parts(c, plan), mode);
  if (monitor.on_start)
    monitor.on_start(results.replaced(), results.finished_steps());
  return std::visit([&](const auto& scenario) { return simulate(scenario, c, plan, results, monitor, before); },
                    c.scenario);
}

std::string run_in_memory(const io::Case& c, int threads, const RunMonitor& monitor)
{
  if (c.accuracy)
    throw InputError("solver.accuracy requests a series of runs, which needs a folder for its results; allowed: a run "
                     "with a folder, or no solver.accuracy");
  const Threads guard(threads);
  const io::ScenarioPlan plan = io::plan_case(c);
  io::ResultImage results(c, io::stored_parts(c, plan));
  std::visit([&](const auto& scenario) { (void)simulate(scenario, c, plan, results, monitor, {}); }, c.scenario);
  return std::move(results).bytes();
}

RunReport run_case(const io::Case& c, const io::ScenarioPlan& plan, const RunOptions& options,
                   const RunMonitor& monitor)
{
  const Threads threads(options.threads);
  return c.accuracy ? run_series(c, plan, options, monitor)
                    : run_level(c, plan, options.folder, options.mode, monitor, {}).report;
}

} // namespace brinell::app
