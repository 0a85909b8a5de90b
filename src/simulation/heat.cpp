// SPDX-License-Identifier: BSD-3-Clause
#include "heat.hpp"

#include <cmath>
#include <fmt/format.h>
#include <utility>

namespace brinell::simulation
{

namespace
{

void require_share(const char* key, double share)
{
  if (!(share >= 0.0 && share <= 1.0))
    throw KeyError(key, fmt::format("{} = {:g}; allowed: from 0 to 1", key, share));
}

} // namespace

bool is_heated(const Numerics& numerics, const ShapedBody& lower, const ShapedBody& upper)
{
  return numerics.friction.coefficient > 0.0 && (lower.material.thermal || upper.material.thermal);
}

void require_heat(const Numerics& numerics, const ShapedBody& lower, const ShapedBody& upper,
                  const std::optional<double>& speed, const std::string& speed_key)
{
  require_share("interface.heat_fraction", numerics.heat.fraction);
  if (numerics.heat.partition)
    require_share("thermal.partition", *numerics.heat.partition);
  if (speed && !(*speed > 0.0 && std::isfinite(*speed)))
    throw KeyError(speed_key, fmt::format("{} = {:g} m/s; allowed: > 0", speed_key, *speed));
  if (!is_heated(numerics, lower, upper))
    return;
  if (!speed)
    throw KeyError(speed_key, fmt::format("{} is missing: with friction and the thermal constants of a body the heat "
                                          "depends on it; allowed: a speed > 0, as \"1 m/s\"; or no thermal constants",
                                          speed_key));
  for (const auto& [name, body] : {std::pair{"lower", &lower}, {"upper", &upper}})
    if (!body->material.thermal && !body->material.elastic.is_rigid())
      throw KeyError(fmt::format("{}.material.thermal.conductivity", name),
                     fmt::format("{}.material.thermal is missing, but the other body has thermal constants; allowed: "
                                 "those of both bodies, none, or a rigid body, which without them takes no heat",
                                 name));
}

bool shares_alike(const Numerics& numerics)
{
  return !numerics.heat.partition || *numerics.heat.partition == 0.5;
}

} // namespace brinell::simulation
