// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/io/case_file.hpp"

#include <string>

/// Texts that the program prints about a run.
namespace brinell::io
{

/// Position of a step in the motion, for the progress display.
[[nodiscard]] std::string step_text(const Case& c, const simulation::AnyRecord& record);

/// Key results, several lines.
[[nodiscard]] std::string results_text(const Case& c, const simulation::AnySummary& summary);

} // namespace brinell::io
