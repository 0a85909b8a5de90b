// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/io/case_file.hpp"
#include "brinell/io/result_directory.hpp"

#include <string>

namespace brinell::io
{

/// Text of summary.json, docs/reference/results-format.md.
[[nodiscard]] std::string summary_text(const Case& c, const simulation::TuggingPlan& plan,
                                       const simulation::TuggingSummary& summary, const RunInfo& info);
[[nodiscard]] std::string summary_text(const Case& c, const simulation::IndentationPlan& plan,
                                       const simulation::IndentationSummary& summary, const RunInfo& info);
[[nodiscard]] std::string summary_text(const Case& c, const simulation::RollingPlan& plan,
                                       const simulation::RollingSummary& summary, const RunInfo& info);

} // namespace brinell::io
