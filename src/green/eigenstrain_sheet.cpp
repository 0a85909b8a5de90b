// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/green/eigenstrain_sheet.hpp"

#include "sheet_waves.hpp"

#include <cmath>
#include <complex>

namespace brinell::green
{

namespace
{

using Complex = std::complex<double>;

/// Stress in the frame of the wavevector [Pa/m]; the shears lz and tz without their factor g i.
struct Field
{
  Complex ll, zz, lz, lt;
};

/// Stress of a wave at a distance of s = k |z - z'| from where it started.
Field emitted(const SheetWave<Complex>& wave, double s, double k, const Elastic& elastic)
{
  const double mu = elastic.shear_modulus();
  const double p = mu * k / (2.0 * (1.0 - elastic.poisson_ratio)) * std::exp(-s);
  return {p * (wave.a + (2.0 - s) * wave.c), p * (s * wave.c - wave.a), p * (wave.a + (1.0 - s) * wave.c),
          mu * k * std::exp(-s) * wave.w};
}

} // namespace

SheetStress eigenstrain_sheet_stress(double m, double n, double z, double z_source, const Deviator& strain,
                                     const Elastic& elastic)
{
  using D = Deviator;
  const double k = std::hypot(m, n);
  const double lx = m / k;
  const double ly = n / k;
  const double nu = elastic.poisson_ratio;
  const WaveDirection<double> direction{lx, ly, lx * lx, ly * ly, lx * ly};
  const SheetStrain<Complex> sheet = in_wave_frame<double, Complex>(direction, nu, strain[D::xx], strain[D::yy],
                                                                    strain[D::yz], strain[D::xz], strain[D::xy]);
  const SheetWave<Complex> up = wave_of(sheet, -1.0);
  const double decay = std::exp(-k * z_source); // on the way up to the surface
  const SheetWave<Complex> arrived{decay * up.a, decay * up.c, decay * up.w};
  const Field from_image = emitted(reflected(arrived, Complex(k * z_source * arrived.c)), k * z, k, elastic);
  // In the plane of the sheet itself, the mean of what its two sides send out.
  const Field below = emitted(wave_of(sheet, 1.0), k * std::abs(z - z_source), k, elastic);
  const Field above = emitted(up, k * std::abs(z - z_source), k, elastic);
  const double down_share = z > z_source ? 1.0 : z < z_source ? 0.0 : 0.5;
  const double up_share = 1.0 - down_share;

  const Complex ll = down_share * below.ll + up_share * above.ll + from_image.ll;
  const Complex zz = down_share * below.zz + up_share * above.zz + from_image.zz;
  const Complex lt = down_share * below.lt + up_share * above.lt + from_image.lt;
  const Complex lz = times_i(down_share * below.lz - up_share * above.lz + from_image.lz);
  const Complex tz = times_i(down_share * below.lt - up_share * above.lt + from_image.lt);
  const AxesStress<Complex> stress = in_axes(direction, nu, ll, zz, lz, lt, tz);
  return {{stress.xx, stress.yy, stress.yz, stress.xz, stress.xy}, stress.trace};
}

} // namespace brinell::green
