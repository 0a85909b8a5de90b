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

/// Temperature and potential at one depth by one wave of a unit flux [W/m^2] at the end of the duration, in closed form, in the
/// frame that moves with the flux.
/// @param kx  wavenumber along x, which determines the effect of the motion [rad/m]
/// @param k   magnitude of the wavevector [rad/m]; may be zero
[[nodiscard]] ThermalWave moving_wave(const MovingFlux& flux, double kx, double k, double depth);

} // namespace brinell::halfspace
