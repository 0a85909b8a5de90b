// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/error.hpp"
#include "brinell/foundation/grid.hpp"
#include "brinell/green/thermal.hpp"
#include "brinell/halfspace/heat_response.hpp"

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

/// @throws InputError if a flux whose sides of y = 0 are mirror images moves along y
inline void require_along_x(const char* function_name, const SurfaceGrid& grid, const HeatMotion& motion)
{
  if (grid.is_mirrored_y && motion.velocity_y != 0.0)
    throw InputError(fmt::format("{}: a flux that is symmetric in y moves along y at {} m/s; allowed: along x only",
                                 function_name, motion.velocity_y));
}

} // namespace brinell::halfspace
