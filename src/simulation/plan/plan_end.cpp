// SPDX-License-Identifier: BSD-3-Clause
#include "plan_end.hpp"

#include "domain.hpp"
#include "footprint.hpp"
#include "heat.hpp"
#include "memory.hpp"

namespace brinell::simulation
{

void check_grids(const PairCase& c, Plan& plan)
{
  require_cells_in_periods(c, plan.contact);
  require_source_fits(c, plan.contact);
  plan.reference = reference_distance(c.lower.shape, c.upper.shape, c.domain);
}

void end_plan(const PairCase& c, bool sticks, Plan& plan, const std::function<halfspace::HeatTimes()>& heat_times)
{
  const bool heats = is_heated(c);
  if (heats)
    plan.heat_times = heat_times();
  plan.is_textured = !are_smooth(c.lower, c.upper);
  plan.shears = c.friction.coefficient > 0.0 ? (sticks ? 2 : 1) : (heats ? 1 : 0);
  plan.memory_bytes =
      memory_bytes(plan, c.lower.material, c.upper.material, c.solver, plan.shears, heats ? &c.heat : nullptr);
}

} // namespace brinell::simulation
