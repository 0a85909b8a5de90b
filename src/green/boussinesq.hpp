// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/sym_tensor.hpp"

#include <numbers>

namespace brinell::green
{

/// Derivatives of Boussinesq's potentials of a surface pressure p, V = integral of p/r and chi = integral of p ln(r +
/// z), both harmonic, chi,z = V. Second derivatives of V are multiplied by the depth, which keeps them finite at the
/// surface.
struct BoussinesqTerms
{
  double v_z = 0.0;
  double z_v_xx = 0.0, z_v_yy = 0.0, z_v_yz = 0.0, z_v_xz = 0.0, z_v_xy = 0.0;
  double chi_xx = 0.0, chi_xy = 0.0; ///< chi_yy = -(v_z + chi_xx)
};

/// Stress due to the pressure with these potentials [unit of p]; equations at `rectangle_stress_corner`.
[[nodiscard]] inline SymTensor boussinesq_stress(const BoussinesqTerms& t, double nu)
{
  constexpr double f = 0.5 * std::numbers::inv_pi;
  const double beta = 1.0 - 2.0 * nu;
  const double chi_yy = -(t.v_z + t.chi_xx);
  const double shear = beta == 0.0 ? 0.0 : beta * t.chi_xy; // chi_xy may be infinite at a corner of a rectangle
  return {f * (2.0 * nu * t.v_z - t.z_v_xx - beta * t.chi_xx),
          f * (2.0 * nu * t.v_z - t.z_v_yy - beta * chi_yy),
          f * (t.v_z + t.z_v_xx + t.z_v_yy),
          -f * t.z_v_yz,
          -f * t.z_v_xz,
          -f * (t.z_v_xy + shear)};
}

} // namespace brinell::green
