// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/io/feasibility.hpp"

#include <string>

namespace brinell::io
{

/// "1.5 GB", "12 MB"
[[nodiscard]] std::string size_text(double bytes);

/// Number of states whose stress is computed for the output; histories of points count by the share of the layers above them.
[[nodiscard]] double states_within(const Case& c, const ScenarioPlan& plan);

/// Line of `brinell check` about the size of the result.
[[nodiscard]] std::string result_report(const Case& c, const ScenarioPlan& plan);

} // namespace brinell::io
