// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/constitutive/hardening.hpp"
#include "brinell/foundation/deviator.hpp"

#include <algorithm>
#include <cmath>

/// J2 plasticity with isotropic hardening at one point. The trial deviator q is the stress that would act if the
/// increment left no plastic strain at this point; the stress that acts is s = q - 2 mu d_eps.
namespace brinell::constitutive
{

/// Plastic strain of one increment at one point.
struct PlasticIncrement
{
  Deviator strain;          ///< d_eps [-]
  double equivalent = 0.0;  ///< increment of the accumulated equivalent plastic strain [-], >= 0
  double dissipation = 0.0; ///< plastic work [J/m^3]
};

namespace detail
{

/// Root of f(x) = overstress(x) - sigma_y(e + x), x >= 0, where f decreases: Newton's method, restricted to the bracket found so
/// far. The slope of sigma_y may be infinite at the start of a law.
/// @param x  initial guess with f(x) <= 0, up to rounding: the root for perfect plasticity, as hardening only reduces the flow.
template <typename Law, typename Overstress>
BRINELL_HOST_DEVICE double consistent_multiplier(const Law& law, double e, const Overstress& overstress, double x)
{
  double low = 0.0;
  double high = x;
  for (int iteration = 0; iteration < 100; ++iteration)
  {
    const auto [value, slope] = overstress(x);
    const double yield = law.yield_stress_at(e + x);
    const double f = value - yield;
    (f > 0.0 ? low : high) = x;
    const double newton = x - f / (slope - law.modulus_at(e + x));
    if (std::abs(f) <= 1e-13 * yield)
      return std::max(newton, 0.0);
    x = newton > low && newton < high ? newton : 0.5 * (low + high);
  }
  return x;
}

} // namespace detail

/// Backward Euler: the flow direction is that of the end of the increment (Wilkins 1964; Simo, Hughes 1998, Box 3.2).
/// @param q    trial deviator [Pa]
/// @param e    equivalent plastic strain before the increment
/// @param mu   shear modulus [Pa]
template <typename Law>
[[nodiscard]] BRINELL_HOST_DEVICE PlasticIncrement radial_return(const Deviator& q, double e, double mu, const Law& law)
{
  const double trial = von_mises(q);
  const double yield = law.yield_stress_at(e);
  if (trial <= yield)
    return {};
  const double de = detail::consistent_multiplier(
      law, e,
      [&](double x) {
        return std::pair{trial - 3.0 * mu * x, -3.0 * mu};
      },
      (trial - yield) / (3.0 * mu));
  return {(1.5 * de / trial) * q, de, law.work(e + de) - law.work(e)};
}

/// Point where the straight line from `from` to `to` leaves the yield surface: |from + b (to - from)| = yield. @returns b in
/// [0, 1]; 0 if the line starts outside the yield surface.
[[nodiscard]] BRINELL_HOST_DEVICE inline double yield_crossing(const Deviator& from, const Deviator& to, double yield)
{
  const Deviator d = to - from;
  const double dd = 1.5 * contract(d, d);
  const double sd = 1.5 * contract(from, d);
  const double ss = 1.5 * contract(from, from) - yield * yield;
  return dd > 0.0 ? std::clamp((-sd + std::sqrt(std::max(sd * sd - dd * ss, 0.0))) / dd, 0.0, 1.0) : 0.0;
}

/// Second order: the trial deviator moves along a straight line from the stress `s0` before the increment to `q`. From the point
/// where it reaches the yield surface, the flow is along the mean of the normals at both ends of the rest of the path
/// (generalised trapezoidal rule, Ortiz, Popov 1985), and the yield condition holds at the end.
template <typename Law>
[[nodiscard]] BRINELL_HOST_DEVICE PlasticIncrement path_return(const Deviator& s0, const Deviator& q, double e,
                                                               double mu, const Law& law)
{
  const double yield = law.yield_stress_at(e);
  const double trial = von_mises(q);
  if (trial <= yield)
    return {};
  const Deviator entry = s0 + yield_crossing(s0, q, yield) * (q - s0);
  const Deviator n0 = (1.5 / von_mises(entry)) * entry;
  // |q - mu x n0| = yield + 3/2 mu x is linear in x once squared, as |n0| = 3/2.
  const double start = (trial * trial - yield * yield) / (3.0 * mu * (contract(q, n0) + yield));
  const double x = detail::consistent_multiplier(
      law, e,
      [&](double multiplier)
      {
        const Deviator r = q - (mu * multiplier) * n0;
        const double size = von_mises(r);
        const double slope = -1.5 * mu * contract(r, n0) / size;
        return std::pair{size - 1.5 * mu * multiplier, slope - 1.5 * mu};
      },
      start);
  const Deviator r = q - (mu * x) * n0;
  const Deviator s1 = (law.yield_stress_at(e + x) / von_mises(r)) * r;
  const Deviator strain = (0.5 / mu) * (q - s1);
  return {strain, x, 0.5 * contract(entry + s1, strain)};
}

} // namespace brinell::constitutive
