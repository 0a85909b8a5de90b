// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/sym_tensor.hpp"
#include "brinell/green/traction.hpp"

/// Influence coefficients of plane and antiplane strain: a uniform traction on a strip of the surface that is infinite along y.
///
/// As for a rectangle, the value is the difference of an antiderivative at the two edges, f(x) = G(x + dx/2) - G(x - dx/2).
namespace brinell::green
{

/// Antiderivative of -2 ln(|X| / reference) [m]: the integral of 1/r along an infinite line diverges, and is taken relative to
/// its value at the distance `reference` from the line (Johnson 1985, section 2.3).
/// @param X  point minus edge [m], any sign or zero.
[[nodiscard]] double strip_displacement_edge(double X, double reference);

/// Antiderivative of the stress under a unit traction [-]; for a pressure (Johnson 1985, Eqs. 2.31):
///     xx = -(phi - X z / rho^2) / pi    zz = -(phi + X z / rho^2) / pi    xz = z^2 / (pi rho^2)    yy = nu (xx + zz)
/// with phi = atan(X / z) and rho^2 = X^2 + z^2; the strain along y is zero. For a unit shear across the strip, along x
/// (Johnson 1985, section 2.5), and for one along the strip, where points move along y only:
///     xx = -(ln(rho^2) + z^2 / rho^2) / pi    zz = z^2 / (pi rho^2)    xz = -(phi - X z / rho^2) / pi    yy = nu (xx + zz)
///     yz = -phi / pi                          xy = -ln(rho^2) / (2 pi)
/// @param z  depth [m], >= 0; on z = 0 the value at an edge is the mean of its two sides; for a shear, xx or xy is
///           infinite there.
[[nodiscard]] SymTensor strip_stress_edge(double X, double z, double nu, Traction traction = Traction::pressure);

} // namespace brinell::green
