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

/// Between the sheet, the surface and the point: what does not depend on the strain.
struct Path
{
  double k;                  ///< wavenumber
  double direct, from_image; ///< e^{-s} from the sheet, and from the surface
  double to_surface;         ///< e^{-k z'}
  double z, z_source;        ///< depths of the point and of the sheet
  double in_plane, across;   ///< stiffness of the waves
  WaveDirection<double> towards;

  Path(double m, double n, double z_, double z_source_, const Elastic& elastic)
      : k(std::hypot(m, n)), direct(std::exp(-k * std::abs(z_ - z_source_))), from_image(std::exp(-k * z_)),
        to_surface(std::exp(-k * z_source_)), z(z_), z_source(z_source_),
        in_plane(elastic.shear_modulus() * k / (2.0 * (1.0 - elastic.poisson_ratio))),
        across(elastic.shear_modulus() * k), towards{m / k, n / k, m * m / (k * k), n * n / (k * k), m * n / (k * k)}
  {
  }
};

/// Stress of a wave at a distance of s = k |z - z'| from where it started.
Field emitted(const SheetWave<Complex>& wave, double s, double decay, const Path& path)
{
  const double p = path.in_plane * decay;
  return {p * (wave.a + (2.0 - s) * wave.c), p * (s * wave.c - wave.a), p * (wave.a + (1.0 - s) * wave.c),
          path.across * decay * wave.w};
}

SheetStress stress_along(const Path& path, const Deviator& strain, double nu)
{
  using D = Deviator;
  const SheetStrain<Complex> sheet = in_wave_frame<double, Complex>(path.towards, nu, strain[D::xx], strain[D::yy],
                                                                    strain[D::yz], strain[D::xz], strain[D::xy]);
  const SheetWave<Complex> up = wave_of(sheet, -1.0);
  const SheetWave<Complex> arrived{path.to_surface * up.a, path.to_surface * up.c, path.to_surface * up.w};
  const Field from_image =
      emitted(reflected(arrived, Complex(path.k * path.z_source * arrived.c)), path.k * path.z, path.from_image, path);
  // In the plane of the sheet itself, the mean of what its two sides send out.
  const double s = path.k * std::abs(path.z - path.z_source);
  const Field below = emitted(wave_of(sheet, 1.0), s, path.direct, path);
  const Field above = emitted(up, s, path.direct, path);
  const double down_share = path.z > path.z_source ? 1.0 : path.z < path.z_source ? 0.0 : 0.5;
  const double up_share = 1.0 - down_share;

  const Complex ll = down_share * below.ll + up_share * above.ll + from_image.ll;
  const Complex zz = down_share * below.zz + up_share * above.zz + from_image.zz;
  const Complex lt = down_share * below.lt + up_share * above.lt + from_image.lt;
  const Complex lz = times_i(down_share * below.lz - up_share * above.lz + from_image.lz);
  const Complex tz = times_i(down_share * below.lt - up_share * above.lt + from_image.lt);
  const AxesStress<Complex> stress = in_axes(path.towards, nu, ll, zz, lz, lt, tz);
  return {{stress.xx, stress.yy, stress.yz, stress.xz, stress.xy}, stress.trace};
}

} // namespace

SheetStress eigenstrain_sheet_stress(double m, double n, double z, double z_source, const Deviator& strain,
                                     const Elastic& elastic)
{
  return stress_along(Path(m, n, z, z_source, elastic), strain, elastic.poisson_ratio);
}

std::array<SheetStress, Deviator::size> unit_sheet_stresses(double m, double n, double z, double z_source,
                                                            const Elastic& elastic)
{
  const Path path(m, n, z, z_source, elastic);
  std::array<SheetStress, Deviator::size> result;
  for (int e = 0; e < Deviator::size; ++e)
  {
    Deviator unit;
    unit[e] = 1.0;
    result[static_cast<std::size_t>(e)] = stress_along(path, unit, elastic.poisson_ratio);
  }
  return result;
}

} // namespace brinell::green
