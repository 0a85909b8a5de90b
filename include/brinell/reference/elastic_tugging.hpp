// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/reference/critical.hpp"

#include <optional>

namespace brinell::reference
{

/// Two elastic spheres, or cylinders in plane strain, of which the upper is carried past the lower one at a constant height,
/// without plasticity and without friction: exact within Hertz' theory. At the sliding coordinate X (0 at alignment, growing)
/// the centres are omega' apart, omega'^2 = omega^2 + X^2 with omega = R1 + R2 - alpha, and
///     P = P(R1 + R2 - omega'),   F_X = -P X/omega',   F_Z = P omega/omega',
/// with P(alpha) = 4/3 E' sqrt(R) alpha^1.5 of spheres, and of cylinders `line_contact_at_approach`.
struct ElasticTugging
{
  double radius_lower = 0.0;    ///< R1 [m], > 0
  double radius_upper = 0.0;    ///< R2 [m], > 0
  double contact_modulus = 0.0; ///< E' [Pa], > 0
  double interference = 0.0;    ///< alpha at alignment [m], 0 < alpha < R1 + R2
  /// Of cylinders, whose loads and energies then are those of their length; none: spheres.
  std::optional<Line> line{};
};

/// Forces at one position.
struct TuggingForces
{
  double load = 0.0;         ///< P, along the line of centres [N]
  double F_X = 0.0;          ///< > 0 resists the motion: before alignment [N]
  double F_Z = 0.0;          ///< presses the spheres apart [N]
  double interference = 0.0; ///< R1 + R2 - omega', 0 without contact [m]
};

/// The largest resistance and where it occurs.
struct TuggingPeak
{
  double F_X = 0.0; ///< [N]
  double X = 0.0;   ///< < 0 [m]
};

/// Checks the ranges given at the members.
/// @throws InputError
void require_valid(const ElasticTugging& tugging);

/// d0: the spheres touch for -d0 < X < d0 [m]; tan(theta) of the first touch is d0/omega (Boucly, Nelias & Green 2006,
/// Eq. 2).
[[nodiscard]] double half_sliding_distance(const ElasticTugging& tugging);

/// Forces at X [m].
[[nodiscard]] TuggingForces elastic_tugging_forces(const ElasticTugging& tugging, double X);

/// Peak of F_X: omega^2 P = omega' X^2 dP/d alpha.
[[nodiscard]] TuggingPeak elastic_tugging_peak(const ElasticTugging& tugging);

/// Work of F_X from X1 to X2 [J]: the force has a potential, the integral U of P over alpha (of spheres
/// 8/15 E' sqrt(R) (R1 + R2 - omega')^2.5), so a whole pass needs none, and the way to alignment U(alpha).
[[nodiscard]] double elastic_tugging_work(const ElasticTugging& tugging, double X1, double X2);

} // namespace brinell::reference
