// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/sym_tensor.hpp"

/// Closed-form solutions to compare computations with.
namespace brinell::reference
{

/// Hertz contact of two spheres, or of any surfaces with one relative curvature 1/R.
struct PointContact
{
  double load = 0.0;           ///< P = 4/3 E' sqrt(R) approach^1.5 [N]
  double approach = 0.0;       ///< of distant points, a^2/R [m]
  double contact_radius = 0.0; ///< a [m]
  double peak_pressure = 0.0;  ///< p0 = 3 P/(2 pi a^2) [Pa]; p = p0 sqrt(1 - r^2/a^2)
};

/// Point contact under a load (Hertz 1882; Johnson 1985, Eqs. 4.22-4.24).
/// @param radius           equivalent radius R, 1/R = 1/R1 + 1/R2 [m], > 0.
/// @param contact_modulus  E', 1/E' = sum of (1 - nu^2)/E [Pa], > 0.
/// @param load             [N], >= 0, compressive.
/// @throws InputError
[[nodiscard]] PointContact point_contact_at_load(double radius, double contact_modulus, double load);

/// Point contact at a given approach [m], >= 0.
/// @throws InputError
[[nodiscard]] PointContact point_contact_at_approach(double radius, double contact_modulus, double approach);

/// Hertz contact with an elliptical area.
struct EllipticalContact
{
  double load = 0.0;          ///< P = 2/3 pi a b p0 [N]
  double approach = 0.0;      ///< [m]
  double semi_axis_x = 0.0;   ///< [m]
  double semi_axis_y = 0.0;   ///< [m]
  double peak_pressure = 0.0; ///< p0 [Pa]; p = p0 sqrt(1 - x^2/a_x^2 - y^2/a_y^2)
};

/// Elliptical contact under a load (Hertz 1882; Johnson 1985, Eqs. 4.26-4.33).
/// @param radius_x, radius_y  radii of relative curvature: the undeformed gap is x^2/(2 R_x) + y^2/(2 R_y) [m], > 0.
/// @param contact_modulus     E' [Pa], > 0.
/// @param load                [N], >= 0.
/// @throws InputError
[[nodiscard]] EllipticalContact elliptical_contact_at_load(double radius_x, double radius_y, double contact_modulus,
                                                           double load);

/// Elliptical contact at a given approach [m], >= 0.
/// @throws InputError
[[nodiscard]] EllipticalContact elliptical_contact_at_approach(double radius_x, double radius_y, double contact_modulus,
                                                               double approach);

/// Stress under the pressure p0 sqrt(1 - r^2/a^2) on the circle r < a [Pa], tension positive, in Cartesian components
/// (Huber 1904; Hamilton 1983 without friction). In units of a, with oblate spheroidal coordinates
/// z = xi eta, r^2 = (1 + xi^2)(1 - eta^2), and per p0,
///     sigma_zz = -eta^3/(xi^2 + eta^2)                    sigma_rz = -r xi eta^2/((xi^2 + eta^2)(1 + xi^2))
///     sigma_rr =  q + eta^3/(xi^2 + eta^2) + eta ((1 - nu) xi^2/(1 + xi^2) + (1 + nu) xi acot(xi) - 2)
///     sigma_tt = -q - eta (2 nu + (1 - nu) xi^2/(1 + xi^2) - (1 + nu) xi acot(xi))
///     q = (1 - 2 nu)/3 (1 + eta + eta^2)/((1 + xi^2)(1 + eta)).
/// @param x, y, z         point, the contact's centre at the origin [m], z >= 0 into the body.
/// @param contact_radius  a [m], > 0.
/// @param peak_pressure   p0 [Pa].
[[nodiscard]] SymTensor point_contact_stress(double x, double y, double z, double contact_radius, double peak_pressure,
                                             double poisson_ratio);

/// Hertz contact along a line (y), plane strain. Its approach depends on the bodies' size: `line_contact_approach`.
struct LineContact
{
  double load_per_length = 0.0; ///< W [N/m]
  double half_width = 0.0;      ///< a = sqrt(4 W R/(pi E')) [m]
  double peak_pressure = 0.0;   ///< p0 = 2 W/(pi a) [Pa]; p = p0 sqrt(1 - x^2/a^2)
};

/// Line contact under a load (Hertz 1882; Johnson 1985, Eqs. 4.43-4.45).
/// @param radius           equivalent radius R [m], > 0.
/// @param contact_modulus  E' [Pa], > 0.
/// @param load_per_length  [N/m], >= 0.
/// @throws InputError
[[nodiscard]] LineContact line_contact_at_load(double radius, double contact_modulus, double load_per_length);

/// Approach of a line contact [m]. In plane strain displacements diverge logarithmically with distance; here the displacement of
/// each body is taken as zero at the distance l from a line load, u = 2 (1 - nu^2)/(pi E) W ln(l/r) (Johnson 1985, Eq. 2.19), so
/// that
///     approach = W/(pi E') (1 + 2 ln(2 l/a)).
/// With l = 2 R/e this is the approach of Green (2005), W/(pi E') (ln(4 pi E' R/W) - 1), that of the axis of a cylinder of radius
/// R and a rigid flat (Johnson 1985, Eq. 5.56).
/// @param reference  l [m], > a/2: there the approach is largest.
/// @throws InputError
[[nodiscard]] double line_contact_approach(const LineContact& contact, double contact_modulus, double reference);

/// Work of the load per length, the integral of W d approach [J/m]: W^2/(4 pi E') (1 + 4 ln(2 l/a)).
/// @throws InputError as `line_contact_approach`
[[nodiscard]] double line_contact_work(const LineContact& contact, double contact_modulus, double reference);

/// The line contact with that approach [m], >= 0.
/// @param reference  l [m], > 0.
/// @throws InputError also if the approach is larger than l^2/R, which no load reaches.
[[nodiscard]] LineContact line_contact_at_approach(double radius, double contact_modulus, double approach,
                                                   double reference);

/// Stress under the pressure p0 sqrt(1 - x^2/a^2) on the strip |x| < a in plane strain [Pa], tension positive (McEwen 1949;
/// Johnson 1985, Eqs. 4.49). In units of a, with z = xi eta, x^2 = (1 + xi^2)(1 - eta^2), c = sqrt(1 + xi^2), and per p0,
///     sigma_zz = -c eta^3/(xi^2 + eta^2)          sigma_xz = -x xi eta^2/((xi^2 + eta^2) c)
///     sigma_xx = -2 eta/(c + xi) - sigma_zz       sigma_yy = nu (sigma_xx + sigma_zz)
/// @param x, z           point, the contact's middle at the origin [m], z >= 0 into the body.
/// @param half_width     a [m], > 0.
/// @param peak_pressure  p0 [Pa].
[[nodiscard]] SymTensor line_contact_stress(double x, double z, double half_width, double peak_pressure,
                                            double poisson_ratio);

/// Where a frictionless contact yields first.
struct FirstYield
{
  double pressure_ratio = 0.0; ///< C = p0/S_y = p0/(largest von Mises stress) [-]
  double depth_ratio = 0.0;    ///< depth over contact radius, or half-width of a line contact [-]
};

/// First yield by von Mises of a point contact, exact: on the axis, the largest of
///     sigma_vm/p0 = 3/2/(1 + s^2) - (1 + nu)(1 - s acot(s)),   s = z/a,
/// or, for nu below about -0.31, at the edge of the contact, where the stresses along the surface are +-(1 - 2 nu) p0/3:
///     sigma_vm/p0 = (1 - 2 nu)/sqrt(3)
/// (Johnson 1985, section 3.4). Green's fit `critical_pressure_ratio` is within 0.15 % of C for nu >= 0.
/// @param poisson_ratio  (-1, 0.5].
/// @throws InputError
[[nodiscard]] FirstYield first_yield(double poisson_ratio);

/// First yield by von Mises of a line contact in plane strain, exact. On the axis, where the stress is largest,
///     sigma_vm/p0 = sqrt((1 - T)/(1 + T) ((1 - 2 nu)^2 + 3 T^2)),   T = s/sqrt(1 + s^2),   s = z/a,
/// has its peak below the surface where T^3 + T^2 - T + (1 - 2 nu)^2/3 = 0. Up to nu = (1 - sqrt(3/8))/2 = 0.1938 the surface
/// yields first, at sigma_vm = (1 - 2 nu) p0. Green's (2005) fit, C = 1.164 + 2.975 nu - 2.906 nu^2 above this nu and
/// C = 1/(1 - 2 nu) below it, is within 0.15 % of C.
/// @param poisson_ratio  (-1, 0.5].
/// @throws InputError
[[nodiscard]] FirstYield line_contact_first_yield(double poisson_ratio);

} // namespace brinell::reference
