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

/// The results of a run in memory: the bytes of a result.vtkhdf, for loops of many small runs. It has the interface of
/// `ResultDirectory`, without checkpoints.
class ResultImage
{
public:
  static constexpr bool keeps_checkpoints = false;

  /// @param parts  what is stored: `stored_parts` of the case
  ResultImage(const Case& c, StoredParts parts);
  ~ResultImage();
  ResultImage(ResultImage&&) noexcept;
  ResultImage& operator=(ResultImage&&) noexcept;

  /// Always none: such a run cannot be resumed.
  [[nodiscard]] static std::optional<Archive::Fields> take_checkpoint() { return std::nullopt; }
  void add_checkpoint(const std::function<void(Archive&)>&) {}

  /// Stores a row of the history.
  void add(const std::vector<NamedNumber>& columns);
  /// Stores the fields of a step.
  void add(int step, const std::vector<NamedNumber>& columns, const simulation::StepFields& fields);
  /// Stores a row of the history of a point.
  void add_point(const std::vector<NamedNumber>& row);
  void add_final(const simulation::StepFields& final_state, const std::vector<NamedNumber>& last_columns);
  void finish(const std::string& summary);

  /// The bytes of the file.
  /// @throws IoError (all members)
  [[nodiscard]] std::string bytes() &&;

private:
  struct State;
  std::unique_ptr<State> state_;
};

} // namespace brinell::io
