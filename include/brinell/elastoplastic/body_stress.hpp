// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/elastoplastic/increment.hpp"

#include <vector>

namespace brinell::elastoplastic
{

/// Stress in all layers of a body [Pa]: of the contact's pressure, of the plastic strain, and that from before the first load.
struct BodyStress
{
  std::vector<double> deviator; ///< 5 values per cell
  std::vector<double> trace;    ///< [cell]
};

/// @param body   of `pair`, not rigid
/// @param place  of the contact grid on its grid
[[nodiscard]] BodyStress body_stress(const CoupledContact& pair, const Body& body, const Place& place);

} // namespace brinell::elastoplastic
