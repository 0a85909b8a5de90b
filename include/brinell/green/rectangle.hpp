// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/sym_tensor.hpp"
#include "brinell/green/traction.hpp"

/// Influence coefficients: closed-form solutions of the elastic half space z >= 0 (z into the body), without state.
///
/// A uniform traction on a rectangle gives a sum over its four corners of an antiderivative G,
///     f(x, y) = G(x + dx/2, y + dy/2) - G(x - dx/2, y + dy/2) - G(x + dx/2, y - dy/2) + G(x - dx/2, y - dy/2),
/// so on a lattice of points with spacing (dx, dy) each corner serves four points: evaluate the `_corner` functions
/// once per corner and difference them. G is fixed only up to functions of x alone and of y alone; the forms used here
/// are odd in x and in y wherever that is possible, which removes every cancellation of the type rho + Y with Y < 0.
namespace brinell::green
{

/// Corner antiderivative of 1/r on z = 0: X asinh(Y/|X|) + Y asinh(X/|Y|) [m], odd in X and in Y, zero on the axes.
/// Its mixed derivative in X and Y is 1/sqrt(X^2 + Y^2) (Love 1929; Johnson 1985, Eq. 3.25).
/// @param X, Y  point minus corner [m], any sign or zero.
[[nodiscard]] double rectangle_displacement_corner(double X, double Y);

/// Integral of 1/r over a rectangle in the plane of the point [m], > 0 (Love 1929; Johnson 1985, Eq. 3.25).
/// A uniform pressure p > 0 on the rectangle displaces the surface into the body by
/// u_z = (1 - nu^2)/(pi E) p times this value = (1 - nu)/(2 pi mu) p times this value.
/// @param x, y    point relative to the rectangle's centre [m], on z = 0.
/// @param dx, dy  sides of the rectangle [m], > 0.
[[nodiscard]] double rectangle_displacement(double x, double y, double dx, double dy);

/// Corner antiderivative of `rectangle_stress` [-].
///
/// With V the integral of 1/r and chi that of ln(r + z) over the rectangle,
///     sigma_xx = (2 nu V,z - z V,xx - (1 - 2 nu) chi,xx)/(2 pi)      sigma_yz = -z V,yz/(2 pi)
///     sigma_yy = (2 nu V,z - z V,yy - (1 - 2 nu) chi,yy)/(2 pi)      sigma_xz = -z V,xz/(2 pi)
///     sigma_zz = (V,z - z V,zz)/(2 pi)                               sigma_xy = -(z V,xy + (1 - 2 nu) chi,xy)/(2 pi)
/// (Love 1929). With rho = sqrt(X^2 + Y^2 + z^2) the corner terms are
///     V,xx = -X Y/(rho (X^2 + z^2))    V,xz = -z Y/(rho (X^2 + z^2))    V,z    = -atan(X Y/(z rho))
///     V,yy = -X Y/(rho (Y^2 + z^2))    V,yz = -z X/(rho (Y^2 + z^2))    V,xy   = 1/rho
///     chi,xx = atan(X Y (rho - z)/(X^2 rho + Y^2 z))                    chi,xy = ln(rho + z)
/// V,zz = -(V,xx + V,yy) and chi,yy = -(V,z + chi,xx).
///
/// For a shear along x there is one more potential, chi_1, with chi = chi_1,z (Cerruti; Johnson 1985, Eqs. 3.7):
///     sigma_xx = (2 (1 + nu) V,x + 2 nu chi_1,xxx - z chi,xxx)/(2 pi)    sigma_yz = -z V,xy/(2 pi)
///     sigma_yy = (2 nu V,x + 2 nu chi_1,xyy - z chi,xyy)/(2 pi)          sigma_xz = (V,z - z V,xx)/(2 pi)
///     sigma_zz = -z V,xz/(2 pi)                                          sigma_xy = (V,y + 2 nu chi_1,xxy - z chi,xxy)/(2 pi)
///     V,x = asinh(Y/sqrt(X^2 + z^2))       chi_1,xxy = -X/(rho + z)      chi,xxy = X/(rho (rho + z))
///     V,y = asinh(X/sqrt(Y^2 + z^2))       chi_1,xyy = -Y/(rho + z)      chi,xyy = Y/(rho (rho + z))
/// chi_1,xxx = -(V,x + chi_1,xyy) and chi,xxx = -(V,xz + chi,xyy). A shear along y is the same with x and y exchanged.
/// @param X, Y  point minus corner [m], any sign or zero.
/// @param z     depth [m], >= 0. On z = 0 the value on an edge line is the mean of its two sides; the xy component is
///              minus infinity at the corner itself, where sigma_xy is logarithmically singular (unless nu = 1/2).
///              Under a shear the stress is singular at the edges on z = 0: the function must not be called for a point on an
///              edge line there.
/// @param nu    Poisson's ratio [-].
[[nodiscard]] SymTensor rectangle_stress_corner(double X, double Y, double z, double nu,
                                                Traction traction = Traction::pressure);

/// Stress in the half space under a uniform unit traction on a rectangle of its surface [Pa/Pa], tension positive:
/// just under the rectangle, sigma_zz = -1 for a pressure and sigma_xz = -1 for a shear along x (Love 1929, Cerruti; equations
/// at `rectangle_stress_corner`).
/// @param x, y, z  point relative to the rectangle's centre [m], z >= 0 into the body.
/// @param dx, dy   sides of the rectangle [m], > 0.
/// @param nu       Poisson's ratio [-].
[[nodiscard]] SymTensor rectangle_stress(double x, double y, double z, double dx, double dy, double nu,
                                         Traction traction = Traction::pressure);

} // namespace brinell::green
