// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "judgement.hpp"

#include <vector>

namespace brinell::quality
{

/// Adds warnings about the fatigue of both bodies, and the errors to expect of its numbers.
void judge_fatigue(const simulation::RunTotals& totals, Quality& quality);

} // namespace brinell::quality
