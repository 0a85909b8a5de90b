// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace brinell::constitutive
{

/// One term of kinematic hardening: a back stress that moves the centre of the yield surface,
///   d alpha = 2/3 modulus d_eps - recall alpha d_e
/// (Armstrong, Frederick 1966; several terms: Chaboche 1986; recall = 0: Prager 1956, linear). In monotonic uniaxial loading the
/// term adds modulus / recall (1 - exp(-recall e)) to the stress.
struct KinematicTerm
{
  double modulus = 0.0; ///< C [Pa], >= 0
  double recall = 0.0;  ///< gamma [-], >= 0

  bool operator==(const KinematicTerm&) const = default;
};

} // namespace brinell::constitutive
