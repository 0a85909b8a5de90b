// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/host_device.hpp"

#include <cmath>

namespace brinell
{

/// The larger of two values; NaN if either is NaN.
[[nodiscard]] BRINELL_HOST_DEVICE inline double larger(double a, double b)
{
  return b <= a || std::isnan(a) ? a : b;
}

} // namespace brinell
