// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/io/case_file.hpp"
#include "brinell/io/result_directory.hpp"

#include <string>

namespace brinell::io
{

/// Text of summary.json, docs/reference/results-format.md.
[[nodiscard]] std::string summary_text(const Case& c, const simulation::AnyPlan& plan,
                                       const simulation::AnySummary& summary, const RunInfo& info);

} // namespace brinell::io
