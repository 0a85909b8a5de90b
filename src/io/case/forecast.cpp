// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/io/forecast.hpp"

#include "io/scenarios/scenario_io.hpp"
#include "result_size.hpp"

namespace brinell::io
{

simulation::Workload workload(const Case& c, const ScenarioPlan& plan)
{
  const simulation::Storage storage{stored_states(c, plan), result_bytes(c, plan)};
  return std::visit(
      [&]<typename ScenarioCase>(const ScenarioCase& scenario)
      {
        const auto& io = io_of(scenario);
        const auto& p = std::get<typename ScenarioCase::Plan>(plan);
        return simulation::workload(scenario, scenario.lower, scenario.upper, p, p.*io.half_x, io.course(scenario, p),
                                    storage);
      },
      c.scenario);
}

} // namespace brinell::io
