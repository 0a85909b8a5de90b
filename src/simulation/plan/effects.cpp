// SPDX-License-Identifier: BSD-3-Clause
#include "effects.hpp"

#include "heat.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
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

using elastoplastic::CurrentDrive;

/// A list as messages name it: "2", "[0, 1]".
std::string text_of(const std::vector<double>& values)
{
  return values.size() == 1 ? fmt::format("{:g}", values[0]) : fmt::format("[{:g}]", fmt::join(values, ", "));
}

/// The first of the numbers of a film, as messages name it; empty if there is no film.
std::string given_of(const elastoplastic::FilmLaw& film)
{
  if (film.resistance > 0.0)
    return fmt::format("`FilmLaw::resistance` = {:g} ohm m^2", film.resistance);
  if (film.resistivity > 0.0)
    return fmt::format("`FilmLaw::resistivity` = {:g} ohm m", film.resistivity);
  return film.growth > 0.0 ? fmt::format("`FilmLaw::growth` = {:g} ohm m", film.growth) : std::string();
}

/// The first of the drives and the film that is given, as messages name it; empty if none is.
std::string given_of(const CurrentDrive& drive)
{
  if (!drive.current.empty())
    return fmt::format("`CurrentDrive::current` = {} A", text_of(drive.current));
  if (!drive.voltage.empty())
    return fmt::format("`CurrentDrive::voltage` = {} V", text_of(drive.voltage));
  return given_of(drive.film);
}

void require_at_least_zero(const char* key, double value)
{
  if (!(value >= 0.0 && std::isfinite(value)))
    throw PlanError("{} = {:g}; allowed: number >= 0", key, value);
}

void require_steps(const CurrentDrive& drive)
{
  if (drive.steps.empty())
    return;
  const std::size_t values = std::max(drive.current.size(), drive.voltage.size());
  const std::string given = fmt::format("`CurrentDrive::steps` = {}", text_of(drive.steps));
  if (values == 0)
    throw PlanError("{}, but there is no current; allowed: with `CurrentDrive::current` or `CurrentDrive::voltage`",
                    given);
  if (drive.steps.size() != values)
    throw PlanError("{} has {} steps, but {} has {} values; allowed: as many steps as values", given,
                    drive.steps.size(), given_of(drive), values);
  for (std::size_t n = 0; n < drive.steps.size(); ++n)
    if (!(drive.steps[n] >= 0.0 && std::isfinite(drive.steps[n])) || (n > 0 && !(drive.steps[n] > drive.steps[n - 1])))
      throw PlanError("{}: element {} is {:g}; allowed: steps >= 0 in ascending order", given, n + 1, drive.steps[n]);
}

void require_film(const elastoplastic::FilmLaw& film, const Numerics& numerics, const std::string& reason)
{
  require_at_least_zero("`FilmLaw::resistance`", film.resistance);
  require_at_least_zero("`FilmLaw::resistivity`", film.resistivity);
  require_at_least_zero("`FilmLaw::growth`", film.growth);
  require_at_least_zero("`FilmLaw::wear`", film.wear);
  if (film.limit && !(*film.limit >= film.resistance && *film.limit > 0.0 && std::isfinite(*film.limit)))
    throw PlanError("`FilmLaw::limit` = {:g} ohm m^2 with `FilmLaw::resistance` = {:g} ohm m^2; allowed: > 0 and not "
                    "less than the film at the start",
                    *film.limit, film.resistance);
  if (film.growth > 0.0 && !reason.empty())
    throw PlanError("`FilmLaw::growth` = {:g} ohm m: {}", film.growth, reason);
  if (film.wear > 0.0 && !numerics.wear.wears())
    throw PlanError("`FilmLaw::wear` = {:g} ohm m, but nothing wears; allowed: with `WearLaw::lower` or "
                    "`WearLaw::upper`",
                    film.wear);
}

/// Checks the thickness of a film on a body.
void require_cover(const ShapedBody& body, const std::string& name, const elastoplastic::FilmLaw& film,
                   const Domain& domain)
{
  const std::string key = member_of(name, "film");
  for (const TexturePart& part : body.film.parts)
  {
    const auto* map = std::get_if<HeightMap>(&part);
    if (!map)
      throw PlanError("{}: a film needs a height map of its thickness; allowed: one map", key);
    for (const double thickness : map->heights)
      if (!(thickness >= 0.0 && std::isfinite(thickness)))
        throw PlanError("{} has a thickness of {:g} m; allowed: numbers >= 0", key, thickness);
    if (film.resistivity == 0.0)
      throw PlanError("{} has no resistivity; allowed: with `FilmLaw::resistivity` > 0", key);
    if (const auto reason = reason_against_texture(body.film, domain))
      throw PlanError("{} is not compatible with the periodic grid: {}", key, *reason);
  }
}

void require_electrical(const constitutive::Electrical& electrical, const std::string& body, const std::string& table)
{
  if (!(electrical.resistivity > 0.0 && std::isfinite(electrical.resistivity)))
    throw PlanError("{} = {:g} ohm m; allowed: > 0", member_of(body, table + ".resistivity"), electrical.resistivity);
  if (!(electrical.temperature_coefficient >= 0.0 && std::isfinite(electrical.temperature_coefficient)))
    throw PlanError("{} = {:g} 1/K; allowed: >= 0", member_of(body, table + ".temperature_coefficient"),
                    electrical.temperature_coefficient);
}

