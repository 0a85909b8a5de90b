// SPDX-License-Identifier: BSD-3-Clause
#include "friction.hpp"

#include <cmath>
#include <fmt/format.h>

namespace brinell::simulation
{

void require_friction(const PairCase& c, const std::string& reason)
{
  const auto& [coefficient, limit, coupling] = c.friction;
  const std::string given = fmt::format("`Friction::coefficient` = {:g}", coefficient);
  if (!(coefficient >= 0.0 && std::isfinite(coefficient)))
    throw PlanError("{}; allowed: number >= 0", given);
  if (limit && !(*limit > 0.0))
    throw PlanError("`Friction::shear_limit` = {:g} Pa; allowed: > 0", *limit);
  if (coefficient == 0.0)
    return;
  if (!reason.empty())
    throw PlanError("{}: {}", given, reason);
  if (c.lower.material.elastic.is_rigid() && c.upper.material.elastic.is_rigid())
    throw PlanError("{} between two rigid bodies; allowed: one that deforms", given);
}

double force_ratio(double F_X, double F_n, const Plan& plan)
{
  constexpr double rounding = 1e-9; // of the force of one cell
  return F_n > rounding * plan.peak_pressure * plan.contact.cell_area() ? F_X / F_n : 0.0;
}

} // namespace brinell::simulation
