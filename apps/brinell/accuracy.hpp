// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/io/accuracy.hpp"
#include "run_case.hpp"

#include <filesystem>
#include <string>
#include <vector>

/// A case that is run with finer and finer cells until its numbers are close enough to their limits.
namespace brinell::app
{

/// The coarser runs of a series; none for a run by itself.
struct LevelsBefore
{
  double cells = 1.0; ///< size of the cells of the run at hand, over that of the case as given
  std::vector<io::Level> levels{};
};

/// What one run has come to.
struct LevelReport
{
  RunReport told;
  io::Level level;
  std::optional<io::Accuracy> accuracy{}; ///< of the series until then, from two runs on
};

/// One run, by itself or as part of a series.
[[nodiscard]] LevelReport run_level(const io::Case& c, const std::filesystem::path& folder,
                                    io::ResultDirectory::Mode mode, const RunMonitor& monitor,
                                    const LevelsBefore& before);

/// Puts what the series tells into the summary's information, with a warning if the accuracy asked for is not reached.
void judge(const io::Case& c, const LevelsBefore& before, LevelReport& report, io::RunInfo& info);

/// The series: the folder holds the finest run in the end, and the coarser ones in accuracy/1, accuracy/2, ...
[[nodiscard]] RunReport run_series(const io::Case& c, const RunOptions& options, const RunMonitor& monitor);

/// The table for a terminal.
[[nodiscard]] std::string accuracy_text(const io::Accuracy& accuracy);

} // namespace brinell::app
