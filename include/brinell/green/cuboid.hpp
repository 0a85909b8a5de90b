// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/sym_tensor.hpp"
#include "brinell/green/elastic.hpp"

#include <array>

/// Cuboids with a uniform eigenstrain (plastic or thermal strain), in full space and under a free surface.
namespace brinell::green
{

/// Derivatives of the harmonic potential phi = integral of 1/R and the biharmonic psi = integral of R over a cuboid.
struct CuboidPotentials
{
  SymTensor phi{}; ///< second derivatives of phi [-]
  /// Fourth derivatives of psi [-]: xxxx, yyyy, zzzz, xxyy, yyzz, xxzz, xxxy, xxxz, yyyx, yyyz, zzzx, zzzy, xxyz, yyxz,
  /// zzxy.
  std::array<double, 15> psi{};
};

/// One corner's part of `cuboid_potentials`; a sum over the corners with sign + where an even number of the three
/// coordinates is taken at the far face (X = x - dx/2) gives the cuboid, so a lattice of corners serves all cuboids.
///     phi,xx  = -atan(Y Z/(X R))                  phi,xy  = L_z
///     psi,xxyy = -X Y Z/((X^2 + Y^2) R)           psi,xxyz = X/R
///     psi,xxxy = L_z - X^2 Z/((X^2 + Y^2) R)      psi,xxxx = 2 phi,xx - psi,xxyy - psi,xxzz
/// and permutations, with R^2 = X^2 + Y^2 + Z^2 and L_z = asinh(Z/sqrt(X^2 + Y^2)), equal to ln(R + Z) up to a function
/// of X and Y, which the sum removes (Mura 1987, Section 11; Chiu 1977).
/// @param X, Y, Z  point minus corner [m]. On a face the sum is the mean of its two sides; on an edge it is infinite
///                 in theory, and a finite part is returned.
[[nodiscard]] CuboidPotentials cuboid_potentials_corner(double X, double Y, double Z);

/// Derivatives of the potentials of a cuboid centred at the origin.
/// @param x, y, z     point [m].
/// @param dx, dy, dz  sides [m], > 0.
[[nodiscard]] CuboidPotentials cuboid_potentials(double x, double y, double z, double dx, double dy, double dz);

/// Stress of a uniform eigenstrain from the potentials of its region [Pa], tension positive:
///     8 pi (1 - nu) u_i = eps_jl psi,ijl - 2 nu eps_mm phi,i - 4 (1 - nu) eps_il phi,l,
///     sigma = C : (grad u - inside eps)   (Mura 1987, Eq. 11.30).
/// @param inside  1 inside the region, 0 outside, 1/2 on a face (where the components that jump take their mean).
[[nodiscard]] SymTensor eigenstrain_stress(const CuboidPotentials& potentials, double inside,
                                           const SymTensor& eigenstrain, const Elastic& elastic);

/// Stress in full space of a cuboid centred at the origin with a uniform eigenstrain of any trace [Pa], tension
/// positive (Chiu 1977). Equations at `eigenstrain_stress`, `cuboid_potentials_corner`.
/// @param x, y, z      point [m], not on an edge. On a face the components that jump take the mean of both sides.
/// @param dx, dy, dz   sides [m], > 0.
/// @param eigenstrain  tensor components [-].
[[nodiscard]] SymTensor cuboid_stress(double x, double y, double z, double dx, double dy, double dz,
                                      const SymTensor& eigenstrain, const Elastic& elastic);

/// Stress in the half space z >= 0 with a free surface, of a cuboid centred at (0, 0, zc) with a uniform eigenstrain of
/// any trace [Pa], tension positive: cuboid, plus its mirror image at -zc with the xz and yz components negated, plus
/// the Boussinesq field of the pressure 2 sigma_zz(cuboid) that frees z = 0 of its remaining traction (Liu, Jin, Wang,
/// Keer 2012). The potential of that pressure is closed-form too.
///
/// In the wavenumber domain (factor e^{i k l}, l along the wavevector, t across it) V = -2 pi mu/(1 - nu) F e^{-kz}
/// with
///     F = integral over z' of (eps_ll + eps_zz + 2 nu eps_tt - k z' (eps_ll - eps_zz - 2 i eps_lz)) e^{-k z'}.
/// Back in space, with T_n the harmonic function of transform 2 pi e^{-k(z + z')}/k^n (integrated over the rectangle),
/// D = eps_xx d_xx + eps_yy d_yy + 2 eps_xy d_xy, G = eps_xz d_x + eps_yz d_y,
///     V = -mu/(1 - nu) [ -z' (D T_2 + eps_zz T_0 + 2 G T_1) - 2 nu D T_3
///                        - 2 (eps_zz + nu (eps_xx + eps_yy)) T_1 - 2 G T_2 ] between the lower and upper face z'.
/// @param x, y, z     point [m], z >= 0; not on an edge of the cuboid. The surface may coincide with its upper face.
/// @param zc          depth of the cuboid's centre [m], >= dz/2.
/// @param dx, dy, dz  sides [m], > 0.
[[nodiscard]] SymTensor cuboid_stress_half_space(double x, double y, double z, double zc, double dx, double dy,
                                                 double dz, const SymTensor& eigenstrain, const Elastic& elastic);

/// Normal displacement of the free surface at (x, y, 0), into the body positive [m], of the same cuboid: by the
/// potential V above, u_z = (1 - nu)/(2 pi mu) V(z = 0). A dilatation lifts the surface, u_z < 0 (Mindlin & Cheng
/// 1950).
[[nodiscard]] double cuboid_surface_displacement(double x, double y, double zc, double dx, double dy, double dz,
                                                 const SymTensor& eigenstrain, double poisson_ratio);

} // namespace brinell::green
