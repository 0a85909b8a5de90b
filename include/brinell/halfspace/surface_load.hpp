// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

namespace brinell::halfspace
{

/// What acts on the surface of a body: one value per cell of the surface grid in each part; an empty part is zero.
///
/// The operators so far take no heat, and `SurfaceCompliance` the pressure alone. They refuse other parts by name, so that no
/// load is lost.
struct SurfaceLoad
{
  std::span<const double> pressure{};           ///< into the body [Pa]
  std::span<const double> shear_x{}, shear_y{}; ///< traction on the body along x and y [Pa]
  std::span<const double> heat{};               ///< flux into the body [W/m^2]
};

/// Where the displacement of a surface goes: one value per cell of the surface grid in each part; an empty part is not
/// wanted.
struct SurfaceDisplacement
{
  std::span<double> z{};      ///< into the body [m]
  std::span<double> x{}, y{}; ///< [m]
};

/// Which parts of a displacement shall be prepared.
enum class Displacements
{
  normal,  ///< z
  along_x, ///< z and x
  all
};

} // namespace brinell::halfspace
