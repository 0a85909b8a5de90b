// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

namespace brinell::halfspace
{

/// Load on the surface of a body: in each part one value per cell of the surface grid; an empty part is zero.
///
/// The elastic operators do not accept heat: the effects of a heat flux are computed by `HeatResponse`, `ThermalResponse`,
/// `SurfaceTemperature`, `ThermalField` and `SteadyField`. `SurfaceCompliance` accepts only the pressure. Operators reject
/// unsupported parts with an error that names the part, so that no load is silently ignored.
struct SurfaceLoad
{
  std::span<const double> pressure{};           ///< into the body [Pa]
  std::span<const double> shear_x{}, shear_y{}; ///< traction on the body along x and y [Pa]
  std::span<const double> heat{};               ///< flux into the body [W/m^2]
};

/// Output spans for the displacement of a surface: in each part one value per cell of the surface grid; an empty part is not
/// computed.
struct SurfaceDisplacement
{
  std::span<double> z{};      ///< into the body [m]
  std::span<double> x{}, y{}; ///< [m]
};

/// Components of a displacement that are to be prepared.
enum class Displacements
{
  normal,  ///< z
  along_x, ///< z and x
  all
};

} // namespace brinell::halfspace
