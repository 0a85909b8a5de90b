// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/io/case_file.hpp"
#include "raw_case.hpp"

namespace brinell::io
{

/// Compares what is given with the schema: conditions, exclusions, types, units, ranges; fills in the defaults.
/// What is wrong goes into `problems`; if there are any, the values are incomplete.
[[nodiscard]] CaseValues resolved_values(const RawCase& raw_case, Problems& problems);

} // namespace brinell::io
