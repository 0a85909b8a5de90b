// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "halfspace/transform/depth_sums.hpp"

#include <cmath>

namespace brinell::halfspace
{

/// One wave along the surface of the temperature T at one depth, and its potential psi there: lap(psi) = -T with d psi/dz = 0 at
/// the surface.
struct ThermalWave
{
  Complex temperature;          ///< [K]
  Complex potential, slope;     ///< k psi and d psi/dz [K m]
  Complex potential_at_surface; ///< k psi for z = 0 [K m]
};

/// -i times a value.
[[nodiscard]] inline Complex divided_by_i(const Complex& value)
{
  return {value.imag(), -value.real()};
}

/// Stress of one wave at one depth, divided by 2 mu alpha (1 + nu)/(1 - nu) [K].
struct StressWave
{
  Complex xx, yy, zz, yz, xz, xy;

  [[nodiscard]] Complex trace() const { return xx + yy + zz; }
};

/// docs/theory/heat.md (thermal-stress). The potential of the temperature causes a normal traction on the surface, which a
/// pressure cancels. zz, xz and yz contain what remains in the body of the two, which largely cancel.
[[nodiscard]] inline StressWave stress_wave(const SurfaceWave& along, double depth, const ThermalWave& heat,
                                            double poisson_ratio)
{
  const double k = along.k, kz = k * depth;
  const Complex surface = std::exp(-kz) * heat.potential_at_surface;
  const Complex bent = heat.potential + (1.0 - 2.0 * poisson_ratio - kz) * surface;
  const Complex all = 2.0 * poisson_ratio * k * surface - heat.temperature;
  const Complex slope = divided_by_i(heat.slope + kz * surface);
  const double inverse = k > 0.0 ? 1.0 / k : 0.0;
  return {all + along.kx * along.kx * inverse * bent,
          all + along.ky * along.ky * inverse * bent,
          -k * (heat.potential - (1.0 + kz) * surface),
          along.odd_y * slope,
          along.odd_x * slope,
          along.odd_x * along.odd_y * inverse * bent};
}

} // namespace brinell::halfspace
