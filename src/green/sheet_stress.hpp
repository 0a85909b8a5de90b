// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/green/elastic.hpp"
#include "green/sheet_waves.hpp"

/// Stress of a thin sheet of plastic strain with one wavevector, summed from its waves. `Real` is a double, or several pairs of
/// depths in lanes.
namespace brinell::green
{

/// Factors that depend on the depths of the sheet and of the point, but not on the strain.
template <typename Real>
struct SheetPath
{
  Real s;                    ///< k |z - z'|
  Real kz, kz_source;        ///< wavenumber times the depths of the point and of the sheet
  Real direct, from_image;   ///< e^{-s} from the sheet, and e^{-k z} from the surface
  Real to_surface;           ///< e^{-k z'}
  Real down_share, up_share; ///< weights of the downward and upward wave: 1, 0 below the sheet; 0, 1 above; 1/2 in it
};

/// Stiffness of the waves [Pa/m per unit strain].
struct SheetStiffness
{
  double in_plane, across;
  SheetStiffness(double k, const Elastic& elastic)
      : in_plane(elastic.shear_modulus() * k / (2.0 * (1.0 - elastic.poisson_ratio))),
        across(elastic.shear_modulus() * k)
  {
  }
};

/// Waves that a sheet emits downwards and upwards.
template <typename Cplx>
struct SheetSource
{
  SheetWave<Cplx> down, up;
  explicit SheetSource(const SheetStrain<Cplx>& strain) : down(wave_of(strain, 1.0)), up(wave_of(strain, -1.0)) {}
  SheetSource(const SheetWave<Cplx>& down_, const SheetWave<Cplx>& up_) : down(down_), up(up_) {}
};

/// Stress in the frame of the wavevector [Pa/m]; the shears lz and tz without their factor g i.
template <typename Cplx>
struct SheetField
{
  Cplx ll, zz, lz, lt;
};

/// Stress of a wave at the distance s = k |z - z'| from its source.
template <typename Real, typename Cplx>
SheetField<Cplx> emitted(const SheetWave<Cplx>& wave, const Real& s, const Real& decay, const SheetStiffness& stiffness)
{
  const Real p = stiffness.in_plane * decay;
  return {p * (wave.a + (2.0 - s) * wave.c), p * (s * wave.c - wave.a), p * (wave.a + (1.0 - s) * wave.c),
          (stiffness.across * decay) * wave.w};
}

template <typename Real, typename Cplx>
AxesStress<Cplx> sheet_stress(const SheetSource<Cplx>& sheet, const SheetPath<Real>& path,
                              const SheetStiffness& stiffness, const WaveDirection<double>& towards, double nu)
{
  const SheetWave<Cplx> arrived{path.to_surface * sheet.up.a, path.to_surface * sheet.up.c,
                                path.to_surface * sheet.up.w};
  const SheetField<Cplx> image =
      emitted(reflected(arrived, Cplx(path.kz_source * arrived.c)), path.kz, path.from_image, stiffness);
  const SheetField<Cplx> below = emitted(sheet.down, path.s, path.direct, stiffness);
  const SheetField<Cplx> above = emitted(sheet.up, path.s, path.direct, stiffness);
  const auto both = [&](const Cplx& down, const Cplx& up, const Cplx& reflected_part)
  { return path.down_share * down + path.up_share * up + reflected_part; };
  const Cplx ll = both(below.ll, above.ll, image.ll);
  const Cplx zz = both(below.zz, above.zz, image.zz);
  const Cplx lt = both(below.lt, above.lt, image.lt);
  const Cplx lz = times_i(both(below.lz, -1.0 * above.lz, image.lz));
  const Cplx tz = times_i(both(below.lt, -1.0 * above.lt, image.lt));
  return in_axes(towards, nu, ll, zz, lz, lt, tz);
}

} // namespace brinell::green
