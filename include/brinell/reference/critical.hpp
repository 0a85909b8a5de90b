// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace brinell::reference
{

/// First yield of a frictionless Hertz point contact.
struct CriticalValues
{
  double C = 0.0;              ///< p0 / S_y at first yield, Green (2005) fit, paper Eq. 27
  double interference = 0.0;   ///< alpha_c [m], Eq. 24
  double load = 0.0;           ///< P_c [N], Eq. 25
  double energy = 0.0;         ///< U_c [J], Eq. 26
  double contact_radius = 0.0; ///< a_c [m]
  double peak_pressure = 0.0;  ///< p0_c = C S_y [Pa]
};

/// C(nu) = 1.30075 + 0.87825 nu + 0.54373 nu^2 (Green 2005; paper Eq. 27).
[[nodiscard]] double critical_pressure_ratio(double poisson_ratio);

/// Critical values for equivalent radius [m], contact modulus E' [Pa] and C S_y [Pa] of the body that yields first.
[[nodiscard]] CriticalValues critical_values(double radius, double contact_modulus, double C, double yield_stress);

} // namespace brinell::reference
