// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/grid.hpp"
#include "brinell/halfspace/surface_load.hpp"

#include <span>

namespace brinell::simulation
{

/// Forces on the upper body, read from pressure and shear in the plane of contact.
struct Forces
{
  double F_n = 0.0;                              ///< along the line of centres [N]
  double F_X = 0.0, F_Y = 0.0, F_Z = 0.0;        ///< on the mean contact plane; F_X > 0 resists the motion [N]
  double F_X_macro = 0.0, F_Z_macro = 0.0;       ///< without pile-up, Eqs. 15 and 17 [N]
  double F_X_lower = 0.0, F_X_upper = 0.0;       ///< Eq. 18 on the slope of each body's own residual surface [N]
  double F_X_friction = 0.0, F_Z_friction = 0.0; ///< the shares of the shear in F_X and F_Z [N]
};

/// Depth of the surface of one body under the contact grid, and the share of this body in the arc.
struct ResidualSurface
{
  /// Residual displacement, texture and elastic displacement under the shear, positive into the body [m].
  std::span<const double> displacement;
  double share = 0.5; ///< R_i / (R1 + R2)
};

/// Projection of the pressure onto the global axes (paper, Eqs. 15-22, without the factor n: a sum over cells counts each cell
/// once). The slope of the mean contact plane is the mean of both slopes, weighted with the arcs that the contact moves on each
/// body; with this definition the work of the forces is the energy that the bodies absorb: docs/theory/simulation.md (pile-up).
/// The shear acts along the same plane.
/// @param load   on the contact grid: pressure, and the shear on the lower body along x, if there is any [Pa]
/// @param theta  angle of the line of centres to Z [rad]
[[nodiscard]] Forces project_forces(const SurfaceGrid& grid, const halfspace::SurfaceLoad& load, double theta,
                                    const ResidualSurface& lower, const ResidualSurface& upper);

/// Resistance to rolling: work that the drive does against the pressure per distance on the lower body [N], from the slopes of
/// both surfaces with texture and residual displacement: docs/theory/simulation.md (rolling).
/// @param upper_share  distance on the upper body per distance on the lower one
[[nodiscard]] double rolling_resistance(const SurfaceGrid& grid, std::span<const double> pressure,
                                        std::span<const double> lower_depth, std::span<const double> upper_depth,
                                        double upper_share);

} // namespace brinell::simulation
