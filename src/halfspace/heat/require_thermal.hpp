// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/error.hpp"
#include "brinell/green/thermal.hpp"

#include <cmath>
#include <fmt/format.h>

namespace brinell::halfspace
{

/// Checks that the constants of heat conduction are positive and finite.
/// @throws InputError with the name of the function and of the constant
inline void require_thermal(const char* function_name, const Thermal& thermal)
{
  const auto require = [&](const char* name, double value)
  {
    if (!(value > 0.0) || std::isinf(value))
      throw InputError(fmt::format("{}: {} = {}; allowed: a number above 0", function_name, name, value));
  };
  require("conductivity", thermal.conductivity);
  require("density", thermal.density);
  require("specific_heat", thermal.specific_heat);
}

} // namespace brinell::halfspace
