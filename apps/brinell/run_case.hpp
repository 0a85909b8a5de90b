// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/communicator.hpp"
#include "brinell/io/feasibility.hpp"
#include "brinell/io/result_directory.hpp"

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

/// Running a case, for the command line and for Python.
namespace brinell::app
{

/// Callbacks of a run; empty functions are skipped.
struct RunMonitor
{
  /// Called when the folder has been locked and its earlier content is known.
  std::function<void(bool replaced, int finished_steps)> on_start;
  /// @param step   counts from 0
  /// @param count  estimated number of all steps
  std::function<void(int step, int count, const std::string& where, int evaluations)> on_step;
  /// Reports an event as one line of text.
  std::function<void(const std::string& text)> on_remark;
  /// Asked between two evaluations. If it returns true the run ends with `Interrupted`: after the current step, with a
  /// checkpoint, or at once if the step takes more than a moment.
  std::function<bool()> wants_stop;
  /// Called in a series for an accuracy when the next run begins, or was taken over because it had been finished before.
  /// @param number  counts from 1
  /// @param cells   cell size relative to that of the case
  std::function<void(int number, double cells, bool taken_over)> on_level;
};

/// Report for the user at the end of a run.
struct RunReport
{
  std::string text;                    ///< some lines about the results
  std::vector<io::Warning> warnings{}; ///< as in the summary
};

struct RunOptions
{
  std::filesystem::path folder; ///< of the results
  io::ResultDirectory::Mode mode = io::ResultDirectory::Mode::replace;
  int threads = 0; ///< 0: as OpenMP decides
  /// Processes that compute the case together; nullptr: this process alone. The first one writes the results.
  std::shared_ptr<const Communicator> ranks{};
};

/// Memory of the machines on which the ranks are [bytes].
[[nodiscard]] double memory_of_machines(const Communicator& ranks);
/// @throws InputError if several ranks cannot compute the case
void require_shareable(const io::Case& c, int ranks);

/// Default folder of the results of a case.
[[nodiscard]] std::filesystem::path default_folder(const io::Case& c);

/// Runs a case, or a series of runs if an accuracy is requested, and writes the results.
/// @param plan  that of the case
/// @throws InputError, ConvergenceError, IoError, Interrupted; the finished steps are then in the folder
RunReport run_case(const io::Case& c, const io::ScenarioPlan& plan, const RunOptions& options,
                   const RunMonitor& monitor = {});

/// Runs a case without a folder.
/// @returns the bytes of a result.vtkhdf, without the group for ParaView
/// @throws as `run_case`; the finished steps are then lost
[[nodiscard]] std::string run_in_memory(const io::Case& c, int threads, const RunMonitor& monitor = {});

} // namespace brinell::app
