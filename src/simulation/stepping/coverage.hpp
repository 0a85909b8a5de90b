// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/elastoplastic/increment.hpp"
#include "brinell/simulation/scenario.hpp"

namespace brinell::simulation
{

/// Enlarges a coverage to include contact and plastic zone of the present state.
void extend(Coverage& coverage, const elastoplastic::CoupledContact& pair);

} // namespace brinell::simulation
