// SPDX-License-Identifier: BSD-3-Clause
#include "effects.hpp"

#include <array>
#include <cmath>
#include <fmt/format.h>
#include <utility>

namespace brinell::simulation
{

namespace
{

void require_wear(const PairCase& c, const std::string& why_no_slip)
{
  const elastoplastic::WearLaw& wear = c.wear;
  for (const auto& [key, coefficient] : {std::pair{"`WearLaw::lower`", wear.lower}, {"`WearLaw::upper`", wear.upper}})
    if (!(coefficient >= 0.0 && std::isfinite(coefficient)))
      throw PlanError("{} = {:g} 1/Pa; allowed: number >= 0", key, coefficient);
  if (!wear.wears())
    return;
  const std::string key = wear.lower > 0.0 ? "`WearLaw::lower`" : "`WearLaw::upper`";
  const std::string given = fmt::format("{} = {:g} 1/Pa", key, wear.lower > 0.0 ? wear.lower : wear.upper);
  if (!why_no_slip.empty())
    throw PlanError("{}: {}", given, why_no_slip);
  if (wear.kind == elastoplastic::WearLaw::Kind::energy && c.friction.coefficient == 0.0)
    throw PlanError("`WearLaw::kind` = \"energy\" with `Friction::coefficient` = 0: no friction work, "
                    "no wear; allowed: friction > 0, or the law \"archard\"");
}

/// The first of the drives and the film that is given, as messages name it; empty if none is.
std::string given_of(const elastoplastic::CurrentDrive& drive)
{
  if (drive.current)
    return fmt::format("`CurrentDrive::current` = {:g} A", *drive.current);
  if (drive.voltage)
    return fmt::format("`CurrentDrive::voltage` = {:g} V", *drive.voltage);
  return drive.film > 0.0 ? fmt::format("`CurrentDrive::film` = {:g} ohm m^2", drive.film) : std::string();
}

void require_electrical(const constitutive::Electrical& electrical, const std::string& body)
{
  if (!(electrical.resistivity > 0.0 && std::isfinite(electrical.resistivity)))
    throw PlanError("{} = {:g} ohm m; allowed: > 0", member_of(body, "material.electrical.resistivity"),
                    electrical.resistivity);
  if (!(electrical.temperature_coefficient >= 0.0 && std::isfinite(electrical.temperature_coefficient)))
    throw PlanError("{} = {:g} 1/K; allowed: >= 0", member_of(body, "material.electrical.temperature_coefficient"),
                    electrical.temperature_coefficient);
}

void require_current(const PairCase& c, const std::string& /*why_no_slip*/)
{
  const elastoplastic::CurrentDrive& drive = c.current;
  for (const auto& [key, value] : {std::pair{"`CurrentDrive::current`", drive.current.value_or(0.0)},
                                   {"`CurrentDrive::voltage`", drive.voltage.value_or(0.0)},
                                   {"`CurrentDrive::film`", drive.film}})
    if (!(value >= 0.0 && std::isfinite(value)))
      throw PlanError("{} = {:g}; allowed: number >= 0", key, value);
  if (drive.current && drive.voltage)
    throw PlanError("{} together with `CurrentDrive::voltage` = {:g} V: each follows from the other; allowed: one of "
                    "them",
                    given_of(drive), *drive.voltage);
  for (const auto& [name, body] : {std::pair{"lower", &c.lower}, {"upper", &c.upper}})
  {
    if (body->material.electrical)
      require_electrical(*body->material.electrical, name);
    else if (const std::string given = given_of(drive); !given.empty())
      throw PlanError("{}: the {} body insulates; allowed: with {}", given, name,
                      member_of(name, "material.electrical.resistivity"));
    if (drive.film > 0.0 && body->material.electrical->temperature_coefficient > 0.0)
      throw PlanError("`CurrentDrive::film` = {:g} ohm m^2: the current through a film is found for resistivities that "
                      "do not depend on temperature; allowed: with {} = 0",
                      drive.film, member_of(name, "material.electrical.temperature_coefficient"));
  }
}

constexpr std::array checks{require_current, require_wear};

} // namespace

void require_effects(const PairCase& c, const std::string& why_no_slip)
{
  for (const auto check : checks)
    check(c, why_no_slip);
}

} // namespace brinell::simulation
