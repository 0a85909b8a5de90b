// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/host_device.hpp"

#include <cmath>
#include <complex>

/// The waves of stress that a thin sheet of plastic strain causes in a half space, in the frame of its wavevector:
/// direction l along the surface, t across it, z down (docs/theory/half-space.md: (sheet-stress), (sheet-shear),
/// (free-surface)). Written for any number: `Real` is a double or several of them in lanes, `Cplx` the complex values of
/// the same kind, for which `times_i` gives i times a value. Of lanes, of a ComplexNumber and in a CUDA thread the text is this one.
namespace brinell::green
{

inline std::complex<double> times_i(const std::complex<double>& value)
{
  return {-value.imag(), value.real()};
}

/// Direction of the wavevector, and the products of its components. At a Nyquist index the sign of a component is not
/// defined: the component is zero there, but its square is not.
template <typename Real>
struct WaveDirection
{
  Real lx{}, ly{}, lx2{}, ly2{}, lxly{};
};

/// @param m, n  not both zero
BRINELL_HOST_DEVICE inline WaveDirection<double> direction_of(double m, double n)
{
  const double k = std::hypot(m, n);
  return {m / k, n / k, m * m / (k * k), n * n / (k * k), m * n / (k * k)};
}

/// Plastic strain in the frame of the wavevector.
template <typename Cplx>
struct SheetStrain
{
  Cplx a;          ///< (1 - 2 nu)(eps_ll + eps_zz)
  Cplx d;          ///< eps_ll - eps_zz
  Cplx lz, lt, tz; ///< shears
};

template <typename Real, typename Cplx>
BRINELL_HOST_DEVICE SheetStrain<Cplx> in_wave_frame(const WaveDirection<Real>& f, double nu, const Cplx& xx,
                                                    const Cplx& yy, const Cplx& yz, const Cplx& xz, const Cplx& xy)
{
  const Cplx ll = f.lx2 * xx + f.ly2 * yy + 2.0 * (f.lxly * xy);
  const Cplx zz = -1.0 * (xx + yy);
  return {(1.0 - 2.0 * nu) * (ll + zz), ll - zz, f.lx * xz + f.ly * yz, f.lxly * (yy - xx) + (f.lx2 - f.ly2) * xy,
          f.lx * yz - f.ly * xz};
}

/// Amplitudes of the waves that a sheet emits to one side: a and c in the plane of l and z, w across it.
template <typename Cplx>
struct SheetWave
{
  Cplx a, c, w;
};

/// @param g  +1 for the waves that go down, -1 for those that go up
template <typename Cplx>
BRINELL_HOST_DEVICE SheetWave<Cplx> wave_of(const SheetStrain<Cplx>& strain, double g)
{
  return {strain.a, strain.d + 2.0 * g * times_i(strain.lz), strain.lt + g * times_i(strain.tz)};
}

/// The downward wave from the surface that, together with Boussinesq's pressure, cancels the traction of the upward waves.
/// `up` contains the sums of these waves at the surface, each with its decay from its source, and `lagging` is the sum of
/// k z' c.
template <typename Cplx>
BRINELL_HOST_DEVICE SheetWave<Cplx> reflected(const SheetWave<Cplx>& up, const Cplx& lagging)
{
  const Cplx f = up.a - lagging;
  return {-1.0 * f, up.c + 2.0 * f, up.w};
}

/// Deviator of the stress in the axes x, y, z (order of Deviator), and its trace.
template <typename Cplx>
struct AxesStress
{
  Cplx xx, yy, yz, xz, xy, trace;
};

template <typename Real, typename Cplx>
BRINELL_HOST_DEVICE AxesStress<Cplx> in_axes(const WaveDirection<Real>& f, double nu, const Cplx& ll, const Cplx& zz,
                                             const Cplx& lz, const Cplx& lt, const Cplx& tz)
{
  const Cplx trace = (1.0 + nu) * (ll + zz); // sigma_tt = nu (ll + zz): plane strain across the wavevector
  const Cplx deviator_ll = ll - (1.0 / 3.0) * trace;
  const Cplx deviator_tt = -1.0 * (deviator_ll + (zz - (1.0 / 3.0) * trace));
  const Cplx cross = 2.0 * (f.lxly * lt);
  return {f.lx2 * deviator_ll + f.ly2 * deviator_tt - cross,
          f.ly2 * deviator_ll + f.lx2 * deviator_tt + cross,
          f.ly * lz + f.lx * tz,
          f.lx * lz - f.ly * tz,
          f.lxly * (deviator_ll - deviator_tt) + (f.lx2 - f.ly2) * lt,
          trace};
}

} // namespace brinell::green
