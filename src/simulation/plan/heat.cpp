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
    throw PlanError("{} = {:g}; allowed: from 0 to 1", key, share);
}

/// Refuses what is not computed of a coated body that is heated.
void require_coat(const PairCase& c, const char* name, const constitutive::Material& material)
{
  if (material.layers.empty() || !material.thermal)
    return;
  const std::string layers = member_of(name, "material.layers");
  if (c.heat.regime == elastoplastic::HeatRegime::steady)
    throw PlanError(
        "`HeatSettings::regime` = \"steady\" and {} with thermal constants: the steady heat of coated bodies "
        "is not computed; allowed: \"transient\"",
        layers);
  if (material.is_plastic() && c.heat.of_plastic_work > 0.0)
    throw PlanError("`HeatSettings::of_plastic_work` = {:g} and {} with thermal constants: the heat of plastic work in "
                    "coated bodies is not computed; allowed: `HeatSettings::of_plastic_work` = 0",
                    c.heat.of_plastic_work, layers);
}

/// Checks that heat is shared only between two bodies that take heat.
void require_two_sides(const Numerics& numerics, const constitutive::Material& lower,
                       const constitutive::Material& upper)
{
  const bool is_shared = numerics.heat.partition || numerics.heat.conductance;
  if (!is_shared || (lower.thermal && upper.thermal))
    return;
  const char* key = numerics.heat.partition ? "`HeatSettings::partition`" : "`HeatSettings::conductance`";
  throw PlanError("{} = {:g}, but the {} body has no thermal constants and takes no heat: the other "
                  "body takes all of it; allowed: no such key, or thermal constants of both bodies",
                  key, numerics.heat.partition ? *numerics.heat.partition : *numerics.heat.conductance,
                  lower.thermal ? "upper" : "lower");
}

/// Checks that a number is given, finite and above 0.
void require_positive(const char* key, const std::optional<double>& value, const char* unit)
{
  if (!value)
    throw PlanError("{} is missing; allowed: a number > 0, in {}", key, unit);
  if (!(*value > 0.0 && std::isfinite(*value)))
    throw PlanError("{} = {:g} {}; allowed: > 0", key, *value, unit);
}

/// Checks shape and strength of a heat source, and that there is a body to heat.
void require_source(const PairCase& c)
{
  const elastoplastic::HeatSource& source = c.heat.source;
  using Shape = elastoplastic::HeatSource::Shape;
  if (!source.exists())
    return;
  if (source.shape == Shape::disc)
    require_positive("`HeatSource::radius`", source.radius, "m");
  if (source.shape == Shape::rectangle)
    require_positive("`HeatSource::length`", source.length, "m");
  if (source.shape == Shape::rectangle && (source.width || !c.domain.y.is_periodic()))
    require_positive("`HeatSource::width`", source.width, "m");
  if (!std::isfinite(source.offset))
    throw PlanError("`HeatSource::offset` is not finite; allowed: a length");
  if (source.power && source.flux)
    throw PlanError("`HeatSource::flux` and `HeatSource::power`; allowed: one of them");
  if (source.is_on_body() && source.flux)
    require_positive("`HeatSource::flux`", source.flux, "W/m^2");
  else
    require_positive("`HeatSource::power`", source.power, "W");
  const bool has_body = source.is_on_body() ? (source.side() == 0 ? c.lower : c.upper).material.thermal.has_value()
                                            : c.lower.material.thermal || c.upper.material.thermal;
  const char* name = source.is_on_body() && source.side() == 1 ? "upper" : "lower";
  if (!has_body)
    throw PlanError("{} is missing: `HeatSettings::source` heats this body; allowed: its thermal constants",
                    member_of(name, "material.thermal"));
}

/// Checks that there is a steady state, and that its displacement is defined.
void require_steady(const PairCase& c, const HeatedMotion& motion)
{
  const auto refuse = [](const std::string& reason, const std::string& allowed)
  { throw PlanError("`HeatSettings::regime` = \"steady\", but {}; allowed: {}, or \"transient\"", reason, allowed); };
  if (motion.sticks)
    refuse(
        "in this regime the thermal displacement along the surfaces is not computed, on which their slip depends where "
        "they stick in places",
        "surfaces that slide everywhere");
  if (c.domain.x.is_periodic())
    refuse("along a periodic axis of the motion heat accumulates without limit", "an open axis along x");
  if (c.domain.y.is_periodic() && motion.upper_rests && c.upper.material.thermal)
    refuse("in the upper body, which rests under its heat flux along a periodic axis, heat accumulates without limit",
           "open axes");
  for (const auto& [name, body] : {std::pair{"lower", &c.lower}, {"upper", &c.upper}})
    if (body->material.is_plastic() && c.heat.of_plastic_work > 0.0)
      refuse(fmt::format("this regime cannot compute the heat of the plastic work of the {} body", name),
             "`HeatSettings::of_plastic_work` = 0");
  if (motion.upper_rests && c.upper.material.expands() && c.heat.displacement && !c.heat.reference)
    throw PlanError("`HeatSettings::reference` is missing: the upper body rests under its heat flux, and the thermal "
                    "displacement under a steady flux at rest has no limit: it grows with the logarithm of the "
                    "distance; allowed: the distance from the contact at which the thermal displacement is taken as "
                    "zero, such as the radius of the body; or `HeatSettings::displacement` = false");
}

} // namespace

