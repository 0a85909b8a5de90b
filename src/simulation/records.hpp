// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/simulation/scenario.hpp"

namespace brinell::simulation
{

/// Puts the state of the last step into a summary; what was worked but neither dissipated nor is stored is an error.
/// @param largest_work  reached in the run [J]
void take_totals(const StepRecord& last, double largest_work, RunTotals& totals);

} // namespace brinell::simulation
