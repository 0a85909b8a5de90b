// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/halfspace/surface_load.hpp"
#include "foundation/require_size.hpp"

#include <fmt/format.h>

/// Checks of the arguments of operators on a surface.
namespace brinell::halfspace
{

/// Checks that a part is empty or has one value per cell.
/// @param part_name  e.g. "pressure"
/// @throws InternalError
inline void require_part(const char* function_name, const char* part_name, std::span<const double> part,
                         std::size_t cells)
{
  if (!part.empty() && part.size() != cells)
    require_size(fmt::format("{}: the {}", function_name, part_name).c_str(), part, cells);
}

/// Checks that a load has only parts that an operator supports, each empty or with one value per cell.
/// @param function_name  e.g. "HalfSpace::Loaded::stress"
/// @throws InputError if the load has an unsupported part, InternalError if a size is wrong
inline void require_load(const char* function_name, const SurfaceLoad& load, std::size_t cells)
{
  if (!load.heat.empty())
    throw InputError(
        fmt::format("{}: the load has {} values of heat, but this operator takes only pressure and shears; allowed: an "
                    "empty heat (ThermalResponse, ThermalField and SteadyField compute what a heat flux causes)",
                    function_name, load.heat.size()));
  require_part(function_name, "pressure", load.pressure, cells);
  require_part(function_name, "shear along x", load.shear_x, cells);
  require_part(function_name, "shear along y", load.shear_y, cells);
}

/// Checks that every requested part of a displacement has one value per cell, and that at least one part is requested.
/// @throws InternalError
inline void require_displacement(const char* function_name, const SurfaceDisplacement& displacement, std::size_t cells)
{
  const bool along_surface = !displacement.x.empty() || !displacement.y.empty();
  if (!along_surface && displacement.z.size() != cells)
    require_size(fmt::format("{}: the displacement", function_name).c_str(), displacement.z, cells);
  require_part(function_name, "displacement along z", displacement.z, cells);
  require_part(function_name, "displacement along x", displacement.x, cells);
  require_part(function_name, "displacement along y", displacement.y, cells);
}

} // namespace brinell::halfspace
