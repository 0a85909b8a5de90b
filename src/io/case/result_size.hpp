// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/io/feasibility.hpp"

#include <string>

namespace brinell::io
{

/// "1.5 GB", "12 MB"
[[nodiscard]] std::string size_text(double bytes);

/// Number of states whose fields are stored, the final one included.
[[nodiscard]] double stored_states(const Case& c, const ScenarioPlan& plan);

/// Line of `brinell check` about the size of the result.
[[nodiscard]] std::string result_report(const Case& c, const ScenarioPlan& plan);

} // namespace brinell::io
