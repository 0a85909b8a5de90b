// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/green/strip.hpp"

#include <cmath>
#include <numbers>

namespace brinell::green
{

double strip_displacement_edge(double X, double reference)
{
  return X == 0.0 ? 0.0 : 2.0 * X * (1.0 - std::log(std::abs(X) / reference));
}

SymTensor strip_stress_edge(double X, double z, double nu)
{
  constexpr double pi = std::numbers::pi;
  const double rho2 = X * X + z * z;
  const double angle = std::atan2(X, z);
  const double beside = z > 0.0 ? X * z / rho2 : 0.0;
  const double xx = -(angle - beside) / pi;
  const double zz = -(angle + beside) / pi;
  const double xz = z > 0.0 ? z * z / (pi * rho2) : 0.0;
  return {xx, nu * (xx + zz), zz, 0.0, xz, 0.0};
}

} // namespace brinell::green
