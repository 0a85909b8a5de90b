// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/simulation/scenario.hpp"

#include <optional>
#include <string>

namespace brinell::simulation
{

/// Whether the heat of friction warms the bodies: there is friction, and one of them at least has thermal constants.
[[nodiscard]] bool is_heated(const Numerics& numerics, const ShapedBody& lower, const ShapedBody& upper);

/// How heated bodies move.
struct HeatedMotion
{
  std::optional<double> speed; ///< [m/s]
  std::string speed_key;
  bool upper_rests = false;     ///< under the contact, so that its heat always comes in at one place
  bool pressed_at_rest = false; ///< before they move
};

/// Heat needs a speed, and both bodies that deform their constants.
/// @throws KeyError
void require_heat(const Numerics& numerics, const ShapedBody& lower, const ShapedBody& upper,
                  const HeatedMotion& motion);

/// Whether bodies that are alike also share the heat alike.
[[nodiscard]] bool shares_alike(const Numerics& numerics);

} // namespace brinell::simulation
