// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/contact/elastic_contact.hpp"
#include "brinell/simulation/scenario.hpp"

#include <limits>

namespace brinell::simulation
{

/// Estimates of what a load or an approach does, from closed forms: good enough to lay out grids and tolerances.
struct Footprint
{
  double elastic_x = 0.0,
         elastic_y = 0.0;            ///< half-lengths of the contact of the smooth bodies if they stayed elastic [m]
  double half_x = 0.0, half_y = 0.0; ///< and as they are [m]
  double over_x = 0.0,
         over_y = 0.0;        ///< half-lengths that the contact of the textured surfaces covers, at least the same [m]
  bool straight_y = false;    ///< a roller: the contact ends with it
  bool endless_y = false;     ///< the contact goes on along y, whatever the period: its length means nothing
  double plastic_reach = 0.0; ///< radius of the plastic zone [m]
  double depth = 0.0;         ///< to which plastic strain is to be expected [m]
  double approach = 0.0;      ///< [m]
  double peak_ratio = 0.0;    ///< peak pressure of the smooth, elastic contact over that of first yield
  double first_yield_approach = 0.0; ///< [m]; the approach if nothing yields before
  double frictionless_yield_approach =
      0.0;                    ///< the same for bodies that slide without friction: a scale of the contact alone
  double contact_share = 1.0; ///< of the period that touches; 1 where none tells
  /// That the bodies would carry if they stayed elastic, without textures and friction [N]: under an approach, plastic flow takes
  /// from it. Infinite where no closed form tells.
  double elastic_load = std::numeric_limits<double>::infinity();
};

/// @param friction  of surfaces that slide: it counts for first yield.
/// @throws InputError with reason_against_contact; KeyError: see require_within_reference.
[[nodiscard]] Footprint footprint(const ShapedBody& lower, const ShapedBody& upper, const contact::Drive& drive,
                                  const Domain& domain, double friction = 0.0);

/// The same without the textures.
[[nodiscard]] Footprint smooth_footprint(const ShapedBody& lower, const ShapedBody& upper, const contact::Drive& drive,
                                         const Domain& domain, double friction = 0.0);

/// With one periodic axis the displacement counts from the reference distance. As the half-width of the contact grows to twice
/// that, the approach stops growing with the load, and the operator is no longer positive definite: half of it is allowed.
/// @throws KeyError
void require_within_reference(double half_x, double half_y, const ShapedBody& lower, const ShapedBody& upper,
                              const Domain& domain);

/// Depth that the stress of an elastic contact reaches [m]: its largest shear is at 0.48 a under a point contact, at 0.79 a
/// under a line contact.
[[nodiscard]] double stressed_depth(double half_x, double half_y);

/// Whether neither body has a texture.
[[nodiscard]] bool are_smooth(const ShapedBody& lower, const ShapedBody& upper);

/// Whether only the textures of the bodies touch.
[[nodiscard]] bool are_flat(const ShapedBody& lower, const ShapedBody& upper);

/// Whether two half spaces under the same pressure keep the same strain: one plastic material, nothing on the surfaces.
[[nodiscard]] bool alike(const ShapedBody& lower, const ShapedBody& upper);

/// Grids of a contact that moves along the bodies, and tolerances.
/// @param track_lower, track_upper  farthest place of the contact's centre from the middle of each body's grid [m].
void lay_out(const Numerics& numerics, const Footprint& footprint, double track_lower, double track_upper, Plan& plan);

} // namespace brinell::simulation
