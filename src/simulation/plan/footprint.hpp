// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/contact/elastic_contact.hpp"
#include "brinell/simulation/scenario.hpp"

#include <limits>

namespace brinell::simulation
{

/// Closed-form estimates of contact and plastic zone under a load or an approach: good enough to choose grids and tolerances.
struct Footprint
{
  double elastic_x = 0.0,
         elastic_y = 0.0;            ///< half-lengths of the contact of the smooth bodies if they stayed elastic [m]
  double half_x = 0.0, half_y = 0.0; ///< half-lengths of the contact with plastic flow [m]
  double over_x = 0.0,
         over_y = 0.0;        ///< half-lengths of the contact of the textured surfaces, not below half_x, half_y [m]
  bool straight_y = false;    ///< a roller, at whose ends the contact ends
  bool endless_y = false;     ///< the contact is infinite along y, so that its half-length along y is meaningless
  double plastic_reach = 0.0; ///< radius of the plastic zone [m]
  double depth = 0.0;         ///< expected depth of the plastic zone [m]
  double approach = 0.0;      ///< [m]
  double peak_pressure =
      0.0;                 ///< of the smooth, elastic contact [Pa]; infinite at a tip; 0 for contacts of many patches
  double peak_ratio = 0.0; ///< peak pressure of the smooth, elastic contact over that of first yield
  double first_yield_approach = 0.0;        ///< [m]; the full approach if nothing yields before
  double frictionless_yield_approach = 0.0; ///< without friction [m]: a scale of the normal contact alone
  double contact_share = 1.0;               ///< share of the period in contact; 1 without an estimate
  /// Load that the bodies would carry if they stayed elastic, without textures and friction [N]; under an approach, plastic flow
  /// reduces it. Infinite if there is no closed form.
  double elastic_load = std::numeric_limits<double>::infinity();
};

/// @param friction  coefficient of sliding surfaces, used for first yield.
/// @throws InputError with reason_against_contact; PlanError: see require_within_reference.
[[nodiscard]] Footprint footprint(const ShapedBody& lower, const ShapedBody& upper, const contact::Drive& drive,
                                  const Domain& domain, double friction = 0.0);

/// Footprint of the bodies without their textures.
[[nodiscard]] Footprint smooth_footprint(const ShapedBody& lower, const ShapedBody& upper, const contact::Drive& drive,
                                         const Domain& domain, double friction = 0.0);

/// With one periodic axis the displacement is zero at the reference distance. When the half-width of the contact reaches twice
/// this distance, the approach no longer grows with the load, and the operator is not positive definite any more. Half of that
/// half-width is allowed.
/// @throws PlanError
void require_within_reference(double half_x, double half_y, const ShapedBody& lower, const ShapedBody& upper,
                              const Domain& domain);

/// Depth that the stress of an elastic contact reaches [m]: its largest shear is at 0.48 a under a point contact, at 0.79 a
/// under a line contact.
[[nodiscard]] double stressed_depth(double half_x, double half_y);

/// Whether neither body has a texture.
[[nodiscard]] bool are_smooth(const ShapedBody& lower, const ShapedBody& upper);

/// Whether only the textures of the bodies touch.
[[nodiscard]] bool are_flat(const ShapedBody& lower, const ShapedBody& upper);

/// Whether two half spaces under the same pressure always have the same strain: the same plastic material, no textures, and no
/// films or inclusions that differ from place to place.
[[nodiscard]] bool alike(const ShapedBody& lower, const ShapedBody& upper);

/// Whether a run needs no fields within the bodies: none that yields, and none that is wanted.
[[nodiscard]] bool needs_surfaces_only(const PairCase& c);

/// Sets grids and tolerances of a plan, whose `surfaces_only` is set, for a contact that moves along the bodies.
/// @param track_lower, track_upper  largest distance of the contact's centre from the middle of each body's grid [m].
void lay_out(const PairCase& pair, const Footprint& footprint, double track_lower, double track_upper, Plan& plan);
/// Sets them with other cells than those of `cell_sizes`.
void lay_out(const Numerics& numerics, const std::array<double, 3>& cells, const Footprint& footprint,
             double track_lower, double track_upper, Plan& plan);

} // namespace brinell::simulation
