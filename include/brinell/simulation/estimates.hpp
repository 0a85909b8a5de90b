// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/simulation/scenario.hpp"

#include <optional>

/// Estimates for a run before it is computed.
namespace brinell::simulation
{

/// Load at which an elastic contact has a given peak pressure [N], for an elliptical contact or a line of finite length (Hertz;
/// Johnson 1985, sections 4.2 and 4.3); empty for other contacts.
/// @param contact_modulus, peak_pressure  [Pa]
[[nodiscard]] std::optional<double> load_of_peak_pressure(const Shape& lower, const Shape& upper, const Domain& domain,
                                                          double contact_modulus, double peak_pressure);

} // namespace brinell::simulation
