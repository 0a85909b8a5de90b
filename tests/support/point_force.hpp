// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/sym_tensor.hpp"

#include <cmath>
#include <numbers>

namespace brinell::test
{

/// Stress of a point force along x on the surface (Cerruti; Johnson 1985, Eqs. 3.76).
inline SymTensor point_force_along_x(double x, double y, double z, double nu)
{
  const double r = std::sqrt(x * x + y * y + z * z), h = r + z;
  const double r3 = r * r * r, r5 = r3 * r * r, b = 1.0 - 2.0 * nu, f = 0.5 / std::numbers::pi;
  const double a1 = 1.0 / (r * h * h), a2 = 1.0 / (r3 * h * h), a3 = 2.0 / (r * r * h * h * h);
  return {f * (-3.0 * x * x * x / r5 + b * (x / r3 - 3.0 * x * a1 + x * x * x * (a2 + a3))),
          f * (-3.0 * x * y * y / r5 + b * (x / r3 - x * a1 + x * y * y * (a2 + a3))),
          -3.0 * f * x * z * z / r5,
          -3.0 * f * x * y * z / r5,
          -3.0 * f * x * x * z / r5,
          f * (-3.0 * x * x * y / r5 + b * (-y * a1 + x * x * y * (a2 + a3)))};
}

} // namespace brinell::test
