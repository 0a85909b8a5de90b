// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

/// Parameters of the bearing-area curve of a surface.
namespace brinell::simulation
{

/// Core, peaks and valleys of a surface after ISO 25178-2 (ISO 13565-2): docs/theory/simulation.md (bearing). The curve is the
/// height over the share of the area that lies at that height or above.
struct Bearing
{
  double core_height = 0.0;  ///< Sk: height by which the core line falls from 0 to 100 % of the area [m]
  double peak_height = 0.0;  ///< Spk: height of the triangle with the area of the curve above the core [m]
  double valley_depth = 0.0; ///< Svk: depth of the triangle with the area of the curve below the core [m]
  double peak_share = 0.0;   ///< Smr1: share of the area at which the core begins, 0 to 1
  double valley_share = 1.0; ///< Smr2: share of the area at which the core ends, 0 to 1
};

/// @param heights  positive out of the body, each for an equal share of the area, in any order [m].
[[nodiscard]] Bearing bearing_of(std::vector<double> heights);

} // namespace brinell::simulation
