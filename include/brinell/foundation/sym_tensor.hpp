// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cmath>

namespace brinell
{

/// Symmetric second-order tensor by its six components in the order xx, yy, zz, yz, xz, xy. Off-diagonal entries are
/// tensor components (a shear strain is half the engineering shear), each stored once.
using SymTensor = std::array<double, 6>;

/// t_xx + t_yy + t_zz [unit of t].
[[nodiscard]] constexpr double trace(const SymTensor& t)
{
  return t[0] + t[1] + t[2];
}

/// t - trace(t)/3 identity [unit of t].
[[nodiscard]] constexpr SymTensor deviator(const SymTensor& t)
{
  const double mean = trace(t) / 3.0;
  return {t[0] - mean, t[1] - mean, t[2] - mean, t[3], t[4], t[5]};
}

/// a : b = sum over i, j of a_ij b_ij [unit of a times unit of b]; each off-diagonal component counts twice.
[[nodiscard]] constexpr double double_contraction(const SymTensor& a, const SymTensor& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + 2.0 * (a[3] * b[3] + a[4] * b[4] + a[5] * b[5]);
}

/// Von Mises equivalent of a stress, sqrt(3/2 s : s) with s the deviator [unit of stress].
[[nodiscard]] inline double von_mises(const SymTensor& stress)
{
  const SymTensor s = deviator(stress);
  return std::sqrt(1.5 * double_contraction(s, s));
}

} // namespace brinell
