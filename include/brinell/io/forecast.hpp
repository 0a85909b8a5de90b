// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/io/feasibility.hpp"
#include "brinell/simulation/forecast.hpp"

namespace brinell::io
{

/// What decides about the time of a run of the case.
[[nodiscard]] simulation::Workload workload(const Case& c, const ScenarioPlan& plan);

} // namespace brinell::io
