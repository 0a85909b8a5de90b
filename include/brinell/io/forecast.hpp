// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/io/feasibility.hpp"
#include "brinell/simulation/forecast.hpp"

namespace brinell::io
{

/// Features of a case that decide about the time of its run.
[[nodiscard]] simulation::Workload workload(const Case& c, const ScenarioPlan& plan);

/// Forecast for a run of the case: with `solver.accuracy`, of the one with the given cells.
struct Forecast : simulation::Forecast
{
  double memory = 0.0; ///< largest, files included [bytes]
};
[[nodiscard]] Forecast forecast(const Case& c, const ScenarioPlan& plan);

/// "about 12 s (6 to 24 s) on one core, 180 MB of memory"
[[nodiscard]] std::string forecast_text(const Forecast& forecast);

} // namespace brinell::io
