// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/io/case_file.hpp"

#include <string>

/// What the program prints of a run.
namespace brinell::io
{

/// Where a step was, for the progress.
[[nodiscard]] std::string step_text(const Case& c, const simulation::AnyRecord& record);

/// Key results, several lines.
[[nodiscard]] std::string results_text(const Case& c, const simulation::AnySummary& summary);

} // namespace brinell::io
