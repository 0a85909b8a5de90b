// SPDX-License-Identifier: BSD-3-Clause
#include "green/image_potentials.hpp"

#include <cmath>

namespace brinell::green
{
namespace
{

/// Quantities for one of the two directions, which is called X here; the other is Y.
struct Axis
{
  double asinh; ///< T_1,X = asinh(Y/sqrt(X^2 + h^2))
  double t0_1;  ///< T_0,X = Y h/(R (X^2 + h^2))
  double m1_1;  ///< T_-1,X
  double t0_2;  ///< T_0,XX
  double t1_2;  ///< T_1,XX = -X Y/(R (X^2 + h^2))
};

Axis axis(double X, double Y, double h, double R)
{
  const double q = 1.0 / (X * X + h * h);
  const double u = 1.0 / R;
  const double first = h * h * u * u + 2.0 * h * h * q;
  return {.asinh = std::asinh(Y * std::sqrt(q)),
          .t0_1 = Y * h * u * q,
          .m1_1 = Y * u * q * (first - 1.0),
          .t0_2 = -X * Y * h * u * q * (u * u + 2.0 * q),
          .t1_2 = -X * Y * u * q};
}

/// -T_2,XX = atan(X Y (R - h)/(X^2 R + Y^2 h)), with R - h = (X^2 + Y^2)/(R + h).
double surface_angle(double X, double Y, double h, double R)
{
  const double x2 = X * X, y2 = Y * Y;
  return std::atan2(X * Y * (x2 + y2), (x2 * R + y2 * h) * (R + h));
}

/// Third derivatives from Lambda_n,X, Lambda_n,Y and the first derivatives of T_{n-2}.
std::array<double, 4> third(double lambda_x, double lambda_y, double lower_x, double lower_y)
{
  return {-lower_x - lambda_y, lambda_x, lambda_y, -lower_y - lambda_x};
}

/// Fourth derivatives from the second of Lambda_n, (XX, XY, YY), and of T_{n-2}.
std::array<double, 5> fourth(const std::array<double, 3>& lambda, const std::array<double, 3>& lower)
{
  return {-lower[0] - lambda[1], lambda[0], lambda[1], lambda[2], -lower[2] - lambda[1]};
}

} // namespace

ImagePotentials image_potentials(double X, double Y, double h)
{
  const double R = std::sqrt(X * X + Y * Y + h * h);
  const double u = 1.0 / R, v = 1.0 / (R + h);
  const double log = std::log(R + h);
  const Axis x = axis(X, Y, h, R), y = axis(Y, X, h, R);
  const double angle_x = surface_angle(X, Y, h, R);
  const double angle_0 = std::atan2(X * Y, h * R);
  const double angle_y = angle_0 - angle_x;

  ImagePotentials t;
  t.minus1_0 = {-(x.t1_2 + y.t1_2)};
  t.t0_0 = {angle_0};
  t.t1_0 = {X * x.asinh + Y * y.asinh - h * angle_0};
  t.minus1_1 = {x.m1_1, y.m1_1};
  t.t0_1 = {x.t0_1, y.t0_1};
  t.t1_1 = {x.asinh, y.asinh};
  t.t2_1 = {-(Y * log + h * x.asinh + X * angle_x), -(X * log + h * y.asinh + Y * angle_y)};
  t.t0_2 = {x.t0_2, h * u * u * u, y.t0_2};
  t.t1_2 = {x.t1_2, u, y.t1_2};
  t.t2_2 = {-angle_x, -log, -angle_y};
  t.t3_2 = {h * angle_x - X * x.asinh, h * log - R, h * angle_y - Y * y.asinh};
  t.t1_3 = third(-X * u * u * u, -Y * u * u * u, x.m1_1, y.m1_1);
  t.t2_3 = third(-X * u * v, -Y * u * v, x.t0_1, y.t0_1);
  t.t3_3 = third(-X * v, -Y * v, x.asinh, y.asinh);

  const double c2 = u * u * u * v * v * (2.0 * R + h);
  const double c3 = u * v * v;
  const double c4 = 0.5 * v * v;
  const double d4 = 0.5 * (log + h * v);
  t.t2_4 = fourth({X * X * c2 - u * v, X * Y * c2, Y * Y * c2 - u * v}, t.t0_2);
  t.t3_4 = fourth({X * X * c3 - v, X * Y * c3, Y * Y * c3 - v}, t.t1_2);
  t.t4_4 = fourth({X * X * c4 + d4, X * Y * c4, Y * Y * c4 + d4}, t.t2_2);
  return t;
}

} // namespace brinell::green
