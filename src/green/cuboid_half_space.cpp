// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/green/cuboid.hpp"
#include "green/boussinesq.hpp"
#include "green/image_potentials.hpp"

#include <cmath>
#include <numbers>

namespace brinell::green
{
namespace
{

/// All derivatives of order N - 1 in x and y: entry i is differentiated i times by y and N - 1 - i times by x.
template <std::size_t N>
using Derivatives = std::array<double, N>;

/// D = eps_xx d_xx + eps_yy d_yy + 2 eps_xy d_xy, from derivatives two orders higher.
template <std::size_t N>
Derivatives<N - 2> apply_in_plane(const SymTensor& eps, const Derivatives<N>& t)
{
  Derivatives<N - 2> result;
  for (std::size_t i = 0; i + 2 < N; ++i)
    result[i] = eps[0] * t[i] + 2.0 * eps[5] * t[i + 1] + eps[1] * t[i + 2];
  return result;
}

/// G = eps_xz d_x + eps_yz d_y, from derivatives one order higher.
template <std::size_t N>
Derivatives<N - 1> apply_transverse(const SymTensor& eps, const Derivatives<N>& t)
{
  Derivatives<N - 1> result;
  for (std::size_t i = 0; i + 1 < N; ++i)
    result[i] = eps[4] * t[i] + eps[3] * t[i + 1];
  return result;
}

/// Derivatives of the harmonic functions T_s .. T_{s+3} that W below needs; N - 1 is the order of derivatives of W.
template <std::size_t N>
struct Needed
{
  const Derivatives<N>&t0, &t1;         ///< T_s, T_{s+1}
  const Derivatives<N + 1>&t1_1, &t2_1; ///< one order higher: T_{s+1}, T_{s+2}
  const Derivatives<N + 2>&t2_2, &t3_2; ///< two orders higher: T_{s+2}, T_{s+3}
};

/// Bracket W = -(1 - nu) V/mu of one corner (see `cuboid_stress_half_space`) and its derivatives, for s = 0; any other
/// s raises the power of 1/k by s: -1 for -V,z, +1 for -chi. z_prime is the depth of the corner.
template <std::size_t N>
Derivatives<N> release(const SymTensor& eps, double nu, double z_prime, const Needed<N>& t)
{
  const auto d2 = apply_in_plane(eps, t.t2_2), d3 = apply_in_plane(eps, t.t3_2);
  const auto g1 = apply_transverse(eps, t.t1_1), g2 = apply_transverse(eps, t.t2_1);
  const double normal = 2.0 * (eps[2] + nu * (eps[0] + eps[1]));
  Derivatives<N> w;
  for (std::size_t i = 0; i < N; ++i)
    w[i] = -z_prime * (d2[i] + eps[2] * t.t0[i] + 2.0 * g1[i]) - 2.0 * nu * d3[i] - normal * t.t1[i] - 2.0 * g2[i];
  return w;
}

/// Contribution of one corner to the potentials of the pressure that frees the surface, divided by -mu/(1 - nu).
BoussinesqTerms corner_terms(double X, double Y, double z, double z_prime, const SymTensor& eps, double nu)
{
  const ImagePotentials t = image_potentials(X, Y, z + z_prime);
  const auto v_z = release<1>(eps, nu, z_prime, {t.minus1_0, t.t0_0, t.t0_1, t.t1_1, t.t1_2, t.t2_2});
  const auto v_1z = release<2>(eps, nu, z_prime, {t.minus1_1, t.t0_1, t.t0_2, t.t1_2, t.t1_3, t.t2_3});
  const auto v_2 = release<3>(eps, nu, z_prime, {t.t0_2, t.t1_2, t.t1_3, t.t2_3, t.t2_4, t.t3_4});
  const auto chi_2 = release<3>(eps, nu, z_prime, {t.t1_2, t.t2_2, t.t2_3, t.t3_3, t.t3_4, t.t4_4});
  return {.v_z = -v_z[0],
          .z_v_xx = z * v_2[0],
          .z_v_yy = z * v_2[2],
          .z_v_yz = -z * v_1z[1],
          .z_v_xz = -z * v_1z[0],
          .z_v_xy = z * v_2[1],
          .chi_xx = -chi_2[0],
          .chi_xy = -chi_2[1]};
}

/// Calls f(X, Y, z', sign) for the eight corners of a cuboid centred at depth zc.
template <class F>
void for_each_corner(double x, double y, double zc, double dx, double dy, double dz, F f)
{
  for (const double a : {0.5, -0.5})
    for (const double b : {0.5, -0.5})
      for (const double c : {0.5, -0.5})
        f(x + a * dx, y + b * dy, zc + c * dz, 8.0 * a * b * c);
}

} // namespace

SymTensor cuboid_stress_half_space(double x, double y, double z, double zc, double dx, double dy, double dz,
                                   const SymTensor& eigenstrain, const Elastic& elastic)
{
  const SymTensor mirrored{eigenstrain[0],  eigenstrain[1],  eigenstrain[2],
                           -eigenstrain[3], -eigenstrain[4], eigenstrain[5]};
  SymTensor stress = cuboid_stress(x, y, z - zc, dx, dy, dz, eigenstrain, elastic);
  const SymTensor image = cuboid_stress(x, y, z + zc, dx, dy, dz, mirrored, elastic);

  const double nu = elastic.poisson_ratio;
  SymTensor freeing{};
  for_each_corner(x, y, zc, dx, dy, dz,
                  [&](double X, double Y, double z_prime, double sign)
                  {
                    const SymTensor part = boussinesq_stress(corner_terms(X, Y, z, z_prime, eigenstrain, nu), nu);
                    for (std::size_t c = 0; c < 6; ++c)
                      freeing[c] += sign * part[c];
                  });
  for (std::size_t c = 0; c < 6; ++c)
    stress[c] += image[c] - elastic.shear_modulus() / (1.0 - nu) * freeing[c];
  return stress;
}

double cuboid_surface_displacement(double x, double y, double zc, double dx, double dy, double dz,
                                   const SymTensor& eigenstrain, double poisson_ratio)
{
  double sum = 0.0;
  for_each_corner(x, y, zc, dx, dy, dz,
                  [&](double X, double Y, double z_prime, double sign)
                  {
                    const ImagePotentials t = image_potentials(X, Y, z_prime);
                    sum += sign * release<1>(eigenstrain, poisson_ratio, z_prime,
                                             {t.t0_0, t.t1_0, t.t1_1, t.t2_1, t.t2_2, t.t3_2})[0];
                  });
  return -0.5 * std::numbers::inv_pi * sum;
}

} // namespace brinell::green
