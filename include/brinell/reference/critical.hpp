// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace brinell::reference
{

/// First yield of a frictionless Hertz contact, in a point or along a line.
struct CriticalValues
{
  double C = 0.0;              ///< p0 / S_y at first yield
  double interference = 0.0;   ///< alpha_c [m]
  double load = 0.0;           ///< P_c [N]
  double energy = 0.0;         ///< U_c [J], elastic, the work of the load
  double contact_radius = 0.0; ///< a_c [m]; of a line its half-width
  double contact_area = 0.0;   ///< A_c = pi a_c^2, of a line 2 a_c L [m^2]
  double peak_pressure = 0.0;  ///< p0_c = C S_y [Pa]
};

/// C(nu) = 1.30075 + 0.87825 nu + 0.54373 nu^2 (Green 2005; paper Eq. 27), within 0.15 %. For nu < 0, where the fit
/// does not hold, the exact value: on the axis, or below nu = -0.31 at the edge of the contact.
[[nodiscard]] double critical_pressure_ratio(double poisson_ratio);

/// Critical values of spheres for equivalent radius [m], contact modulus E' [Pa] and C S_y [Pa] of the body that yields first
/// (paper Eqs. 24-26).
[[nodiscard]] CriticalValues critical_values(double radius, double contact_modulus, double C, double yield_stress);

/// Lengths that a plane-strain contact needs in addition.
struct Line
{
  double length = 0.0;    ///< L, length of the line to which loads and energies refer [m]
  double reference = 0.0; ///< l, reference distance of the approach, see line_contact_approach [m]
};

/// Critical values of cylinders in plane strain (Green 2005), with C of `line_contact_first_yield`:
///     a_c = 2 R p_c/E',   P_c = pi R p_c^2 L/E',   p_c = C S_y,
///     alpha_c = R (p_c/E')^2 (1 + 2 ln(2 l/a_c)),   U_c = pi R^2 p_c^4 L/(4 E'^3) (1 + 4 ln(2 l/a_c)).
/// With l = 2 R/e the brackets are Green's 2 ln(2 E'/p_c) - 1 and 4 ln(2 E'/p_c) - 3.
/// @throws InputError also if the reference is not more than a_c/2.
[[nodiscard]] CriticalValues critical_values(double radius, double contact_modulus, double C, double yield_stress,
                                             const Line& line);

} // namespace brinell::reference
