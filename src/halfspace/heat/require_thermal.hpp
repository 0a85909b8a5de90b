// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/error.hpp"
#include "brinell/foundation/grid.hpp"
#include "brinell/green/thermal_stack.hpp"
#include "brinell/halfspace/heat_response.hpp"

#include <cmath>
#include <cstddef>
#include <fmt/format.h>
#include <string>

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

/// Checks the constants and thicknesses of a stack.
/// @throws InputError with the name of the function and of the constant
inline void require_thermal(const char* function_name, const ThermalStack& stack)
{
  for (std::size_t n = 0; n < stack.layers.size(); ++n)
  {
    const std::string layer = fmt::format("{}: layer {}", function_name, n);
    require_thermal(layer.c_str(), stack.layers[n].thermal);
    if (!(stack.layers[n].thickness > 0.0) || std::isinf(stack.layers[n].thickness))
      throw InputError(fmt::format("{}: thickness = {}; allowed: a number above 0", layer, stack.layers[n].thickness));
  }
  require_thermal(function_name, stack.substrate);
}

/// @throws InputError if a flux whose sides of y = 0 are mirror images moves along y
inline void require_along_x(const char* function_name, const SurfaceGrid& grid, const HeatMotion& motion)
{
  if (grid.is_mirrored_y && motion.velocity_y != 0.0)
    throw InputError(fmt::format("{}: a flux that is symmetric in y moves along y at {} m/s; allowed: along x only",
                                 function_name, motion.velocity_y));
}

} // namespace brinell::halfspace