void require_solid(const char* name, const constitutive::Material& material)
{
  const auto melting = material.softening ? constitutive::melting_temperature(*material.softening) : std::nullopt;
  if (melting && material.temperature >= *melting)
    throw PlanError("{} = {:g} degC, but by its softening law the body melts at {:g} degC; allowed: below that",
                    member_of(name, "material.temperature"), material.temperature, *melting);
}

bool is_heated(const PairCase& c)
{
  return (c.friction.coefficient > 0.0 || c.heat.source.exists()) &&
         (c.lower.material.thermal || c.upper.material.thermal);
}

void require_heat(const PairCase& c, const HeatedMotion& motion)
{
  const std::optional<double>& speed = motion.speed;
  const std::string& speed_name = motion.speed_name;
  require_share("`HeatSettings::fraction`", c.heat.fraction);
  require_share("`HeatSettings::of_plastic_work`", c.heat.of_plastic_work);
  if (c.heat.partition)
    require_share("`HeatSettings::partition`", *c.heat.partition);
  if (c.heat.conductance && !(*c.heat.conductance >= 0.0 && std::isfinite(*c.heat.conductance)))
    throw PlanError("`HeatSettings::conductance` = {:g} W/(m^2 K); allowed: >= 0, or none", *c.heat.conductance);
  if (c.heat.reference && !(*c.heat.reference > 0.0 && std::isfinite(*c.heat.reference)))
    throw PlanError("`HeatSettings::reference` = {:g} m; allowed: > 0, or none", *c.heat.reference);
  for (const auto& [name, body] : {std::pair{"lower", &c.lower}, {"upper", &c.upper}})
    require_solid(name, body->material);
  if (speed && !(*speed > 0.0 && std::isfinite(*speed)))
    throw PlanError("{} = {:g} {}; allowed: > 0", speed_name, *speed, motion.unit);
  require_source(c);
  if (!is_heated(c))
    return;
  if (!speed)
    throw PlanError("{} is missing: with {} and the thermal constants of a body the heat "
                    "depends on it; allowed: a {} > 0, as \"1 {}\"; or no thermal constants",
                    speed_name, c.heat.source.exists() ? "a heat source" : "friction", motion.name, motion.unit);
  for (const auto& [name, body] : {std::pair{"lower", &c.lower}, {"upper", &c.upper}})
    require_coat(c, name, body->material);
  if (c.heat.regime == elastoplastic::HeatRegime::steady)
    require_steady(c, motion);
  require_two_sides(c, c.lower.material, c.upper.material);
  for (const auto& [name, body] : {std::pair{"lower", &c.lower}, {"upper", &c.upper}})
    if (!body->material.thermal && !body->material.elastic.is_rigid())
      throw PlanError("{} is missing, but the other body has thermal constants; allowed: thermal constants of both "
                      "bodies, of none, or a rigid body, which without them takes no heat",
                      member_of(name, "material.thermal"));
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
                      "stop (`HeatSettings::at_melting`); allowed: less speed, load or friction, or "
                      "`HeatSettings::at_melting` = \"go_on\". All earlier steps are kept",
                      where, name, temperature, *melting));
  }
}

void require_source_fits(const Numerics& numerics, const SurfaceGrid& contact)
{
  const elastoplastic::HeatSource& source = numerics.heat.source;
  if (!source.is_on_body())
    return;
  const bool is_disc = source.shape == elastoplastic::HeatSource::Shape::disc;
  const char* size = is_disc ? "`HeatSource::radius`" : "`HeatSource::length`";
  if (is_plane(contact) && (is_disc || source.width))
    throw PlanError::at(
        "`HeatSource::shape`",
        "`HeatSettings::source`: in plane strain nothing varies along y; allowed: a rectangle without width");
  constexpr double rounding = 1.0 + 1e-9;
  const elastoplastic::SourceReach most = elastoplastic::reach(source);
  if (const double half = 0.5 * contact.nx * contact.dx; most.x > half * rounding)
    throw PlanError::at(size,
                        "`HeatSettings::source` reaches {:g} m from the middle of the contact along x; allowed: up to "
                        "{:g} m, half of the {}",
                        most.x, half, contact.is_periodic_x() ? "period" : "contact grid");
  if (const double half = 0.5 * contact.ny * contact.dy; most.y > half * rounding)
    throw PlanError::at(is_disc ? size : "`HeatSource::width`",
                        "`HeatSettings::source` reaches {:g} m from the middle of the contact along y; allowed: up to "
                        "{:g} m, half of the {}",
                        most.y, half, contact.is_periodic_y() ? "period" : "contact grid");
}

bool shares_alike(const Numerics& numerics)
{
  return numerics.heat.share() == 0.5 && !numerics.heat.source.is_on_body();
}

} // namespace brinell::simulation
