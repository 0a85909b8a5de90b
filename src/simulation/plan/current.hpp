// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/simulation/scenario.hpp"

namespace brinell::simulation
{

/// Checks that a current is possible: both bodies must conduct, and with a film their resistivity must not depend on temperature.
/// @throws PlanError
void require_current(const PairCase& c);

} // namespace brinell::simulation
