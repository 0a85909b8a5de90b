// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <utility>

namespace brinell::reference
{

/// Oblate spheroidal coordinates xi, eta, both >= 0, of a point r, z in units of the contact radius:
/// z = xi eta, r^2 = (1 + xi^2)(1 - eta^2).
inline std::pair<double, double> spheroidal(double r2, double z)
{
  const double A = r2 + z * z - 1.0;
  const double S = std::hypot(A, 2.0 * z);
  if (A > 0.0)
  {
    const double xi = std::sqrt(0.5 * (S + A));
    return {xi, z / xi};
  }
  const double eta = std::sqrt(0.5 * (S - A));
  return {eta > 0.0 ? z / eta : 0.0, eta};
}

} // namespace brinell::reference
