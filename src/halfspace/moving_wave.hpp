// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "thermal_wave.hpp"

namespace brinell::halfspace
{

/// A flux that has moved along x over a half space for some time: docs/theory/heat.md (steady-waves).
struct MovingFlux
{
  double conductivity, diffusivity; ///< K [W/(m K)], kappa [m^2/s]
  double velocity;                  ///< of the flux over the body, along x [m/s]
  double duration;                  ///< [s], > 0, finite
};

/// What one wave of a unit flux [W/m^2] gives at a depth at the end, in closed form, as seen from the flux.
/// @param kx  for which it moves: that of the wave; the wavenumber may be zero
[[nodiscard]] ThermalWave moving_wave(const MovingFlux& flux, double kx, double k, double depth);

} // namespace brinell::halfspace
