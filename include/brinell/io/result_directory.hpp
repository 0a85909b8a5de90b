// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/archive.hpp"
#include "brinell/io/accuracy.hpp"
#include "brinell/io/history_csv.hpp"
#include "brinell/quality/quality.hpp"

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>

namespace brinell::io
{

/// Information about a finished run that the program has and the simulation does not.
struct RunInfo
{
  double wall_time = 0.0; ///< [s]
  int threads = 1;
  quality::Quality quality{};         ///< with the warnings of the case
  std::optional<Accuracy> accuracy{}; ///< of a series of runs with finer cells
};

/// The folder of a run, docs/reference/results-format.md. Even if the process is killed at any time, the finished steps can be
/// read and the run can be resumed from its last checkpoint.
class ResultDirectory
{
public:
  static constexpr bool keeps_checkpoints = true;
  static constexpr int passes_of_checkpoint =
      2; ///< how often `add_checkpoint` asks for the state: for its size, and to write it

  enum class Mode
  {
    replace, ///< an earlier result
    keep,    ///< an earlier result: it is an error
    resume   ///< the run that was stopped there
  };

  /// Creates the folder, locks it for this process, removes an earlier result (its summary first) and writes the files that are
  /// known before the first step. With `resume` it keeps the steps up to the checkpoint instead, if there is one.
  /// @throws IoError, also if another run is writing there; InputError if the run there is of another case or is complete, or if
  ///         there is one and it is to be kept
  /// @param parts  what is stored: `stored_parts` of the case
  ResultDirectory(const std::filesystem::path& path, const Case& c, StoredParts parts, Mode mode = Mode::replace);
  ResultDirectory(ResultDirectory&&) noexcept;
  ResultDirectory& operator=(ResultDirectory&&) noexcept;
  ~ResultDirectory();

  /// Whether an earlier result was removed.
  [[nodiscard]] bool replaced() const;
  /// The checkpoint to resume from; none from the second call on.
  [[nodiscard]] std::optional<Archive::Fields> take_checkpoint();
  /// Number of steps in the history; before the first step, those up to the checkpoint.
  [[nodiscard]] int finished_steps() const;

  /// Stores the row of a finished step.
  /// @throws IoError
  void add(const std::vector<NamedNumber>& columns);
  /// Stores the fields of a step, with the columns as attributes.
  /// @throws IoError
  void add(int step, const std::vector<NamedNumber>& columns, const simulation::StepFields& fields);
  /// Stores a row of the history of a point; only if the case has points.
  /// @throws IoError
  void add_point(const std::vector<NamedNumber>& row);
  /// Stores a checkpoint after the last step in the history, replacing the previous one.
  /// @throws IoError
  void add_checkpoint(const std::function<void(Archive&)>& state);

  /// Stores the fields after the last step.
  /// @throws IoError
  void add_final(const simulation::StepFields& final_state, const std::vector<NamedNumber>& last_columns);
  /// Completes the results: merges result.vtkhdf into one file, writes the summary last, and removes the checkpoint.
  /// @throws IoError
  void finish(const std::string& summary);

private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Computes the fields that a result stores, in the order in which it stores them, and drops them: what ranks that share bodies
/// do while the first of them writes.
/// @param words  those of `parts` for this state
void compute_fields(const simulation::StepFields& fields, const std::vector<std::string>& words,
                    const StoredParts& parts);

} // namespace brinell::io
