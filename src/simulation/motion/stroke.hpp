// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/simulation/sliding.hpp"
#include "column_statistics.hpp"
#include "simulation/stepping/stepper.hpp"

namespace brinell::simulation
{

/// Numbers of a stroke of sliding at its end.
/// @param rows  of the stroke
[[nodiscard]] SlidingStroke stroke_of(const ColumnStatistics<SlidingRecord>& rows, const Stepper& stepper);

} // namespace brinell::simulation
