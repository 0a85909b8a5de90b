// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

namespace brinell::green
{

/// Corner antiderivatives (in x and y) of the harmonic functions with transform 2 pi e^{-kh}/k^n,
///     Lambda_0 = h/R^3,  Lambda_1 = 1/R,  Lambda_2 = -ln(R + h),  Lambda_3 = h ln(R + h) - R,  ...,
/// T_n,XY = Lambda_n, T_n,h = -T_{n-1}, T_n,XX + T_n,YY = -T_{n-2}. The member `t2_3` holds the third derivatives of
/// T_2 in the plane, (XXX, XXY, XYY, YYY). Forms that are odd in X and Y are used where possible; they differ from other
/// forms by functions of X or of Y alone or (n = 4) by functions of both without h, which the sum over the corners
/// removes.
struct ImagePotentials
{
  std::array<double, 1> minus1_0, t0_0, t1_0;
  std::array<double, 2> minus1_1, t0_1, t1_1, t2_1;
  std::array<double, 3> t0_2, t1_2, t2_2, t3_2;
  std::array<double, 4> t1_3, t2_3, t3_3;
  std::array<double, 5> t2_4, t3_4, t4_4;
};

/// @param X, Y  point minus corner [m].
/// @param h     depth of the point plus depth of the corner [m], >= 0; X^2 + h^2 > 0, Y^2 + h^2 > 0.
[[nodiscard]] ImagePotentials image_potentials(double X, double Y, double h);

} // namespace brinell::green
