// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/sym_tensor.hpp"

/// Elastic sliding contacts: stress due to the shear, to be added to that of Hertz' pressure, and first yield under both
/// together.
namespace brinell::reference
{

/// Stress under the shear q0 sqrt(1 - r^2/a^2) along x on the circle r < a [Pa], tension positive, in Cartesian components
/// (Hamilton 1983; here from Cerruti's potentials, see the source). It is added to that of the pressure,
/// `point_contact_stress`. On the circle itself
///     sigma_xx = -pi q0 (4 + nu) x/(8 a),   sigma_yy = -3 pi q0 nu x/(8 a),   sigma_xz = -q0 sqrt(1 - r^2/a^2).
/// Accurate to rounding, except within a millionth of the radius around the rim, where the error is up to 1e-7 q0.
/// @param x, y, z         point, the contact's centre at the origin [m], z >= 0 into the body.
/// @param contact_radius  a [m], > 0.
/// @param peak_shear      q0 [Pa], on the body towards +x.
[[nodiscard]] SymTensor point_contact_shear_stress(double x, double y, double z, double contact_radius,
                                                   double peak_shear, double poisson_ratio);

/// Stress under the shear q0 sqrt(1 - x^2/a^2) along x on the strip |x| < a in plane strain [Pa], tension positive (McEwen 1949;
/// Johnson 1985, Eqs. 7.8). In units of a, with z = xi eta, x^2 = (1 + xi^2)(1 - eta^2), c = sqrt(1 + xi^2), and per q0,
///     sigma_zz = sigma_xz of the pressure         sigma_xz = sigma_xx of the pressure
///     sigma_xx = -2 x/(c (c + xi)) - sigma_zz     sigma_yy = nu (sigma_xx + sigma_zz)
/// @param x, z        point, the contact's middle at the origin [m], z >= 0 into the body.
/// @param half_width  a [m], > 0.
/// @param peak_shear  q0 [Pa], on the body towards +x.
[[nodiscard]] SymTensor line_contact_shear_stress(double x, double z, double half_width, double peak_shear,
                                                  double poisson_ratio);

/// Stress under Hertz' pressure and the shear friction x pressure along x, of a point contact and of a line contact [Pa].
/// @param friction  shear on the body towards +x over the pressure; below 0 towards -x; 0 gives `point_contact_stress`.
[[nodiscard]] SymTensor sliding_point_contact_stress(double x, double y, double z, double contact_radius,
                                                     double peak_pressure, double poisson_ratio, double friction);
[[nodiscard]] SymTensor sliding_line_contact_stress(double x, double z, double half_width, double peak_pressure,
                                                    double poisson_ratio, double friction);

/// Where a sliding contact yields first, in the plane y = 0.
struct SlidingYield
{
  double pressure_ratio = 0.0; ///< C = p0/S_y = p0/(largest von Mises stress) [-]
  double x_ratio = 0.0;        ///< x over contact radius, or half-width; the shear on the body points towards +x [-]
  double depth_ratio = 0.0;    ///< depth over the same [-]
};

/// First yield by von Mises of a point contact with the shear friction x pressure, by search over the stress.
/// @param poisson_ratio  (-1, 0.5].
/// @param friction       >= 0; 0 gives `first_yield`.
/// @throws InputError
[[nodiscard]] SlidingYield sliding_first_yield(double poisson_ratio, double friction);

/// First yield of a sliding line contact in plane strain.
/// @param poisson_ratio  (-1, 0.5].
/// @throws InputError
[[nodiscard]] SlidingYield line_sliding_first_yield(double poisson_ratio, double friction);

} // namespace brinell::reference
