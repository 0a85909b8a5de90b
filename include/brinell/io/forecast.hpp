// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/io/feasibility.hpp"
#include "brinell/simulation/forecast.hpp"

namespace brinell::io
{

/// Features of a case that decide about the time of its run.
[[nodiscard]] simulation::Workload workload(const Case& c, const ScenarioPlan& plan);

} // namespace brinell::io
