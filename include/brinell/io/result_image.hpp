// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/archive.hpp"
#include "brinell/io/case_file.hpp"
#include "brinell/io/history_csv.hpp"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace brinell::io
{

/// The results of a run in memory: the bytes of a result.vtkhdf that never was on a disk, for loops of small runs. What
/// `ResultDirectory` does, without what makes a run on a disk safe.
class ResultImage
{
public:
  static constexpr bool keeps_checkpoints = false;

  explicit ResultImage(const Case& c);
  ~ResultImage();
  ResultImage(ResultImage&&) noexcept;
  ResultImage& operator=(ResultImage&&) noexcept;

  /// None: nothing can be resumed.
  [[nodiscard]] static std::optional<Archive::Fields> take_checkpoint() { return std::nullopt; }
  void add_checkpoint(int, const std::function<void(Archive&)>&) {}

  /// A row of the history.
  void add(const std::vector<NamedNumber>& columns);
  /// The fields of a step.
  void add(int step, const std::vector<NamedNumber>& columns, const simulation::StepFields& fields);
  void add_final(const simulation::StepFields& final_state, const std::vector<NamedNumber>& last_columns);
  void finish(const std::string& summary);

  /// The bytes of the file. @throws IoError (all members)
  [[nodiscard]] std::string bytes() &&;

private:
  struct State;
  std::unique_ptr<State> state_;
};

} // namespace brinell::io
