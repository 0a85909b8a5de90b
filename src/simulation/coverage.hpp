// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/elastoplastic/increment.hpp"
#include "brinell/simulation/scenario.hpp"

namespace brinell::simulation
{

/// Takes in what the cells cover in the present state.
void widen(Coverage& coverage, const elastoplastic::CoupledContact& pair);

} // namespace brinell::simulation
