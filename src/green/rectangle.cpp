// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/green/rectangle.hpp"

#include "brinell/foundation/error.hpp"
#include "green/boussinesq.hpp"
#include "green/scaled_asinh.hpp"

#include <cmath>
#include <numbers>

namespace brinell::green
{
namespace
{

SymTensor pressure_corner(double X, double Y, double z, double nu)
{
  const double x2 = X * X, y2 = Y * Y, z2 = z * z;
  const double rho = std::sqrt(x2 + y2 + z2);
  BoussinesqTerms t;
  t.v_z = -std::atan2(X * Y, z * rho);
  // rho - z = (X^2 + Y^2)/(rho + z): both sides of the quotient are multiplied by rho + z.
  t.chi_xx = std::atan2(X * Y * (x2 + y2), (x2 * rho + y2 * z) * (rho + z));
  t.chi_xy = std::log(rho + z);
  if (z > 0.0)
  {
    const double along_x = z / (rho * (x2 + z2));
    const double along_y = z / (rho * (y2 + z2));
    t.z_v_xx = -X * Y * along_x;
    t.z_v_yy = -X * Y * along_y;
    t.z_v_xz = -z * Y * along_x;
    t.z_v_yz = -z * X * along_y;
    t.z_v_xy = z / rho;
  }
  return boussinesq_stress(t, nu);
}

/// Stress for a shear along x, without the factor 1/(2 pi).
SymTensor shear_corner(double X, double Y, double z, double nu)
{
  const double rho = std::sqrt(X * X + Y * Y + z * z);
  const double v_x = std::asinh(Y / std::hypot(X, z));
  const double v_y = std::asinh(X / std::hypot(Y, z));
  const double v_z = -std::atan2(X * Y, z * rho);
  const double plane = 2.0 * nu / (rho + z); // chi_1 with its factor 2 nu
  SymTensor stress{2.0 * v_x + plane * Y, 2.0 * nu * v_x - plane * Y, 0.0, 0.0, v_z, v_y - plane * X};
  if (z > 0.0)
  {
    const double across = z / rho;
    const double along = across / (X * X + z * z); // z V,xx = -X Y along
    const double bent = across / (rho + z);        // common factor of the third derivatives of chi
    stress[0] += Y * (bent - z * along);
    stress[1] -= Y * bent;
    stress[2] = z * Y * along;
    stress[3] = -across;
    stress[4] += X * Y * along;
    stress[5] -= X * bent;
  }
  return stress;
}

SymTensor scaled(double factor, SymTensor stress)
{
  for (double& component : stress)
    component *= factor;
  return stress;
}

} // namespace

double rectangle_displacement_corner(double X, double Y)
{
  return scaled_asinh(X, Y) + scaled_asinh(Y, X);
}

double rectangle_displacement(double x, double y, double dx, double dy)
{
  const double left = x - 0.5 * dx, right = x + 0.5 * dx;
  const double front = y - 0.5 * dy, back = y + 0.5 * dy;
  return rectangle_displacement_corner(right, back) - rectangle_displacement_corner(left, back) -
         rectangle_displacement_corner(right, front) + rectangle_displacement_corner(left, front);
}

SymTensor rectangle_stress_corner(double X, double Y, double z, double nu, Traction traction)
{
  constexpr double factor = 0.5 * std::numbers::inv_pi;
  switch (traction)
  {
  case Traction::pressure:
    return pressure_corner(X, Y, z, nu);
  case Traction::shear_x:
    return scaled(factor, shear_corner(X, Y, z, nu));
  case Traction::shear_y:
    return scaled(factor, xy_exchanged(shear_corner(Y, X, z, nu)));
  }
  throw InternalError("rectangle_stress_corner: no such traction");
}

SymTensor rectangle_stress(double x, double y, double z, double dx, double dy, double nu, Traction traction)
{
  const double left = x - 0.5 * dx, right = x + 0.5 * dx;
  const double front = y - 0.5 * dy, back = y + 0.5 * dy;
  const SymTensor rb = rectangle_stress_corner(right, back, z, nu, traction);
  const SymTensor lb = rectangle_stress_corner(left, back, z, nu, traction);
  const SymTensor rf = rectangle_stress_corner(right, front, z, nu, traction);
  const SymTensor lf = rectangle_stress_corner(left, front, z, nu, traction);
  SymTensor stress;
  for (std::size_t c = 0; c < stress.size(); ++c)
    stress[c] = rb[c] - lb[c] - rf[c] + lf[c];
  return stress;
}

} // namespace brinell::green
