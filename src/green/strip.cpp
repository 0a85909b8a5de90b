// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/green/strip.hpp"

#include "brinell/foundation/error.hpp"

#include <cmath>
#include <numbers>

namespace brinell::green
{

double strip_displacement_edge(double X, double reference)
{
  return X == 0.0 ? 0.0 : 2.0 * X * (1.0 - std::log(std::abs(X) / reference));
}

SymTensor strip_stress_edge(double X, double z, double nu, Traction traction)
{
  constexpr double f = std::numbers::inv_pi;
  const double rho2 = X * X + z * z;
  const double angle = std::atan2(X, z);
  const double beside = z > 0.0 ? X * z / rho2 : 0.0;
  const double below = z > 0.0 ? z * z / rho2 : 0.0;
  const auto plane = [&](double xx, double zz, double xz) -> SymTensor
  { return {f * xx, f * nu * (xx + zz), f * zz, 0.0, f * xz, 0.0}; };
  switch (traction)
  {
  case Traction::pressure:
    return plane(beside - angle, -(angle + beside), below);
  case Traction::shear_x:
    return plane(-(std::log(rho2) + below), below, beside - angle);
  case Traction::shear_y:
    return {0.0, 0.0, 0.0, -f * angle, 0.0, -0.5 * f * std::log(rho2)};
  }
  throw InternalError("strip_stress_edge: no such traction");
}

} // namespace brinell::green