/// Checks the layers of a body: all of them conduct, or none.
void require_layers_conduct(const constitutive::Material& material, const std::string& body, const CurrentDrive& drive)
{
  for (std::size_t n = 0; n < material.layers.size(); ++n)
  {
    const auto& electrical = material.layers[n].electrical;
    const std::string table = fmt::format("material.layers[{}].electrical", n);
    if (electrical && !material.electrical)
      throw PlanError("{} = {:g} ohm m, but the {} body insulates; allowed: with {}",
                      member_of(body, table + ".resistivity"), electrical->resistivity, body,
                      member_of(body, "material.electrical.resistivity"));
    if (material.electrical && !electrical)
      throw PlanError("{} is missing: the {} body conducts; allowed: a resistivity > 0 of each of its layers",
                      member_of(body, table + ".resistivity"), body);
    if (electrical)
      require_electrical(*electrical, body, table);
  }
  const bool has_film = !given_of(drive.film).empty();
  if (has_film && drive.drives() && !material.layers.empty() && material.electrical)
    throw PlanError("{} with {} and {}: the heat of a film on layers is not computed; allowed: two of them",
                    given_of(drive), given_of(drive.film), member_of(body, "material.layers"));
}

/// Checks that voltage and temperature follow Kohlrausch under a coat (docs/theory/electrical.md, layers): the bulk is equally warm, all
/// follow Wiedemann and Franz, and their resistivities grow alike. A surface between metals of other kinds is not an equipotential.
void require_like_conductors(const PairCase& c)
{
  const constitutive::Material &lower = c.lower.material, &upper = c.upper.material;
  if ((lower.layers.empty() && upper.layers.empty()) || !c.current.drives() || !lower.electrical || !upper.electrical)
    return;
  const std::string why = "the temperature of a current in coated bodies follows from the voltage only where ";
  if (lower.temperature != upper.temperature)
    throw PlanError("{} with {} = {:g} degC and {} = {:g} degC: {}both are equally warm; allowed: the same temperature",
                    given_of(c.current), member_of("lower", "material.temperature"), lower.temperature,
                    member_of("upper", "material.temperature"), upper.temperature, why);
  for (const auto& [name, material] : {std::pair{"lower", &lower}, {"upper", &upper}})
  {
    if (material->thermal)
      throw PlanError("{} with {} and layers: {}heat is conducted as current is; allowed: no thermal constants, or no "
                      "layers",
                      given_of(c.current), member_of(name, "material.thermal"), why);
    std::vector<constitutive::Electrical> all{*material->electrical};
    for (const constitutive::Coat& layer : material->layers)
      all.push_back(*layer.electrical);
    for (const constitutive::Electrical& one : all)
      if (one.temperature_coefficient != lower.electrical->temperature_coefficient)
        throw PlanError(
            "{} with temperature coefficients of {:g} and {:g} 1/K and layers: {}all resistivities grow alike; "
            "allowed: the same {} of both bodies and their layers",
            given_of(c.current), lower.electrical->temperature_coefficient, one.temperature_coefficient, why,
            member_of(name, "material.electrical.temperature_coefficient"));
  }
}

void require_current(const PairCase& c, const std::string& why_no_slip)
{
  const CurrentDrive& drive = c.current;
  for (const auto& [key, values] :
       {std::pair{"`CurrentDrive::current`", &drive.current}, {"`CurrentDrive::voltage`", &drive.voltage}})
    for (const double value : *values)
      require_at_least_zero(key, value);
  require_film(drive.film, c, why_no_slip);
  require_cover(c.lower, "lower", drive.film, c.domain);
  require_cover(c.upper, "upper", drive.film, c.domain);
  if (drive.film.resistivity > 0.0 && c.lower.film.is_smooth() && c.upper.film.is_smooth())
    throw PlanError("{}, but no surface has a film; allowed: with {} or {}", given_of(drive.film),
                    member_of("lower", "film"), member_of("upper", "film"));
  if (!drive.current.empty() && !drive.voltage.empty())
    throw PlanError("{} together with `CurrentDrive::voltage` = {} V: each follows from the other; allowed: one of "
                    "them",
                    given_of(drive), text_of(drive.voltage));
  require_steps(drive);
  for (const auto& [name, body] : {std::pair{"lower", &c.lower}, {"upper", &c.upper}})
  {
    require_layers_conduct(body->material, name, drive);
    if (body->material.electrical)
    {
      require_electrical(*body->material.electrical, name, "material.electrical");
      require_solid(name, body->material);
    }
    else if (const std::string given = given_of(drive); !given.empty())
      throw PlanError("{}: the {} body insulates; allowed: with {}", given, name,
                      member_of(name, "material.electrical.resistivity"));
  }
  require_like_conductors(c);
}

constexpr std::array checks{require_current, require_wear};

} // namespace

void require_effects(const PairCase& c, const std::string& why_no_slip)
{
  for (const auto check : checks)
    check(c, why_no_slip);
}

} // namespace brinell::simulation
