// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/constitutive/kinematic.hpp"
#include "brinell/constitutive/return_mapping.hpp"

#include <span>

/// Return mapping with back stresses: the yield condition is |s - sum of alpha_i| <= sigma_y(e).
namespace brinell::constitutive
{

namespace detail
{

/// Factors by which a back stress decays and grows in an increment x of equivalent strain:
/// alpha <- decay alpha + 2/3 C growth d_eps. Exact if the direction of flow is constant in the increment.
struct Recall
{
  double decay, growth;

  BRINELL_HOST_DEVICE Recall(const KinematicTerm& term, double x)
      : decay(std::exp(-term.recall * x)),
        growth(term.recall * x > 0.0 ? -std::expm1(-term.recall * x) / (term.recall * x) : 1.0)
  {
  }
};

/// Root of a function that is positive at 0 and negative at `high`: regula falsi in which the value at an end that is retained
/// twice is halved (Illinois method).
template <typename Function>
BRINELL_HOST_DEVICE double bracketed_root(const Function& function, double at_zero, double high, double tolerance)
{
  double low = 0.0;
  double f_low = at_zero;
  double f_high = function(high);
  while (f_high > 0.0) // the law is softer than expected, so the root is beyond `high`
  {
    low = high;
    f_low = f_high;
    high *= 2.0;
    f_high = function(high);
  }
  int kept = 0; // number of iterations in which one end was retained; > 0: the upper end, < 0: the lower end
  for (int iteration = 0; iteration < 200; ++iteration)
  {
    const double x = (low * f_high - high * f_low) / (f_high - f_low);
    const double f = function(x);
    if (std::abs(f) <= tolerance || !(low < x && x < high))
      return x;
    (f > 0.0 ? low : high) = x;
    (f > 0.0 ? f_low : f_high) = f;
    kept = f > 0.0 ? std::max(kept, 0) + 1 : std::min(kept, 0) - 1;
    if (kept > 1)
      f_high *= 0.5;
    else if (kept < -1)
      f_low *= 0.5;
  }
  return 0.5 * (low + high);
}

} // namespace detail

/// The increment of one point. Flow is along (1 - end) n0 + end n1, with n0 the normal where the straight path of the
/// trial deviator leaves the elastic domain and n1 the normal at the end: end = 1 is backward Euler, end = 1/2 is of second
/// order (see path_return).
/// @param s0    stress deviator before the increment [Pa]
/// @param q     trial deviator [Pa]
/// @param e     equivalent plastic strain before the increment
/// @param mu    shear modulus [Pa]
/// @param back  the back stresses [Pa], one per term; in: before the increment, out: after it.
template <typename Law>
[[nodiscard]] BRINELL_HOST_DEVICE PlasticIncrement kinematic_return(const Deviator& s0, const Deviator& q, double e,
                                                                    double mu, const Law& law, double end,
                                                                    std::span<const KinematicTerm> terms,
                                                                    std::span<Deviator> back)
{
  Deviator centre;
  for (const Deviator& b : back)
    centre = centre + b;
  const double yield = law.yield_stress_at(e);
  const double trial = von_mises(q - centre);
  if (trial <= yield)
    return {};
  const Deviator entry = s0 + yield_crossing(s0 - centre, q - centre, yield) * (q - s0);
  const Deviator n0 = (1.0 / von_mises(entry - centre)) * (entry - centre);

  // s - sum alpha = r(x) - 3/2 end x K n1 has the magnitude sigma_y: so |r| = sigma_y + 3/2 end x K.
  double stiffness = 0.0;
  Deviator r;
  const auto overstress = [&](double x)
  {
    stiffness = 2.0 * mu;
    r = q;
    for (std::size_t i = 0; i < terms.size(); ++i)
    {
      const detail::Recall recall(terms[i], x);
      stiffness += 2.0 / 3.0 * terms[i].modulus * recall.growth;
      r = r - recall.decay * back[i];
    }
    r = r - (1.5 * (1.0 - end) * x * stiffness) * n0;
    return von_mises(r) - law.yield_stress_at(e + x) - 1.5 * end * x * stiffness;
  };
  constexpr double rounding = 1e-13;
  const double x = detail::bracketed_root(overstress, trial - yield, (trial - yield) / (1.5 * mu), rounding * yield);
  (void)overstress(x); // sets r and stiffness to their values at the root
  const Deviator n1 = (1.0 / von_mises(r)) * r;
  const Deviator strain = (1.5 * x * (1.0 - end)) * n0 + (1.5 * x * end) * n1;
  for (std::size_t i = 0; i < terms.size(); ++i)
  {
    const detail::Recall recall(terms[i], x);
    back[i] = recall.decay * back[i] + (2.0 / 3.0 * terms[i].modulus * recall.growth) * strain;
  }
  const Deviator s1 = q - (2.0 * mu) * strain;
  return {strain, x, 0.5 * contract(entry + s1, strain)};
}

} // namespace brinell::constitutive
