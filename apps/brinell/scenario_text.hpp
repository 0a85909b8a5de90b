// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/io/case_file.hpp"

#include <string>

/// What the program prints of each scenario.
namespace brinell::app
{

/// Where a step was, for the progress.
[[nodiscard]] std::string step_text(const io::Case& c, const simulation::TuggingRecord& record);
[[nodiscard]] std::string step_text(const io::Case& c, const simulation::IndentationRecord& record);
[[nodiscard]] std::string step_text(const io::Case& c, const simulation::RollingRecord& record);

/// Key results, several lines.
[[nodiscard]] std::string summary_text(const io::Case& c, const simulation::TuggingSummary& summary);
[[nodiscard]] std::string summary_text(const io::Case& c, const simulation::IndentationSummary& summary);
[[nodiscard]] std::string summary_text(const io::Case& c, const simulation::RollingSummary& summary);

} // namespace brinell::app
