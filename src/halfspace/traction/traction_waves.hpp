// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/deviator.hpp"
#include "brinell/foundation/host_device.hpp"
#include "brinell/foundation/sym_tensor.hpp"
#include "brinell/green/traction.hpp"

#include <array>
#include <cmath>

/// Stress under waves of traction on a homogeneous half space, as means over layers.
namespace brinell::halfspace
{

/// Values of a stress that are stored, in the order of the kernels.
BRINELL_HOST_DEVICE inline std::array<double, 6> kernel_values(const SymTensor& t)
{
  const double mean = trace(t) / 3.0;
  return {t[0] - mean, t[1] - mean, t[3], t[4], t[5], trace(t)};
}

/// Whether one of the `kernel_values` is odd in x and in y. Its spectrum is imaginary if it is odd in exactly one of them, otherwise
/// real.
struct Oddness
{
  bool x, y;
};
BRINELL_HOST_DEVICE inline Oddness oddness(Traction traction, int which)
{
  const bool odd_x = which == Deviator::xz || which == Deviator::xy;
  const bool odd_y = which == Deviator::yz || which == Deviator::xy;
  return {odd_x != (traction == Traction::shear_x), odd_y != (traction == Traction::shear_y)};
}

/// Depth factors of a wave, as means over a layer.
struct LayerMean
{
  double level;  ///< of e^{-kz}
  double rising; ///< of k z e^{-kz}
};

BRINELL_HOST_DEVICE inline LayerMean mean_decay(double thickness, int layer)
{
  const double top = layer * thickness;
  const double mean = -std::expm1(-thickness) / thickness;
  return {std::exp(-top) * mean, std::exp(-top) * ((1.0 + top) * mean - std::exp(-thickness))};
}

namespace detail
{

BRINELL_HOST_DEVICE inline SymTensor shear_x_wave(double lx, double ly, const LayerMean& decay, double nu)
{
  const double xx = lx * lx, yy = ly * ly;
  const double ll = 2.0 * decay.level - decay.rising;
  const double tt = 2.0 * nu * decay.level;
  const double lz = decay.rising - decay.level;
  const double lt = decay.level;
  const double tz = -decay.level;
  return {lx * (xx * ll + yy * (tt + 2.0 * lt)),
          lx * (yy * (ll - 2.0 * lt) + xx * tt),
          lx * decay.rising,
          lx * ly * (lz - tz),
          xx * lz + yy * tz,
          ly * (xx * (ll - tt) + (yy - xx) * lt)};
}

} // namespace detail

/// With l along the wavevector and t across it, the stress of a wave of unit pressure is e^{-kz} times
///     ll = -(1 - k z)    zz = -(1 + k z)    tt = -2 nu    lz = i k z
/// that of a wave of unit shear along l
///     ll = i (2 - k z)   zz = i k z         tt = 2 i nu   lz = -(1 - k z)
/// and that of one along t: lt = i, tz = -1 (Johnson 1985, section 13.2; docs/theory/half-space.md).
/// @param lx, ly  components of the unit vector along l
/// @return  amplitudes, without the factor i in those that are odd in x and even in y, or the other way round
BRINELL_HOST_DEVICE inline SymTensor wave_stress(Traction traction, double lx, double ly, const LayerMean& decay,
                                                 double nu)
{
  switch (traction)
  {
  case Traction::shear_x:
    return detail::shear_x_wave(lx, ly, decay, nu);
  case Traction::shear_y:
    return xy_exchanged(detail::shear_x_wave(ly, lx, decay, nu));
  case Traction::pressure:
    break;
  }
  const double xx = lx * lx, yy = ly * ly;
  const double ll = decay.rising - decay.level;
  const double tt = -2.0 * nu * decay.level;
  return {xx * ll + yy * tt, yy * ll + xx * tt, -decay.rising - decay.level,
          ly * decay.rising, lx * decay.rising, lx * ly * (ll - tt)};
}

/// Stress of a uniform unit traction, without mean strain in the plane.
BRINELL_HOST_DEVICE inline SymTensor uniform_stress(Traction traction, double nu)
{
  const double held = -nu / (1.0 - nu);
  switch (traction)
  {
  case Traction::pressure:
    return {held, held, -1.0, 0.0, 0.0, 0.0};
  case Traction::shear_x:
    return {0.0, 0.0, 0.0, 0.0, -1.0, 0.0};
  case Traction::shear_y:
    break;
  }
  return {0.0, 0.0, 0.0, -1.0, 0.0, 0.0};
}

/// Displacement of the surface by the plastic strain of a layer, conjugate to a traction, per thickness (Betti): docs/theory/half-space.md
/// (residual-displacement).
/// @param is_pressure  whether the traction is the pressure, not a shear
/// @param times        times(c, e): the stored number of the kernel c of this traction times e
template <typename IsPressure, typename Times, typename Cplx>
BRINELL_HOST_DEVICE inline Cplx betti_product(IsPressure is_pressure, const Times& times, const Cplx& xx,
                                              const Cplx& yy, const Cplx& yz, const Cplx& xz, const Cplx& xy)
{
  const Cplx sum = xx + yy;
  const Cplx in_plane = times(Deviator::xx, xx + sum) + times(Deviator::yy, yy + sum) + 2.0 * times(Deviator::xy, xy);
  const Cplx across = 2.0 * (times(Deviator::yz, yz) + times(Deviator::xz, xz));
  // The kernel of the transpose is the conjugate: conj(i K) = -i K.
  return is_pressure ? in_plane - times_i(across) : across - times_i(in_plane);
}

} // namespace brinell::halfspace
