// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/io/case_file.hpp"
#include "brinell/io/result_directory.hpp"

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

/// One way to run a case, for the command line and for Python.
namespace brinell::app
{

/// Who watches a run; empty functions are skipped.
struct RunMonitor
{
  /// The folder is taken and what was there is known.
  std::function<void(bool replaced, int finished_steps)> on_start;
  /// @param step   counts from 0
  /// @param count  of all steps, an estimate
  std::function<void(int step, int count, const std::string& where, int evaluations)> on_step;
  /// Something happened that is worth a line.
  std::function<void(const std::string& text)> on_remark;
  /// Asked between two evaluations. The run then ends with `Interrupted`: after the step, with a checkpoint, if that takes no
  /// longer than a moment; else at once.
  std::function<bool()> wants_stop;
  /// Of a series for an accuracy: the next run begins, or was taken over as it had been finished before.
  /// @param number  counts from 1
  /// @param cells   their size, over that of the case
  std::function<void(int number, double cells, bool taken_over)> on_level;
};

/// For the user, at the end of a run.
struct RunReport
{
  std::string text;                    ///< some lines about what came out
  std::vector<io::Warning> warnings{}; ///< as in the summary
};

struct RunOptions
{
  std::filesystem::path folder; ///< of the results
  io::ResultDirectory::Mode mode = io::ResultDirectory::Mode::replace;
  int threads = 0; ///< 0: as OpenMP decides
};

/// Where the results of a case go if nobody says otherwise.
[[nodiscard]] std::filesystem::path default_folder(const io::Case& c);

/// Runs a case and writes its results; with an accuracy asked for, a series of it.
/// @throws InputError, ConvergenceError, IoError, Interrupted; the finished steps are in the folder then
RunReport run_case(const io::Case& c, const RunOptions& options, const RunMonitor& monitor = {});

/// Runs a case without a folder.
/// @returns the bytes of a result.vtkhdf, without what is for ParaView
/// @throws as `run_case`; the finished steps are lost then
[[nodiscard]] std::string run_in_memory(const io::Case& c, int threads, const RunMonitor& monitor = {});

} // namespace brinell::app
