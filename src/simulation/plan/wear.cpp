// SPDX-License-Identifier: BSD-3-Clause
#include "wear.hpp"

#include <cmath>
#include <fmt/format.h>
#include <utility>

namespace brinell::simulation
{

void require_wear(const Numerics& numerics, const std::string& reason)
{
  const elastoplastic::WearLaw& wear = numerics.wear;
  for (const auto& [key, coefficient] : {std::pair{"`WearLaw::lower`", wear.lower}, {"`WearLaw::upper`", wear.upper}})
    if (!(coefficient >= 0.0 && std::isfinite(coefficient)))
      throw PlanError("{} = {:g} 1/Pa; allowed: number >= 0", key, coefficient);
  if (!wear.wears())
    return;
  const std::string key = wear.lower > 0.0 ? "`WearLaw::lower`" : "`WearLaw::upper`";
  const std::string given = fmt::format("{} = {:g} 1/Pa", key, wear.lower > 0.0 ? wear.lower : wear.upper);
  if (!reason.empty())
    throw PlanError("{}: {}", given, reason);
  if (wear.kind == elastoplastic::WearLaw::Kind::energy && numerics.friction.coefficient == 0.0)
    throw PlanError("`WearLaw::kind` = \"energy\" with `Friction::coefficient` = 0: no friction work, "
                    "no wear; allowed: friction > 0, or the law \"archard\"");
}

} // namespace brinell::simulation
