// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/host_device.hpp"
#include "green/sheet_waves.hpp"

#include <cmath>

/// Waves of plastic strain that pass from one layer of cells to the next, as running sums, for any number: see green/sheet_waves.hpp
/// for `Real` and `Cplx`. Their names for lanes: layer_waves.hpp.
namespace brinell::halfspace::layer_waves
{

/// Factors of a wavenumber, or of several in lanes. All couplings are zero for k = 0 and in lanes without a wavenumber.
/// At a Nyquist index lx or ly is zero, or reduced; this also drops the couplings of even order through the shears yz and xz,
/// which are negligible for a strain that the cells resolve. The contribution of couplings of odd order there is imaginary in a
/// row along x and is ignored by the inverse transform of the row.
template <typename Real>
struct FactorsOf : green::WaveDirection<Real>
{
  Real q{};                    ///< e^{-x}, x = k dz: decay over a layer
  Real e0{}, e1{}, e2{}, e3{}; ///< stress of arriving waves in the next layer
  Real m0{}, m1{}, m2{};       ///< stress of a layer in the layer itself
  Real x{}, rise{}, lag{};     ///< conversion of a wave at a boundary of layers to that of a sheet there
};

/// Factors of a wavenumber (m, n) [rad/m].
/// @param kept_x, kept_y  fractions of m / k and n / k that are retained
BRINELL_HOST_DEVICE inline FactorsOf<double> factors_of(double m, double n, double kept_x, double kept_y, double dz,
                                                        double nu, double mu)
{
  FactorsOf<double> f;
  const double k = std::hypot(m, n);
  if (k == 0.0)
  {
    f.lx2 = 1.0; // any direction: every non-local factor is zero
    return f;
  }
  f.lx2 = m * m / (k * k);
  f.ly2 = n * n / (k * k);
  f.lx = kept_x * m / k;
  f.ly = kept_y * n / k;
  f.lxly = f.lx * f.ly;
  const double stiffness = mu / (2.0 * (1.0 - nu));
  f.x = k * dz;
  f.q = std::exp(-f.x);
  const double s0 = -std::expm1(-f.x) / f.x; // mean of e^{-kz} over a layer
  const double s1 = 0.5 * (1.0 + f.q) - s0;  // mean of k (dz / 2 - z) e^{-kz} over a layer
  const double g1 = -std::expm1(-2.0 * f.x) / (2.0 * f.x) - s0 * s0;
  f.e0 = stiffness * f.x * s0 * s0;
  f.e1 = f.e0 * f.x;
  f.e2 = 2.0 * stiffness * f.x * g1;
  f.e3 = mu * f.x * s0 * s0;
  f.m0 = stiffness * 2.0 * (1.0 - s0);
  f.m1 = -stiffness * 2.0 * (f.x * s0 - 2.0 * (1.0 - s0));
  f.m2 = mu * 2.0 * (1.0 - s0);
  f.rise = s1 / s0;
  f.lag = 0.5 - s1 / (f.x * s0) + 2.0 * g1 / (f.x * s0 * s0);
  return f;
}

/// Amplitudes of the waves in one direction, each a running sum over the layers passed.
template <typename Cplx>
struct WaveOf
{
  Cplx a, c, c1, w; ///< sum of a, of c, of c times the number of layers passed, and of w
};

/// Stress in the frame of the wavevector; lz and lt also stand for the shears lz and tz, without their factor +-i.
template <typename Cplx>
struct FieldOf
{
  Cplx ll, zz, lz, lt;
};

/// Values of a layer that an upward pass stores for the downward pass.
template <typename Cplx>
struct LayerOf
{
  green::SheetStrain<Cplx> strain;
  Cplx below_ll, below_zz, below_lz, below_lt; ///< stress of the waves from below
};

/// Mean stress in the next layer of the waves that arrive there.
template <typename Real, typename Cplx>
BRINELL_HOST_DEVICE inline FieldOf<Cplx> emit(const FactorsOf<Real>& f, const WaveOf<Cplx>& wave)
{
  const Cplx ea = f.e0 * wave.a;
  const Cplx ec = f.e0 * wave.c;
  const Cplx sc = f.e1 * wave.c1 - f.e2 * wave.c;
  const Cplx lz = ea + ec - sc;
  return {lz + ec, sc - ea, lz, f.e3 * wave.w};
}

/// Propagates the waves through one layer and adds those of its strain; g = +1 downwards, -1 upwards.
template <typename Real, typename Cplx>
BRINELL_HOST_DEVICE inline void advance(const FactorsOf<Real>& f, const green::SheetStrain<Cplx>& strain, double g,
                                        WaveOf<Cplx>& wave)
{
  const green::SheetWave<Cplx> source = green::wave_of(strain, g);
  wave.c1 = f.q * (wave.c1 + wave.c) + source.c;
  wave.c = f.q * wave.c + source.c;
  wave.a = f.q * wave.a + source.a;
  wave.w = f.q * wave.w + source.w;
}

/// Propagates the waves through one layer without strain.
template <typename Real, typename Cplx>
BRINELL_HOST_DEVICE inline void pass(const FactorsOf<Real>& f, WaveOf<Cplx>& wave)
{
  wave.c1 = f.q * (wave.c1 + wave.c);
  wave.c = f.q * wave.c;
  wave.a = f.q * wave.a;
  wave.w = f.q * wave.w;
}

/// Sum of k z' c over the layers passed, for waves at a boundary of layers.
template <typename Real, typename Cplx>
BRINELL_HOST_DEVICE inline Cplx lagging(const FactorsOf<Real>& f, const WaveOf<Cplx>& wave)
{
  return f.x * (wave.c1 - 0.5 * wave.c) - f.rise * wave.c;
}

/// The waves at a boundary of layers, like those of a sheet there.
template <typename Real, typename Cplx>
BRINELL_HOST_DEVICE inline green::SheetWave<Cplx> at_boundary(const FactorsOf<Real>& f, const WaveOf<Cplx>& wave)
{
  return {wave.a - lagging(f, wave), wave.c, wave.w};
}

/// The running sums of a wave that starts at a boundary of layers. The amplitudes are such that `emit` gives the mean over the next
/// layer of a sheet at the boundary, where it expects layers behind.
template <typename Real, typename Cplx>
BRINELL_HOST_DEVICE inline WaveOf<Cplx> from_boundary(const FactorsOf<Real>& f, const green::SheetWave<Cplx>& wave)
{
  return {wave.a, wave.c, f.lag * wave.c, wave.w};
}

/// The image of the waves that have arrived at the free surface of a homogeneous body, on its way down.
template <typename Real, typename Cplx>
BRINELL_HOST_DEVICE inline WaveOf<Cplx> reflect(const FactorsOf<Real>& f, const WaveOf<Cplx>& up)
{
  return from_boundary(f, green::reflected<Cplx>({up.a, up.c, up.w}, lagging(f, up)));
}

/// Adds the stress of a layer in itself and that of the layers below to the stress `s` of the layers above. @returns the total
/// tz: for the layers above and below it follows from lt up to the factor +-i, but not for the layer itself.
template <typename Real, typename Cplx>
BRINELL_HOST_DEVICE inline Cplx add_own(const FactorsOf<Real>& f, const LayerOf<Cplx>& layer, FieldOf<Cplx>& s)
{
  const green::SheetStrain<Cplx>& own = layer.strain;
  const Cplx held = f.m0 * own.a - f.m1 * own.d;
  const Real twice = 2.0 * f.m0;
  const Cplx tz = times_i(s.lt - layer.below_lt) - f.m2 * own.tz;
  s.ll = s.ll + layer.below_ll + held + twice * own.d;
  s.zz = s.zz + layer.below_zz - held;
  s.lz = times_i(s.lz - layer.below_lz) - (twice - 2.0 * f.m1) * own.lz;
  s.lt = s.lt + layer.below_lt + f.m2 * own.lt;
  return tz;
}

/// Stress of a uniform, unbounded layer of plastic strain that is held in its plane, per strain [Pa]: plane stress across it.
struct HeldLayer
{
  double own, other; ///< deviatoric stress xx by the strain xx and by the strain yy; for yy the other way round
  double trace;      ///< by either of them
  double shear;      ///< xy
};
BRINELL_HOST_DEVICE inline HeldLayer held_layer(double nu, double mu)
{
  const double stiffness = -2.0 * mu / (1.0 - nu);
  return {stiffness * (2.0 - nu) / 3.0, stiffness * (2.0 * nu - 1.0) / 3.0, stiffness * (1.0 + nu), -2.0 * mu};
}

} // namespace brinell::halfspace::layer_waves
