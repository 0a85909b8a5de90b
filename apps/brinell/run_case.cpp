// SPDX-License-Identifier: BSD-3-Clause
#include "run_case.hpp"

#include "accuracy.hpp"
#include "brinell/foundation/error.hpp"
#include "brinell/io/point_history.hpp"
#include "brinell/io/result_image.hpp"
#include "brinell/io/scenario_text.hpp"
#include "brinell/io/snapshot_choice.hpp"
#include "brinell/io/summary_json.hpp"
#include "brinell/io/versions.hpp"
#include "brinell/quality/quality.hpp"
#include "brinell/simulation/forecast.hpp"
#include "brinell/simulation/run.hpp"
#include "following.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <exception>
#include <fmt/format.h>
#include <functional>
#include <map>
#include <omp.h>
#include <optional>
#include <string>
#include <string_view>
#include <unistd.h>
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
  /// @param ranks  which stop together: all of them ask at the same places
  Stop(const std::function<bool()>& wanted, const Communicator& ranks) : wanted_(wanted), ranks_(ranks) {}

  [[nodiscard]] bool after_step()
  {
    if (!is_wanted_ && ranks_.any(wanted_ && wanted_()))
    {
      is_wanted_ = true;
      since_ = Clock::now();
    }
    return is_wanted_;
  }
  [[nodiscard]] bool at_once()
  {
    constexpr double grace = 2.0; // [s]
    return after_step() && ranks_.any(seconds_since(since_) > grace);
  }

private:
  const std::function<bool()>& wanted_;
  const Communicator& ranks_;
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
/// @param Results  io::ResultDirectory, FollowingResults or io::ResultImage
/// @param ranks    nullptr: this process alone
template <typename ScenarioCase, typename Results>
LevelReport simulate(const ScenarioCase& scenario, const io::Case& c, const io::ScenarioPlan& any_plan,
                     Results& results, const RunMonitor& monitor, const LevelsBefore& before,
                     std::optional<Archive::Fields> checkpoint, const std::shared_ptr<const Communicator>& ranks)
{
  const auto& plan = std::get<typename ScenarioCase::Plan>(any_plan);
  using Record = typename ScenarioCase::Record;
  const auto start = Clock::now();
  io::SnapshotChoice choice(c.snapshots);
  if (checkpoint)
  {
    Archive archive(*checkpoint);
    archive("snapshot_choice", choice);
  }
  const Communicator alone;
  const Communicator& all_ranks = ranks ? *ranks : alone;
  Stop stop(monitor.wants_stop, all_ranks);
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
    return stop.after_step() ||
           (Results::keeps_checkpoints && all_ranks.any(seconds_since(checkpoint_time) >= c.checkpoint_interval));
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
  observer.available_memory = memory_of_machines(all_ranks);
  observer.ranks = ranks;
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
  return std::visit(
      [&](const auto& scenario)
      { return simulate(scenario, c, plan, results, monitor, before, results.take_checkpoint(), nullptr); },
      c.scenario);
}

namespace
{

/// A number that stands for a text; exact as a double.
double hash_of(std::string_view text)
{
  constexpr std::size_t exact = std::size_t{1} << 53U;
  return static_cast<double>(std::hash<std::string_view>{}(text) % exact);
}

} // namespace

double memory_of_machines(const Communicator& ranks)
{
  const double own = io::machine_memory();
  if (ranks.is_alone())
    return own;
  std::array<char, 256> name{};
  gethostname(name.data(), name.size() - 1);
  std::map<double, double> of_machines;
  const std::vector<double> names = ranks.all_values(hash_of(name.data())), memories = ranks.all_values(own);
  for (std::size_t rank = 0; rank < names.size(); ++rank)
    of_machines.try_emplace(names[rank], memories[rank]);
  double sum = 0.0;
  for (const auto& [machine, memory] : of_machines)
    sum += memory;
  return sum;
}

void require_shareable(const io::Case& c, int ranks)
{
  if (ranks == 1)
    return;
  std::string key;
  if (!c.output.points.empty())
    key = "output.points";
  if (c.accuracy)
    key = "solver.accuracy";
  for (const auto& [name, value] : c.values.all())
    if (name.find("fatigue") != std::string::npos)
      key = name;
  std::visit(
      [&](const auto& scenario)
      {
        for (const auto& [name, body] : {std::pair{"lower", &scenario.lower}, {"upper", &scenario.upper}})
          if (!body->inclusions.empty())
            key = fmt::format("{}.inclusion", name);
      },
      c.scenario);
  std::visit(
      [&](const auto& scenario)
      {
        using elastoplastic::DeviceChoice;
        if (const DeviceChoice device = scenario.solver.device;
            device == DeviceChoice::cuda || device == DeviceChoice::host)
          key = "solver.device";
      },
      c.scenario);
  if (!key.empty())
    throw InputError(
        fmt::format("{}: {} is not available where {} processes compute a case together; allowed: one process",
                    c.file.string(), key, ranks));
}

