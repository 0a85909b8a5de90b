// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/green/elastic.hpp"

#include <array>

/// Displacement of the surface of a half space under a traction (p, q_x, q_y) on it, all three components.
namespace brinell::green
{

/// Integrals over the loaded area of five functions of the distance (x, y) from the load, which determine the displacement of
/// the surface under a traction (Boussinesq and Cerruti; Johnson 1985, sections 3.2 and 3.6). With r^2 = x^2 + y^2 and mu, nu of
/// the body,
///     4 pi mu u_z = 2 (1 - nu) p/r + (1 - 2 nu) (q_x x/r^2 + q_y y/r^2)
///     4 pi mu u_x = -(1 - 2 nu) p x/r^2 + 2 q_x ((1 - nu)/r + nu x^2/r^3) + 2 q_y nu x y/r^3
/// and u_y as u_x with x and y exchanged. The integral of 1/r is that of x^2/r^3 plus that of y^2/r^3.
/// Order: x^2/r^3, y^2/r^3, x y/r^3, x/r^2, y/r^2 [m].
using SurfaceTerms = std::array<double, 5>;

/// The terms with x and y exchanged.
[[nodiscard]] constexpr SurfaceTerms xy_exchanged(const SurfaceTerms& t)
{
  return {t[1], t[0], t[2], t[4], t[3]};
}

/// Corner antiderivatives for a rectangle (see rectangle.hpp), with R^2 = X^2 + Y^2:
///     Y asinh(X/|Y|)    X asinh(Y/|X|)    -R    Y ln R + X atan(Y/X)    X ln R + Y atan(X/Y)
/// @param X, Y  point minus corner [m], any sign or zero.
[[nodiscard]] SurfaceTerms rectangle_surface_corner(double X, double Y);

/// Terms of a unit traction on a rectangle.
/// @param x, y    point relative to the rectangle's centre [m], on z = 0.
/// @param dx, dy  sides of the rectangle [m], > 0.
[[nodiscard]] SurfaceTerms rectangle_surface_terms(double x, double y, double dx, double dy);

/// Edge antiderivatives for a strip that is infinite along y (see strip.hpp). The displacement by a line load diverges; it is
/// taken, in every direction, relative to a point at the distance `reference` from the line.
[[nodiscard]] SurfaceTerms strip_surface_edge(double X, double reference);

/// Terms of a wave of unit traction with the wavevector (m, n) of magnitude k > 0 [m]; the last two must be multiplied by i.
[[nodiscard]] SurfaceTerms surface_wave_terms(double m, double n);

/// Factors of the terms for a pair of half spaces that share x and y; z points into each of them, and the shear on body 2 is
/// opposite to that on body 1. The displacement of the pair along z is the sum of both, along x and y that of body 1 minus that
/// of body 2.
struct PairConstants
{
  double normal; ///< sum of (1 - nu)/(2 pi mu) = 1/(pi E') [1/Pa]
  double along;  ///< sum of nu/(2 pi mu) [1/Pa]
  double
      coupling; ///< of pressure and shear, (1 - 2 nu)/(4 pi mu) of body 1 minus that of body 2 [1/Pa]; zero if they are equal
};
[[nodiscard]] PairConstants pair_constants(const Elastic& body1, const Elastic& body2);

} // namespace brinell::green
