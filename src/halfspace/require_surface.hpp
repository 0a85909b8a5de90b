// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/halfspace/surface_load.hpp"
#include "foundation/require_size.hpp"

#include <fmt/format.h>

/// The checks at the doors of the operators.
namespace brinell::halfspace
{

/// That a load has the parts that an operator can compute, with a value per cell or none.
/// @param function_name  "HalfSpace::Loaded::stress"
/// @throws InputError if it has others, InternalError if a size is wrong
inline void require_load(const char* function_name, const SurfaceLoad& load, std::size_t cells)
{
  if (!load.shear_x.empty() || !load.shear_y.empty() || !load.heat.empty())
    throw InputError(
        fmt::format("{}: shear and heat on the surface are not computed yet; allowed: pressure alone", function_name));
  if (!load.pressure.empty() && load.pressure.size() != cells)
    require_size(fmt::format("{}: the pressure", function_name).c_str(), load.pressure, cells);
}

/// That no part of a displacement is asked for that an operator does not have.
inline void require_displacement(const char* function_name, const SurfaceDisplacement& displacement, std::size_t cells)
{
  if (!displacement.x.empty() || !displacement.y.empty())
    throw InputError(
        fmt::format("{}: displacements along the surface are not computed yet; allowed: z alone", function_name));
  if (displacement.z.size() != cells)
    require_size(fmt::format("{}: the displacement", function_name).c_str(), displacement.z, cells);
}

} // namespace brinell::halfspace