namespace
{

/// Processes that do not all do the same would wait for each other, or compute together what is the result of no case.
void require_same_case(const io::Case& c, const Communicator& ranks)
{
  const io::Versions versions = io::library_versions();
  const std::vector<double> cases =
      ranks.all_values(hash_of(io::resolved_files(c.values).text + versions.brinell + versions.git_hash));
  const auto other = std::find_if(cases.begin(), cases.end(), [&](double one) { return one != cases.front(); });
  if (other != cases.end())
    throw InputError(
        fmt::format("{}: process {} has another case than the first; allowed: the same files, settings and program for "
                    "all processes",
                    c.file.string(), other - cases.begin()));
}

/// Runs a case that ranks compute together. The first one opens the folder; if it cannot, no other one begins.
RunReport run_shared(const io::Case& c, const io::ScenarioPlan& plan, const RunOptions& options,
                     const RunMonitor& monitor)
{
  const Communicator& ranks = *options.ranks;
  require_same_case(c, ranks);
  const bool writes = ranks.rank() == 0;
  const io::StoredParts parts = io::stored_parts(c, plan);
  std::optional<io::ResultDirectory> directory;
  std::exception_ptr failure;
  bool is_refused = false;
  try
  {
    if (writes)
      directory.emplace(options.folder, c, parts, options.mode);
  }
  catch (const InputError&)
  {
    failure = std::current_exception();
    is_refused = true;
  }
  catch (...)
  {
    failure = std::current_exception();
  }
  const bool any_is_refused = ranks.any(is_refused), has_failed = ranks.any(failure != nullptr);
  if (failure)
    std::rethrow_exception(failure);
  constexpr const char* text = "the first rank cannot write its results";
  if (any_is_refused) // as the first one, since mpirun ends with the exit code of any of them
    throw InputError(text);
  if (has_failed)
    throw IoError(text);
  const std::optional<Archive::Fields> checkpoint =
      for_all(ranks, directory ? directory->take_checkpoint() : std::nullopt);
  if (monitor.on_start)
    monitor.on_start(directory && directory->replaced(), directory ? directory->finished_steps() : 0);
  const auto run = [&](auto& results)
  {
    return std::visit([&](const auto& scenario)
                      { return simulate(scenario, c, plan, results, monitor, {}, checkpoint, options.ranks).report; },
                      c.scenario);
  };
  if (directory)
    return run(*directory);
  FollowingResults following(parts);
  return run(following);
}

} // namespace

namespace
{

/// The case for the processor where the device that was found for `auto` has too little memory.
/// @throws InputError, DeviceError
std::optional<io::Case> passing_over_device(const io::Case& c, const io::ScenarioPlan& plan, bool is_shared)
{
  const auto& p = std::visit([](const auto& any) -> const simulation::Plan& { return any; }, plan);
  if (std::visit([&](const auto& scenario) { return simulation::has_device_room(p, scenario, is_shared); }, c.scenario))
    return std::nullopt;
  io::Case on_processor = c;
  std::visit([](auto& scenario) { scenario.solver.device = elastoplastic::DeviceChoice::cpu; }, on_processor.scenario);
  return on_processor;
}

} // namespace

std::string run_in_memory(const io::Case& c, int threads, const RunMonitor& monitor)
{
  if (c.accuracy)
    throw InputError("solver.accuracy requests a series of runs, which needs a folder for its results; allowed: a run "
                     "with a folder, or no solver.accuracy");
  const Threads guard(threads);
  const io::ScenarioPlan plan = io::plan_case(c);
  if (const auto on_processor = passing_over_device(c, plan, false))
    return run_in_memory(*on_processor, threads, monitor);
  io::ResultImage results(c, io::stored_parts(c, plan));
  std::visit([&](const auto& scenario)
             { (void)simulate(scenario, c, plan, results, monitor, {}, std::nullopt, nullptr); },
             c.scenario);
  return std::move(results).bytes();
}

RunReport run_case(const io::Case& c, const io::ScenarioPlan& plan, const RunOptions& options,
                   const RunMonitor& monitor)
{
  const Threads threads(options.threads);
  if (const auto on_processor = passing_over_device(c, plan, options.ranks && !options.ranks->is_alone()))
    return run_case(*on_processor, plan, options, monitor);
  if (options.ranks && !options.ranks->is_alone())
    return run_shared(c, plan, options, monitor);
  return c.accuracy ? run_series(c, plan, options, monitor)
                    : run_level(c, plan, options.folder, options.mode, monitor, {}).report;
}

} // namespace brinell::app
