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

/// A body that is warmer than it melts at has nothing that could be pressed.
void require_solid(const char* name, const constitutive::Material& material)
{
  const auto melting = material.softening ? constitutive::melting_temperature(*material.softening) : std::nullopt;
  if (melting && material.temperature >= *melting)
    throw KeyError(fmt::format("{}.material.thermal.temperature", name),
                   fmt::format("{}.material.thermal.temperature = {:g} degC, but its softening says that it melts at "
                               "{:g} degC; allowed: below that",
                               name, material.temperature, *melting));
}

/// The steady regime knows the temperatures of surfaces alone. Along a periodic axis heat would pile up for ever.
void require_steady(const Numerics& numerics, const ShapedBody& lower, const ShapedBody& upper)
{
  const auto refuse = [](const std::string& reason, const std::string& allowed)
  {
    throw KeyError("thermal.regime",
                   fmt::format("thermal.regime = \"steady\", but {}; allowed: {}, or \"transient\"", reason, allowed));
  };
  if (numerics.heat.displacement || numerics.heat.stress)
    refuse("it gives the temperatures of the surfaces alone: what a flux that rests swells by has no limit",
           "thermal.displacement = false and thermal.stress = false");
  if (numerics.domain.x.is_periodic() || numerics.domain.y.is_periodic())
    refuse("along a periodic axis heat piles up", "a grid without periodic axes");
  for (const auto& [name, body] : {std::pair{"lower", &lower}, {"upper", &upper}})
    if (body->material.is_plastic() && numerics.heat.of_plastic_work > 0.0)
      refuse(fmt::format("the heat of the plastic work of the {} body is not known in it", name),
             "thermal.heat_of_plastic_work = 0");
  for (const auto& [name, body] : {std::pair{"lower", &lower}, {"upper", &upper}})
    if (body->material.softening)
      refuse(fmt::format("the {} body softens with the temperature in it, which is not known", name), "no softening");
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
  require_share("thermal.heat_of_plastic_work", numerics.heat.of_plastic_work);
  if (numerics.heat.partition)
    require_share("thermal.partition", *numerics.heat.partition);
  if (numerics.heat.conductance && !(*numerics.heat.conductance >= 0.0 && std::isfinite(*numerics.heat.conductance)))
    throw KeyError("thermal.conductance", fmt::format("thermal.conductance = {:g} W/(m^2 K); allowed: >= 0, or none",
                                                      *numerics.heat.conductance));
  for (const auto& [name, body] : {std::pair{"lower", &lower}, {"upper", &upper}})
    require_solid(name, body->material);
  if (speed && !(*speed > 0.0 && std::isfinite(*speed)))
    throw KeyError(speed_key, fmt::format("{} = {:g} m/s; allowed: > 0", speed_key, *speed));
  if (!is_heated(numerics, lower, upper))
    return;
  if (!speed)
    throw KeyError(speed_key, fmt::format("{} is missing: with friction and the thermal constants of a body the heat "
                                          "depends on it; allowed: a speed > 0, as \"1 m/s\"; or no thermal constants",
                                          speed_key));
  if (numerics.heat.regime == elastoplastic::HeatRegime::steady)
    require_steady(numerics, lower, upper);
  for (const auto& [name, body] : {std::pair{"lower", &lower}, {"upper", &upper}})
    if (!body->material.thermal && !body->material.elastic.is_rigid())
      throw KeyError(fmt::format("{}.material.thermal.conductivity", name),
                     fmt::format("{}.material.thermal is missing, but the other body has thermal constants; allowed: "
                                 "those of both bodies, none, or a rigid body, which without them takes no heat",
                                 name));
}

bool shares_alike(const Numerics& numerics)
{
  return numerics.heat.share() == 0.5;
}

} // namespace brinell::simulation
