// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace brinell
{

/// Constants of a body with isotropic heat conduction and thermal expansion.
struct Thermal
{
  double conductivity = 0.0;  ///< K [W/(m K)], > 0
  double density = 0.0;       ///< rho [kg/m^3], > 0
  double specific_heat = 0.0; ///< c [J/(kg K)], > 0
  double expansion = 0.0;     ///< alpha, linear [1/K]

  /// kappa = K/(rho c) [m^2/s].
  [[nodiscard]] double diffusivity() const { return conductivity / (density * specific_heat); }
  bool operator==(const Thermal&) const = default;
};

} // namespace brinell
