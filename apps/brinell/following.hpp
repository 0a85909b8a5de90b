// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/archive.hpp"
#include "brinell/foundation/communicator.hpp"
#include "brinell/io/result_directory.hpp"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace brinell::app
{

/// Results of a rank that does not write them: it takes part in what the first one does to have the fields of all.
class FollowingResults
{
public:
  static constexpr bool keeps_checkpoints = io::ResultDirectory::keeps_checkpoints;

  explicit FollowingResults(io::StoredParts parts) : parts_(std::move(parts)) {}

  void add(const std::vector<io::NamedNumber>& /*columns*/) {}
  void add_point(const std::vector<io::NamedNumber>& /*row*/) {}
  void add(int /*step*/, const std::vector<io::NamedNumber>& /*columns*/, const simulation::StepFields& fields)
  {
    io::compute_fields(fields, parts_.in_steps, parts_);
  }
  void add_final(const simulation::StepFields& fields, const std::vector<io::NamedNumber>& /*columns*/)
  {
    io::compute_fields(fields, parts_.in_final, parts_);
  }
  void add_checkpoint(const std::function<void(Archive&)>& state)
  {
    for (int time = 0; time < io::ResultDirectory::passes_of_checkpoint; ++time)
    {
      Archive nowhere([](const std::string&, std::span<const double>) {},
                      [](const std::string&, std::size_t, std::size_t, std::span<const double>) {});
      state(nowhere);
    }
  }
  void finish(const std::string& /*summary*/) {}

private:
  io::StoredParts parts_;
};

/// A checkpoint of the first rank for all. What it has left in its file is read by all ranks together, when they restore it.
[[nodiscard]] std::optional<Archive::Fields> for_all(const Communicator& ranks,
                                                     std::optional<Archive::Fields> checkpoint);

} // namespace brinell::app
