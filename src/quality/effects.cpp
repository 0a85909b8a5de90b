// SPDX-License-Identifier: BSD-3-Clause
#include "judgement_parts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <optional>
#include <string_view>

/// Expected errors and warnings of the effects between the surfaces.
namespace brinell::quality
{

using namespace simulation;

namespace
{

constexpr double largest_wear_step =
    0.05; ///< wear in one increment over the approach, which is about the relative change of the pressure
constexpr double largest_worn_share_of_layer = 0.25; ///< worn depth over the thickness of a layer of cells

// docs/verification/accuracy.md (expected error)
constexpr Documented contact_resistance{.quantity = "contact resistance",
                                        .name = "current.min_resistance_ohm",
                                        .error = 0.03,
                                        .cells = 5.0,
                                        .order = 1.0,
                                        .of = Documented::Of::elastic_contact,
                                        .of_steps = 0.05,
                                        .on_textures = 0.9};

/// Error of the conductance, found by the same operator.
Documented contact_conductance(const Facts& /*facts*/)
{
  Documented conductance = contact_resistance;
  conductance.quantity = "thermal contact conductance";
  conductance.name = "conduction.conductance_W_K";
  return conductance;
}

/// Error of the worn depth, which goes with the slip.
Documented worn_depth(const Facts& f)
{
  Documented depth = f.slip;
  depth.quantity = "worn depth";
  depth.name = "wear.max_depth_*_m";
  return depth;
}

void warn_of_wear(const Facts& facts, const RunTotals& totals, std::vector<Warning>& warnings)
{
  if (const double share = totals.max_wear_step / facts.approach; share > largest_wear_step)
    warnings.push_back(
        {"long_wear_step",
         fmt::format("the worn depth of one increment is up to {}, {} of the approach, so that the pressure changes "
                     "considerably within an increment; use smaller steps, or a smaller wear coefficient",
                     length_text(totals.max_wear_step), percent_text(share))});
  const std::array worn{totals.max_worn_depth_lower, totals.max_worn_depth_upper};
  for (std::size_t side = 0; side < 2; ++side)
    if (facts.materials[side]->is_plastic() && totals.max_equivalent_plastic_strain > 0.0 &&
        worn[side] > largest_worn_share_of_layer * facts.cell[2])
      warnings.push_back(
          {"worn_strain",
           fmt::format(
               "the {} surface has a worn depth of up to {}, {} of the thickness of a layer of cells: plastic strain "
               "and residual stress keep their depth below the worn surface, which is an estimate above {}",
               side == 0 ? "lower" : "upper", length_text(worn[side]), percent_text(worn[side] / facts.cell[2]),
               percent_text(largest_worn_share_of_layer))});
  warn_of_worn_coats(facts, totals, warnings);
}

/// Warns where the contact moves on before the heat of its spots has become steady.
void warn_of_short_passage(const Facts& facts, const RunTotals& totals, std::vector<Warning>& warnings)
{
  constexpr double short_time = 0.2; // over that of the motion
  const double radius = totals.coverage.patch_cells * std::min(facts.cell[0], facts.cell[1]);
  double time = 0.0;
  for (const constitutive::Material* material : facts.materials)
    if (material->thermal)
      time = std::max(time, radius * radius / material->thermal->diffusivity());
  if (facts.heating_time && time > short_time * *facts.heating_time)
    warnings.push_back({"transient_current",
                        fmt::format("contact_temperature and the resistance of the hot contact hold for the steady "
                                    "state, which a spot of {} needs about {:.2g} s to reach: not short against {:.2g} "
                                    "s {}; contact_temperature is then too high{}",
                                    length_text(radius), time, *facts.heating_time, facts.while_heated,
                                    facts.is_heated ? ", max_temperature_* follow the heat in time" : "")});
}

void warn_of_current(const Facts& facts, const RunTotals& totals, std::vector<Warning>& warnings)
{
  if (!facts.effect_settings.current.drives())
    return;
  if (std::isnan(totals.max_contact_temperature))
    warnings.push_back({"no_steady_current",
                        "the current is larger than any that the contact bears in a steady state: it would melt or "
                        "evaporate. Resistance, temperature, and the voltage or the current that is not given are no "
                        "numbers in these steps; density and heat are those of the cold contact"});
  warn_of_short_passage(facts, totals, warnings);
  if (totals.softening_error > 0.0)
    warnings.push_back({"unsteady_softening",
                        fmt::format("in an increment the softening around the spots still changed by {} of the yield "
                                    "stress when its iteration was ended: plastic strain and resistance are uncertain",
                                    percent_text(totals.softening_error))});
  for (std::size_t side = 0; side < 2; ++side)
    if (const constitutive::Material& material = *facts.materials[side]; material.softening)
      if (const auto melting = constitutive::melting_temperature(*material.softening);
          melting && totals.max_contact_temperature >= *melting)
        warnings.push_back({"melting_current",
                            fmt::format("the current heats the contact to {:.0f} degC in a steady state, and the {} "
                                        "body melts at {:.0f} degC: spots that melt spread, and conduct better than "
                                        "contact_resistance says{}",
                                        totals.max_contact_temperature, side == 0 ? "lower" : "upper", *melting,
                                        facts.is_softened_by_current[side] && !facts.is_heated
                                            ? "; while it would melt, its softening stays that of the step before"
                                            : "")});
  if (facts.is_heated) // the bodies feel the heat of the current beside that of friction
    return;
  constexpr double warm = 100.0; // [K]
  for (std::size_t side = 0; side < 2; ++side)
  {
    const constitutive::Material& material = *facts.materials[side];
    const double rise = totals.max_contact_temperature - material.temperature;
    if (rise > warm && material.is_plastic() && !facts.is_softened_by_current[side])
      warnings.push_back(
          {"hot_current",
           fmt::format("the current heats the contact to {:.0f} degC; the {} body yields as if it had "
                       "its bulk temperature of {:.0f} degC",
                       totals.max_contact_temperature, side == 0 ? "lower" : "upper", material.temperature)});
  }
}

struct Judged
{
  std::string_view effect;
  Documented (*documented)(const Facts&);
  void (*warn)(const Facts&, const RunTotals&, std::vector<Warning>&);
};

constexpr std::array judged_effects{
    Judged{"wear", worn_depth, warn_of_wear},
    Judged{"current", [](const Facts&) { return contact_resistance; }, warn_of_current},
    Judged{"conduction", contact_conductance, [](const Facts&, const RunTotals&, std::vector<Warning>&) {}}};

} // namespace

std::optional<Documented> documented_of_effect(std::string_view effect, const Facts& facts)
{
  for (const Judged& one : judged_effects)
    if (one.effect == effect)
      return one.documented(facts);
  return std::nullopt;
}

void warn_of_effects(const Facts& facts, const RunTotals& totals, std::vector<Warning>& warnings)
{
  for (const Judged& one : judged_effects)
    if (std::find(facts.effects.begin(), facts.effects.end(), one.effect) != facts.effects.end())
      one.warn(facts, totals, warnings);
}

} // namespace brinell::quality
