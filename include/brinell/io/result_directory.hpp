// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/archive.hpp"
#include "brinell/io/accuracy.hpp"
#include "brinell/io/history_csv.hpp"

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>

namespace brinell::io
{

/// What the program knows of a finished run and the simulation does not.
struct RunInfo
{
  double wall_time = 0.0; ///< [s]
  int threads = 1;
  simulation::Quality quality{};      ///< with the warnings of the case
  std::optional<Accuracy> accuracy{}; ///< of a series of finer and finer cells
};

/// The folder of a run, docs/reference/results-format.md. Whenever the process ends, the finished steps can be read, and the
/// run can go on from its last checkpoint.
class ResultDirectory
{
public:
  static constexpr bool keeps_checkpoints = true;

  enum class Mode
  {
    replace, ///< an earlier result
    resume   ///< the run that was stopped there
  };

  /// Makes the folder, takes it for this process, removes an earlier result (its summary first) and writes what is known
  /// before the first step. With `resume` it keeps what was finished at the checkpoint instead, if there is one.
  /// @throws IoError, also if another run is writing there; InputError if the run there is of another case or is complete
  ResultDirectory(const std::filesystem::path& path, const Case& c, Mode mode = Mode::replace);
  ResultDirectory(ResultDirectory&&) noexcept;
  ResultDirectory& operator=(ResultDirectory&&) noexcept;
  ~ResultDirectory();

  /// Whether an earlier result was removed.
  [[nodiscard]] bool replaced() const;
  /// The state to go on from; none from the second call on.
  [[nodiscard]] std::optional<Archive::Fields> take_checkpoint();
  /// Steps that were finished there; 0 without one.
  [[nodiscard]] int finished_steps() const;

  /// A finished step. @throws IoError
  void add(const std::vector<NamedNumber>& columns);
  /// Its fields, with the columns as attributes. @throws IoError
  void add(int step, const std::vector<NamedNumber>& columns, const simulation::StepFields& fields);
  /// The state after a step, replacing the one before. @throws IoError
  void add_checkpoint(int step, const std::function<void(Archive&)>& state);

  /// The state after the last step. @throws IoError
  void add_final(const simulation::StepFields& final_state, const std::vector<NamedNumber>& last_columns);
  /// result.vtkhdf in one piece and, last of all, the summary; the checkpoint goes. @throws IoError
  void finish(const std::string& summary);

private:
  struct State;
  std::unique_ptr<State> state_;
};

} // namespace brinell::io
