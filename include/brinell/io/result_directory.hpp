// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/io/case_file.hpp"
#include "brinell/simulation/tugging.hpp"

#include <filesystem>
#include <memory>

namespace brinell::io
{

/// What the program knows of a finished run and the simulation does not.
struct RunInfo
{
  double wall_time = 0.0; ///< [s]
  int threads = 1;
};

/// The folder of a run, docs/reference/results-format.md. Whenever the process ends, the finished steps can be read.
class ResultDirectory
{
public:
  /// Makes the folder, takes it for this process, removes an earlier result (its summary first) and writes what is known
  /// before the first step.
  /// @throws IoError; also if another run is writing there
  ResultDirectory(const std::filesystem::path& path, const Case& c);
  ResultDirectory(ResultDirectory&&) noexcept;
  ResultDirectory& operator=(ResultDirectory&&) noexcept;
  ~ResultDirectory();

  /// Whether an earlier result was removed.
  [[nodiscard]] bool replaced() const;

  /// A finished step. @throws IoError
  void add(const simulation::StepRecord& record);
  /// The fields of a finished step. @throws IoError
  void add(const simulation::Snapshot& snapshot);

  /// Final state, result.h5 in one piece and, last of all, the summary. @throws IoError
  void finish(const simulation::TuggingPlan& plan, const simulation::TuggingSummary& summary, const RunInfo& info);

  /// result.h5 in one piece for a run that was stopped; no summary. @throws IoError
  void stop();

private:
  struct State;
  std::unique_ptr<State> m_state;
};

/// Replaces a file in one piece: readers see the old text or the new one. @throws IoError
void replace_file(const std::filesystem::path& path, const std::string& text);

} // namespace brinell::io
