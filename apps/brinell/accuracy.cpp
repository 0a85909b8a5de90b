// SPDX-License-Identifier: BSD-3-Clause
#include "accuracy.hpp"

#include "brinell/foundation/error.hpp"
#include "brinell/io/feasibility.hpp"
#include "brinell/quality/quality.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fstream>
#include <iterator>
#include <numbers>
#include <optional>
#include <utility>

namespace brinell::app
{

namespace
{

namespace fs = std::filesystem;
using Mode = io::ResultDirectory::Mode;

constexpr double refinement =
    std::numbers::sqrt2;             ///< ratio of cell sizes between runs; each run of tugging costs four times as much
constexpr int most_runs = 5;         ///< down to half of the cell size of the case
constexpr double coarsest = 2.0;     ///< first cell size relative to that of the case
constexpr double fewest_cells = 2.0; ///< per contact radius in the first run; with fewer, no order of convergence shows
constexpr const char* subfolder = "accuracy";

std::string text_of(const fs::path& file)
{
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// Relative cell size of the first run of a series.
double first_cells(const io::Case& c, const io::ScenarioPlan& plan)
{
  const quality::Resolution resolution =
      std::visit([&]<typename ScenarioCase>(const ScenarioCase& scenario)
                 { return quality::expected(scenario, std::get<typename ScenarioCase::Plan>(plan)); },
                 c.scenario)
          .resolution;
  const double cells = resolution.cells_per_wave.value_or(resolution.cells);
  return std::clamp(cells / fewest_cells, 1.0, coarsest);
}

/// A run of the series that an earlier process with the same build has completed in its folder.
std::optional<io::Level> finished_level(const fs::path& folder, const io::Case& c, const io::ScenarioPlan& any_plan,
                                        double cells)
{
  const std::string summary = text_of(folder / "summary.json");
  if (summary.empty() || text_of(folder / "resolved.toml") != io::resolved_files(c.values).text)
    return std::nullopt;
  const simulation::Plan plan = std::visit([](const auto& one) -> simulation::Plan { return one; }, any_plan);
  std::optional<io::Level> level = io::level_of_this_build(summary, cells);
  if (level && level->spacing != io::Vector3{plan.contact.dx, plan.contact.dy, plan.lower.dz})
    level.reset();
  return level;
}

/// Whether to resume a run that was stopped in a folder, or to replace it.
Mode mode_in(const fs::path& folder, const io::Case& c, bool resume)
{
  const bool same = resume && text_of(folder / "resolved.toml") == io::resolved_files(c.values).text;
  return same && !fs::exists(folder / "summary.json") ? Mode::resume : Mode::replace;
}

/// The files of a run's folder, the summary last: until it is there, the run does not look complete.
constexpr const char* files_of_run[] = {"history.csv", "resolved.toml", "result.vtkhdf", "summary.json"};

void move_up(const fs::path& from, const fs::path& to)
{
  std::error_code error;
  for (const char* name : files_of_run)
  {
    fs::rename(from / name, to / name, error);
    if (error)
      throw IoError(fmt::format("{}: cannot be moved to {}: {}", (from / name).string(), to.string(), error.message()));
  }
  io::remove_resolved_maps(from); // the same maps are in the folder above
  fs::remove(from, error);        // fails if it contains other files, and then it is kept
}

/// Removes runs of an earlier series, which may have been longer.
void remove_level(const fs::path& folder)
{
  std::error_code error;
  if (!fs::exists(folder / "resolved.toml"))
    return;
  for (const char* name :
       {"summary.json", "history.csv", "points.csv", "result.vtkhdf", "checkpoint.h5", "resolved.toml"})
    fs::remove(folder / name, error);
  io::remove_resolved_maps(folder);
  fs::remove(folder, error);
}

class Series
{
public:
  Series(const io::Case& c, const io::ScenarioPlan& plan, const RunOptions& options, const RunMonitor& monitor)
      : case_(c), plan_(plan), options_(options), monitor_(monitor), first_cells_(first_cells(c, plan))
  {
  }

  RunReport run()
  {
    // Throws before anything is written if the case cannot be computed.
    for (const double cells : {1.0, first_cells_})
      static_cast<void>(io::plan_case(io::with_cells(case_, cells)));
    {
      // Locks the folder for this process and removes an earlier result; with --resume it refuses another case.
      const io::ResultDirectory folder(options_.folder, case_, io::stored_parts(case_, plan_), options_.mode);
      replaced_ = folder.replaced();
      levels();
    }
    for (int n = number_ + 1; n <= most_runs; ++n)
      remove_level(folder_of(n));
    move_up(folder_of(number_), options_.folder);
    return report_;
  }

private:
  [[nodiscard]] fs::path folder_of(int number) const { return options_.folder / subfolder / std::to_string(number); }

  void levels()
  {
    for (int n = 1; n <= most_runs; ++n)
    {
      const double cells = first_cells_ / std::pow(refinement, n - 1);
      const bool is_as_fine_as_given = cells <= 1.0 + 1e-9;
      if (!next(n, std::abs(cells - 1.0) < 1e-9 ? 1.0 : cells))
        return;
      number_ = n;
      if (n >= 3 && is_as_fine_as_given && accuracy_ && accuracy_->reached)
        return;
    }
  }

  /// @param wanted  relative size of the cells
  /// @returns false if a finer run is not possible, so that the previous one is the result
  bool next(int number, double wanted)
  {
    const bool resume = options_.mode == Mode::resume;
    const bool may_fail = number > 3 && wanted < 1.0; // the series has a result already
    try
    {
      const auto [cells, plan] = finer_plan(wanted);
      const io::Case c = io::with_cells(case_, cells);
      const LevelsBefore before{cells, done_};
      if (resume)
        if (const auto level = finished_level(folder_of(number), c, plan, cells); level && reuse(number, c, *level))
          return true;
      if (monitor_.on_level)
        monitor_.on_level(number, cells, false);
      RunMonitor monitor = monitor_;
      monitor.on_start = [&](bool, int finished_steps)
      {
        if (monitor_.on_start)
          monitor_.on_start(number == 1 && replaced_, finished_steps);
      };
      const LevelReport report =
          run_level(c, plan, folder_of(number), mode_in(folder_of(number), c, resume), monitor, before);
      report_ = report.report;
      accuracy_ = report.accuracy;
      done_.push_back(report.level);
      return true;
    }
    catch (const Interrupted&)
    {
      throw;
    }
    catch (const std::runtime_error& error)
    {
      if (!may_fail)
        throw;
      report_.warnings.push_back(
          {"accuracy_stopped", fmt::format("finer cells could not be computed: {}", error.what())});
      remove_level(folder_of(number));
      return false;
    }
  }

  /// Uses the numbers of a finished run, unless the series ends with it: the last run is repeated, because its summary has to
  /// contain the errors of the series.
  /// @returns whether the run was reused
  bool reuse(int number, const io::Case& c, const io::Level& level)
  {
    std::vector<io::Level> levels = done_;
    levels.push_back(level);
    std::optional<io::Accuracy> accuracy;
    if (levels.size() > 1)
      accuracy = io::accuracy_of(c, levels);
    const bool ends = number == most_runs || (number >= 3 && level.cells <= 1.0 + 1e-9 && accuracy->reached);
    if (ends)
      return false;
    if (monitor_.on_level)
      monitor_.on_level(number, level.cells, true);
    done_ = std::move(levels);
    accuracy_ = std::move(accuracy);
    return true;
  }

  /// Plan with cells of a relative size, or of one that is so much smaller that dx is less than in the previous run: where a way
  /// is only a few cells long, the cells that fit it are the same for a range of sizes.
  [[nodiscard]] std::pair<double, io::ScenarioPlan> finer_plan(double cells) const
  {
    constexpr double less = 0.95;
    const auto dx = [](const io::ScenarioPlan& any)
    { return std::visit([](const auto& plan) { return plan.contact.dx; }, any); };
    for (;; cells *= less)
      if (const io::ScenarioPlan plan = io::plan_case(io::with_cells(case_, cells));
          done_.empty() || dx(plan) < done_.back().spacing[0])
        return {cells, plan};
  }

  const io::Case& case_;
  const io::ScenarioPlan& plan_;
  const RunOptions& options_;
  const RunMonitor& monitor_;
  double first_cells_; ///< relative cell size of the first run
  bool replaced_ = false;
  int number_ = 0; ///< number of the last finished run
  std::vector<io::Level> done_;
  std::optional<io::Accuracy> accuracy_;
  RunReport report_;
};

} // namespace

void judge(const io::Case& c, const LevelsBefore& before, LevelReport& report, io::RunInfo& info)
{
  if (before.levels.empty())
    return;
  std::vector<io::Level> levels = before.levels;
  levels.push_back(report.level);
  report.accuracy = io::accuracy_of(c, std::move(levels));
  if (!report.accuracy->reached)
    info.quality.warnings.push_back(
        {"accuracy_missed",
         fmt::format(
             "the requested accuracy of {:.3g} % is not reached: the largest error of the key numbers is {}, {}",
             100.0 * report.accuracy->asked, quality::percent_text(report.accuracy->error),
             io::accuracy_advice(c, *report.accuracy))});
  io::take_measured_errors(*report.accuracy, info.quality.resolution);
  info.accuracy = report.accuracy;
}

RunReport run_series(const io::Case& c, const io::ScenarioPlan& plan, const RunOptions& options,
                     const RunMonitor& monitor)
{
  return Series(c, plan, options, monitor).run();
}

std::string accuracy_text(const io::Accuracy& a)
{
  std::string text =
      fmt::format("accuracy {:.3g} % {}: {} from {} runs\n{:<28} {:>13} {:>8} {:>6} {:>13}   {:>13} .. {:<13}\n",
                  100.0 * a.asked, a.reached ? "reached" : "not reached", quality::percent_text(a.error),
                  a.levels.size(), "number", "value", "error", "order", "extrapolated", "low", "high");
  for (const std::string& name : a.key_numbers)
  {
    const quality::Convergence& n = a.numbers.at(name);
    const auto number = [](double x, const char* form)
    { return std::isnan(x) ? "-" : fmt::format(fmt::runtime(form), x); };
    // The error refers to the largest number of the same unit, where this one is small beside it.
    const bool is_lost = n.low < 0.0 && n.high > 0.0 && n.relative_error > a.asked;
    text += fmt::format("{:<28} {:>13.6e} {:>8} {:>6} {:>13}   {:>13.6e} .. {:<13.6e}\n", name, n.value,
                        is_lost ? ">100 %" : quality::percent_text(n.relative_error), number(n.order, "{:.2g}"),
                        number(n.extrapolated, "{:.6e}"), n.low, n.high);
  }
  for (const std::string& name : a.key_numbers)
    if (const quality::Convergence& n = a.numbers.at(name); n.low < 0.0 && n.high > 0.0)
      text += fmt::format(
          "{}: the interval contains zero, so that these cells tell no more than its largest size, {:.3g}\n", name,
          std::max(-n.low, n.high));
  return text;
}

} // namespace brinell::app
