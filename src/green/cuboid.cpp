// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/green/cuboid.hpp"

#include <cmath>
#include <numbers>

namespace brinell::green
{
namespace
{

/// Position in CuboidPotentials::psi of the derivative by two components, both in the order of SymTensor.
constexpr std::array<std::array<std::size_t, 6>, 6> psi_index{{{0, 3, 5, 12, 7, 6},
                                                               {3, 1, 4, 9, 13, 8},
                                                               {5, 4, 2, 11, 10, 14},
                                                               {12, 9, 11, 4, 14, 13},
                                                               {7, 13, 10, 14, 5, 12},
                                                               {6, 8, 14, 13, 12, 3}}};

/// -atan(Y Z/(X R)), the mean of both sides on the face X = 0.
double face_angle(double X, double YZ, double R)
{
  return X == 0.0 ? 0.0 : -std::atan(YZ / (X * R));
}

/// asinh(Z/s), s2 = s^2. On the line s = 0 the term -ln s, which is common to both ends of an edge, is omitted.
double edge_logarithm(double Z, double R, double s2)
{
  const double far = std::log(std::abs(Z) + R);
  const double magnitude = s2 > 0.0 ? far - 0.5 * std::log(s2) : far; // the finite part may be negative
  return Z < 0.0 ? -magnitude : magnitude;
}

double guarded_inverse(double s2)
{
  return s2 > 0.0 ? 1.0 / s2 : 0.0;
}

/// (eps phi + phi eps)/2 of two symmetric tensors.
SymTensor symmetric_product(const SymTensor& a, const SymTensor& b)
{
  return {a[0] * b[0] + a[5] * b[5] + a[4] * b[4],
          a[5] * b[5] + a[1] * b[1] + a[3] * b[3],
          a[4] * b[4] + a[3] * b[3] + a[2] * b[2],
          0.5 * (a[5] * b[4] + a[1] * b[3] + a[3] * b[2] + a[4] * b[5] + a[3] * b[1] + a[2] * b[3]),
          0.5 * (a[0] * b[4] + a[5] * b[3] + a[4] * b[2] + a[4] * b[0] + a[3] * b[5] + a[2] * b[4]),
          0.5 * (a[0] * b[5] + a[5] * b[1] + a[4] * b[3] + a[5] * b[0] + a[1] * b[5] + a[3] * b[4])};
}

/// eps_jl psi,ijkl.
SymTensor contracted(const std::array<double, 15>& psi, const SymTensor& eps)
{
  SymTensor result;
  for (std::size_t c = 0; c < 6; ++c)
  {
    const auto& at = psi_index[c];
    result[c] = eps[0] * psi[at[0]] + eps[1] * psi[at[1]] + eps[2] * psi[at[2]] +
                2.0 * (eps[3] * psi[at[3]] + eps[4] * psi[at[4]] + eps[5] * psi[at[5]]);
  }
  return result;
}

/// 1 between the two faces, 1/2 on one of them, 0 beyond: the rule of `face_angle`.
double between(double near, double far)
{
  const auto sign = [](double t) { return static_cast<double>((t > 0.0) - (t < 0.0)); };
  return 0.5 * (sign(near) - sign(far));
}

void add(CuboidPotentials& sum, const CuboidPotentials& part, double sign)
{
  for (std::size_t i = 0; i < sum.phi.size(); ++i)
    sum.phi[i] += sign * part.phi[i];
  for (std::size_t i = 0; i < sum.psi.size(); ++i)
    sum.psi[i] += sign * part.psi[i];
}

} // namespace

CuboidPotentials cuboid_potentials_corner(double X, double Y, double Z)
{
  const double x2 = X * X, y2 = Y * Y, z2 = Z * Z;
  const double R = std::sqrt(x2 + y2 + z2);
  const double inverse_R = guarded_inverse(R);
  const double xi = X * inverse_R, eta = Y * inverse_R, zeta = Z * inverse_R;
  const double inverse_xy = guarded_inverse(x2 + y2);
  const double inverse_yz = guarded_inverse(y2 + z2);
  const double inverse_xz = guarded_inverse(x2 + z2);
  const double log_x = edge_logarithm(X, R, y2 + z2);
  const double log_y = edge_logarithm(Y, R, x2 + z2);
  const double log_z = edge_logarithm(Z, R, x2 + y2);

  CuboidPotentials p;
  p.phi = {face_angle(X, Y * Z, R), face_angle(Y, X * Z, R), face_angle(Z, X * Y, R), log_x, log_y, log_z};
  const double xyz = X * Y * zeta;
  const double xxyy = -xyz * inverse_xy, yyzz = -xyz * inverse_yz, xxzz = -xyz * inverse_xz;
  p.psi = {2.0 * p.phi[0] - xxyy - xxzz,
           2.0 * p.phi[1] - xxyy - yyzz,
           2.0 * p.phi[2] - xxzz - yyzz,
           xxyy,
           yyzz,
           xxzz,
           log_z - x2 * zeta * inverse_xy, // xxxy
           log_y - x2 * eta * inverse_xz,  // xxxz
           log_z - y2 * zeta * inverse_xy, // yyyx
           log_x - y2 * xi * inverse_yz,   // yyyz
           log_y - z2 * eta * inverse_xz,  // zzzx
           log_x - z2 * xi * inverse_yz,   // zzzy
           xi,
           eta,
           zeta};
  return p;
}

CuboidPotentials cuboid_potentials(double x, double y, double z, double dx, double dy, double dz)
{
  CuboidPotentials sum;
  for (const double a : {0.5, -0.5})
    for (const double b : {0.5, -0.5})
      for (const double c : {0.5, -0.5})
        add(sum, cuboid_potentials_corner(x + a * dx, y + b * dy, z + c * dz), 8.0 * a * b * c);
  return sum;
}

SymTensor eigenstrain_stress(const CuboidPotentials& potentials, double inside, const SymTensor& eigenstrain,
                             const Elastic& elastic)
{
  const double nu = elastic.poisson_ratio;
  const double mu = elastic.shear_modulus();
  const double theta = trace(eigenstrain);
  const SymTensor biharmonic = contracted(potentials.psi, eigenstrain);
  const SymTensor product = symmetric_product(eigenstrain, potentials.phi);
  // Trace of the elastic strain times nu/(1 - 2 nu), with the factor 1 - 2 nu cancelled.
  const double dilatation =
      -nu / (1.0 - nu) * (double_contraction(eigenstrain, potentials.phi) / (4.0 * std::numbers::pi) + inside * theta);
  const double f = 1.0 / (8.0 * std::numbers::pi * (1.0 - nu));
  SymTensor stress;
  for (std::size_t c = 0; c < 6; ++c)
  {
    const double strain = f * (biharmonic[c] - 2.0 * nu * theta * potentials.phi[c] - 4.0 * (1.0 - nu) * product[c]);
    stress[c] = 2.0 * mu * (strain - inside * eigenstrain[c] + (c < 3 ? dilatation : 0.0));
  }
  return stress;
}

SymTensor cuboid_stress(double x, double y, double z, double dx, double dy, double dz, const SymTensor& eigenstrain,
                        const Elastic& elastic)
{
  const double inside =
      between(x + 0.5 * dx, x - 0.5 * dx) * between(y + 0.5 * dy, y - 0.5 * dy) * between(z + 0.5 * dz, z - 0.5 * dz);
  return eigenstrain_stress(cuboid_potentials(x, y, z, dx, dy, dz), inside, eigenstrain, elastic);
}

} // namespace brinell::green
