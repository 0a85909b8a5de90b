// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/constitutive/kinematic_return.hpp"

namespace brinell::constitutive
{

/// How the plastic strain of one increment is integrated at a point.
enum class Integration
{
  path,          ///< along the straight path of the trial stress between two steps: second order in the step
  backward_euler ///< one radial return at the end of the step, as in the paper: first order
};

/// Plastic flow of one point in one increment, by the return mapping for this material and this integration.
/// @param s0         stress deviator before the increment [Pa], where the path begins.
/// @param q          trial deviator s + c d_eps [Pa]
/// @param e          equivalent plastic strain before the increment
/// @param stiffness  c [Pa]: twice the shear modulus for an isolated point; a fraction of that in the fixed-point iteration of a
///                   body, whose other points carry a part of the stress (docs/theory/elastoplastic.md).
/// @param terms      of kinematic hardening; may be empty.
/// @param back       their back stresses [Pa]; in: before the increment, out: after it.
template <typename Law>
[[nodiscard]] PlasticIncrement flow(const Law& law, std::span<const KinematicTerm> terms, Integration integration,
                                    const Deviator& s0, const Deviator& q, double e, double stiffness,
                                    std::span<Deviator> back)
{
  const bool along_path = integration == Integration::path;
  const double mu = 0.5 * stiffness;
  if (!terms.empty())
    return kinematic_return(s0, q, e, mu, law, along_path ? 0.5 : 1.0, terms, back);
  return along_path ? path_return(s0, q, e, mu, law) : radial_return(q, e, mu, law);
}

} // namespace brinell::constitutive
