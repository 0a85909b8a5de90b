// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>

namespace brinell
{

/// Stands for a number that there is not: null in JSON, nan in CSV.
inline constexpr double nan = std::numeric_limits<double>::quiet_NaN();

} // namespace brinell
