// SPDX-License-Identifier: BSD-3-Clause
#include "heat.hpp"

#include <cmath>
#include <fmt/format.h>
#include <tuple>
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

/// Checks that the bulk temperature of a body is below its melting temperature.
void require_solid(const char* name, const constitutive::Material& material)
{
  const auto melting = material.softening ? constitutive::melting_temperature(*material.softening) : std::nullopt;
  if (melting && material.temperature >= *melting)
    throw KeyError(fmt::format("{}.material.thermal.temperature", name),
                   fmt::format("{}.material.thermal.temperature = {:g} degC, but by its softening law the body melts "
                               "at {:g} degC; allowed: below that",
                               name, material.temperature, *melting));
}

/// Checks that there is a reference distance for bodies with different bulk temperatures: between them heat passes even at rest,
/// while they are pressed together.
void require_reference_of_exchange(const Numerics& numerics, const constitutive::Material& lower,
                                   const constitutive::Material& upper)
{
  const auto swells = [](const constitutive::Material& m) { return m.thermal && m.thermal->expansion != 0.0; };
  const bool passes =
      lower.thermal && upper.thermal && lower.temperature != upper.temperature && numerics.heat.exchanges();
  if (passes && numerics.heat.displacement && (swells(lower) || swells(upper)) && !numerics.heat.reference)
    throw KeyError(
        "thermal.reference",
        fmt::format(
            "thermal.reference is missing: between a lower body of {:g} and an upper one of {:g} degC heat also flows "
            "while they are pressed together at rest, and the thermal displacement under a steady flux at rest has no "
            "limit: it grows with the logarithm of the distance; allowed: the distance from the contact at which the "
            "thermal displacement is taken as zero, such as the radius of the body; or thermal.displacement = false",
            lower.temperature, upper.temperature));
}

/// Checks that heat is shared only between two bodies that take heat.
void require_two_sides(const Numerics& numerics, const constitutive::Material& lower,
                       const constitutive::Material& upper)
{
  const bool is_shared = numerics.heat.partition || numerics.heat.conductance;
  if (!is_shared || (lower.thermal && upper.thermal))
    return;
  const char* key = numerics.heat.partition ? "thermal.partition" : "thermal.conductance";
  throw KeyError(key, fmt::format("{} = {:g}, but the {} body has no thermal constants and takes no heat: the other "
                                  "body takes all of it; allowed: no such key, or thermal constants of both bodies",
                                  key, numerics.heat.partition ? *numerics.heat.partition : *numerics.heat.conductance,
                                  lower.thermal ? "upper" : "lower"));
}

/// Checks that there is a steady state, and that its displacement is defined.
void require_steady(const Numerics& numerics, const ShapedBody& lower, const ShapedBody& upper,
                    const HeatedMotion& motion)
{
  const auto refuse = [](const std::string& reason, const std::string& allowed)
  {
    throw KeyError("thermal.regime",
                   fmt::format("thermal.regime = \"steady\", but {}; allowed: {}, or \"transient\"", reason, allowed));
  };
  if (numerics.domain.x.is_periodic())
    refuse("along a periodic axis of the motion heat accumulates without limit", "an open axis along x");
  if (numerics.domain.y.is_periodic() && motion.upper_rests && upper.material.thermal)
    refuse("in the upper body, which rests under its heat flux along a periodic axis, heat accumulates without limit",
           "open axes");
  for (const auto& [name, body] : {std::pair{"lower", &lower}, {"upper", &upper}})
    if (body->material.is_plastic() && numerics.heat.of_plastic_work > 0.0)
      refuse(fmt::format("this regime cannot compute the heat of the plastic work of the {} body", name),
             "thermal.heat_of_plastic_work = 0");
  const bool swells = upper.material.thermal && upper.material.thermal->expansion != 0.0 && numerics.heat.displacement;
  if (motion.upper_rests && swells && !numerics.heat.reference)
    throw KeyError("thermal.reference",
                   "thermal.reference is missing: the upper body rests under its heat flux, and the thermal "
                   "displacement under a steady flux at rest has no limit: it grows with the logarithm of the "
                   "distance; allowed: the distance from the contact at which the thermal displacement is taken as "
                   "zero, such as the radius of the body; or thermal.displacement = false");
  if (motion.pressed_at_rest)
    require_reference_of_exchange(numerics, lower.material, upper.material);
}

} // namespace

bool is_heated(const Numerics& numerics, const ShapedBody& lower, const ShapedBody& upper)
{
  return numerics.friction.coefficient > 0.0 && (lower.material.thermal || upper.material.thermal);
}

void require_heat(const Numerics& numerics, const ShapedBody& lower, const ShapedBody& upper,
                  const HeatedMotion& motion)
{
  const std::optional<double>& speed = motion.speed;
  const std::string& speed_key = motion.speed_key;
  require_share("interface.heat_fraction", numerics.heat.fraction);
  require_share("thermal.heat_of_plastic_work", numerics.heat.of_plastic_work);
  if (numerics.heat.partition)
    require_share("thermal.partition", *numerics.heat.partition);
  if (numerics.heat.conductance && !(*numerics.heat.conductance >= 0.0 && std::isfinite(*numerics.heat.conductance)))
    throw KeyError("thermal.conductance", fmt::format("thermal.conductance = {:g} W/(m^2 K); allowed: >= 0, or none",
                                                      *numerics.heat.conductance));
  if (numerics.heat.reference && !(*numerics.heat.reference > 0.0 && std::isfinite(*numerics.heat.reference)))
    throw KeyError("thermal.reference",
                   fmt::format("thermal.reference = {:g} m; allowed: > 0, or none", *numerics.heat.reference));
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
    require_steady(numerics, lower, upper, motion);
  require_two_sides(numerics, lower.material, upper.material);
  for (const auto& [name, body] : {std::pair{"lower", &lower}, {"upper", &upper}})
    if (!body->material.thermal && !body->material.elastic.is_rigid())
      throw KeyError(
          fmt::format("{}.material.thermal.conductivity", name),
          fmt::format("{}.material.thermal is missing, but the other body has thermal constants; allowed: thermal "
                      "constants of both bodies, of none, or a rigid body, which without them takes no heat",
                      name));
}

void require_below_melting(const std::string& where, const HeatedRecord& step, const constitutive::Material& lower,
                           const constitutive::Material& upper)
{
  for (const auto& [name, material, temperature] :
       {std::tuple{"lower", &lower, step.max_temperature_lower}, {"upper", &upper, step.max_temperature_upper}})
  {
    const auto melting = material->softening ? constitutive::melting_temperature(*material->softening) : std::nullopt;
    if (melting && temperature >= *melting)
      throw InputError(
          fmt::format("{}: the {} surface reaches {:.0f} degC and melts at {:.0f} degC, where the run is to "
                      "stop (thermal.at_melting); allowed: less speed, load or friction, or "
                      "thermal.at_melting = \"go_on\". All earlier steps are kept",
                      where, name, temperature, *melting));
  }
}

bool shares_alike(const Numerics& numerics)
{
  return numerics.heat.share() == 0.5;
}

} // namespace brinell::simulation
