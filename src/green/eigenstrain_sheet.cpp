// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/green/eigenstrain_sheet.hpp"

#include <cmath>

namespace brinell::green
{

SheetStress eigenstrain_sheet_stress(double m, double n, double z, double z_source, const Deviator& strain,
                                     const Elastic& elastic)
{
  using D = Deviator;
  const double k = std::hypot(m, n);
  const double lx = m / k;
  const double ly = n / k;
  const double nu = elastic.poisson_ratio;
  const double mu = elastic.shear_modulus();
  const double p = mu * k / (2.0 * (1.0 - nu));
  const Complex i(0.0, 1.0);

  const double eps_ll = lx * lx * strain[D::xx] + ly * ly * strain[D::yy] + 2.0 * lx * ly * strain[D::xy];
  const double eps_zz = -strain[D::xx] - strain[D::yy];
  const double eps_lz = lx * strain[D::xz] + ly * strain[D::yz];
  const double eps_lt = lx * ly * (strain[D::yy] - strain[D::xx]) + (lx * lx - ly * ly) * strain[D::xy];
  const double eps_tz = lx * strain[D::yz] - ly * strain[D::xz];
  const double a = (1.0 - 2.0 * nu) * (eps_ll + eps_zz);

  // Direct part: waves that leave the sheet downwards (g = 1) or upwards (g = -1).
  const double g = z >= z_source ? 1.0 : -1.0;
  const double s = k * std::abs(z - z_source);
  const double direct = std::exp(-s);
  const Complex c = eps_ll - eps_zz + 2.0 * g * i * eps_lz;
  const Complex w = eps_lt + g * i * eps_tz;
  Complex ll = p * direct * (a + (2.0 - s) * c);
  Complex zz = p * direct * (s * c - a);
  Complex lz = g * i * p * direct * (a + (1.0 - s) * c);
  Complex lt = mu * k * direct * w;
  Complex tz = g * i * lt;
  if (z == z_source) // the mean of both sides
  {
    const Complex c_even = eps_ll - eps_zz;
    ll = p * (a + 2.0 * c_even);
    zz = -p * a;
    lz = -2.0 * p * eps_lz;
    lt = mu * k * eps_lt;
    tz = -mu * k * eps_tz;
  }

  // Image and the pressure that frees the surface.
  const Complex c_up = eps_ll - eps_zz - 2.0 * i * eps_lz;
  const Complex w_up = eps_lt - i * eps_tz;
  const double reflected = std::exp(-k * (z + z_source));
  const Complex f = a - k * z_source * c_up;
  const Complex v = c_up + 2.0 * f;
  ll += p * reflected * (f + v + c_up - k * z * v);
  zz += p * reflected * (f + k * z * v);
  lz += i * p * reflected * (f + c_up - k * z * v);
  lt += mu * k * reflected * w_up;
  tz += i * mu * k * reflected * w_up;

  const Complex tt = nu * (ll + zz);
  const Complex mean = (ll + tt + zz) / 3.0;
  return {{lx * lx * (ll - mean) + ly * ly * (tt - mean) - 2.0 * lx * ly * lt,
           ly * ly * (ll - mean) + lx * lx * (tt - mean) + 2.0 * lx * ly * lt, ly * lz + lx * tz, lx * lz - ly * tz,
           lx * ly * (ll - tt) + (lx * lx - ly * ly) * lt},
          3.0 * mean};
}

} // namespace brinell::green
