// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

namespace brinell::green
{

/// a asinh(b/|a|), continued by zero to a = 0: the corner terms of Love's integral over a rectangle.
[[nodiscard]] inline double scaled_asinh(double a, double b)
{
  return a == 0.0 ? 0.0 : a * std::asinh(b / std::abs(a));
}

} // namespace brinell::green
