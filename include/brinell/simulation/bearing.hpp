// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

/// What the bearing-area curve of a surface says of it.
namespace brinell::simulation
{

/// Core, peaks and valleys of a surface after ISO 25178-2 (ISO 13565-2): docs/theory/simulation.md (bearing). The curve is the height
/// over the share of the area that lies at that height or above.
struct Bearing
{
  double core_height = 0.0;  ///< Sk: by how much the line of the core falls over all of the area [m]
  double peak_height = 0.0;  ///< Spk: of the triangle that has the area of the curve above the core [m]
  double valley_depth = 0.0; ///< Svk: of that which has the area below it [m]
  double peak_share = 0.0;   ///< Smr1: share of the area at which the core begins, 0 to 1
  double valley_share = 1.0; ///< Smr2: and at which it ends
};

/// @param heights  out of the body positive, each of the same share of the area [m]; their order means nothing.
[[nodiscard]] Bearing bearing_of(std::vector<double> heights);

} // namespace brinell::simulation
