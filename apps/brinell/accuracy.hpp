// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/io/accuracy.hpp"
#include "run_case.hpp"

#include <filesystem>
#include <string>
#include <vector>

/// A series of runs of a case with successively finer cells, until the estimated error of its numbers is small enough.
namespace brinell::app
{

/// The coarser runs of a series; empty for a single run.
struct LevelsBefore
{
  double cells = 1.0; ///< cell size of the current run relative to that of the case as given
  std::vector<io::Level> levels{};
};

/// Result of one run.
struct LevelReport
{
  RunReport report;
  io::Level level;
  std::optional<io::Accuracy> accuracy{}; ///< of the series up to this run; none after the first run
};

/// Function that performs one run, single or as part of a series.
[[nodiscard]] LevelReport run_level(const io::Case& c, const io::ScenarioPlan& plan,
                                    const std::filesystem::path& folder, io::ResultDirectory::Mode mode,
                                    const RunMonitor& monitor, const LevelsBefore& before);

/// Adds the estimated errors of the series to the information for the summary, with a warning if the requested accuracy is not
/// reached.
void judge(const io::Case& c, const LevelsBefore& before, LevelReport& report, io::RunInfo& info);

/// Runs the series of a case with this plan. At the end the folder contains the finest run, and the coarser ones in accuracy/1, accuracy/2, ...
[[nodiscard]] RunReport run_series(const io::Case& c, const io::ScenarioPlan& plan, const RunOptions& options,
                                   const RunMonitor& monitor);

/// The errors as a table for a terminal.
[[nodiscard]] std::string accuracy_text(const io::Accuracy& accuracy);

} // namespace brinell::app
