// SPDX-License-Identifier: BSD-3-Clause
#include "judgement_parts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <optional>

/// Warnings about the course of a run.
namespace brinell::quality
{

using namespace simulation;

namespace
{

constexpr double largest_strain = 0.05;    ///< products of strains are neglected, an error of 5 % of the strain
constexpr double largest_imbalance = 0.02; ///< error of the energy balance over the largest work
/// Largest rise above the bulk temperature, for which the constants are given [K]. Carbon steel at 520 instead of 20 deg C has
/// 0.54 of its elastic modulus, 0.72 of its yield stress, 0.69 of its conductivity and 1.55 times its specific heat (EN
/// 1993-1-2:2005, 3.2.1 and 3.4.1).
constexpr double largest_warming = 500.0;

constexpr double largest_held_share = 0.01;    ///< of the heat, through cells that neither touch nor are open
constexpr double largest_limited_share = 0.05; ///< of the contact at its shear limit, whose effect on a run is as small

/// Yield stress of the softer surface before it hardens, with its depth profile [Pa]; infinite if neither body can yield.
/// @param hottest  largest temperatures of the lower and the upper surface in the run [deg C]; nullptr: cold
double yield_stress_of_surfaces(const Facts& facts, const std::array<double, 2>* hottest)
{
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t side = 0; side < 2; ++side)
  {
    const constitutive::Material& material = *facts.materials[side];
    const auto& law = material.layers.empty() ? material.hardening : material.layers.front().hardening;
    if (!law)
      continue;
    double yield = material.yield_factor.at(0.0, 1.0) * constitutive::initial_yield_stress(*law);
    if (hottest != nullptr && material.softening)
      yield *= constitutive::softening_factor(*material.softening, (*hottest)[side]);
    least = std::min(least, yield);
  }
  return least;
}

/// Whether the limit of the shear is the strength of a surface, not a given one below it. Plastic strain of a surface
/// at its limit concentrates in the uppermost layers of cells; if it does not harden, it grows without bound as the
/// layers get thinner.
/// @param totals  of the run, with the temperatures that soften the surfaces; nullptr: before it
bool is_limited_by_strength(const Facts& facts, const RunTotals* totals)
{
  const bool softens = totals != nullptr && facts.is_heated;
  const double strength =
      yield_stress_of_surfaces(facts, softens ? &totals->max_temperature : nullptr) / std::sqrt(3.0);
  return facts.friction > 0.0 && facts.can_yield && facts.shear_limit >= strength;
}

/// Whether smooth bodies yield in theory. Surfaces that stick in places have less shear than the theory of sliding takes.
bool misses_first_yield(const Facts& facts)
{
  const bool holds = facts.friction == 0.0 || !facts.may_stick;
  return holds && facts.first_yield && facts.peak_over_yield > 1.0 && std::isfinite(facts.peak_over_yield);
}

} // namespace

bool flows_at_surface(const Facts& facts, const RunTotals& totals)
{
  return is_limited_by_strength(facts, &totals) && totals.max_share_at_shear_limit > largest_limited_share;
}

double estimated_share_at_limit(const Facts& facts)
{
  // Mean pressure over yield stress of a fully plastic contact (Tabor 1951); friction and sliding make it less.
  constexpr double hardness = 2.8;
  if (!is_limited_by_strength(facts, nullptr) || !facts.slides)
    return 0.0;
  const double yield = yield_stress_of_surfaces(facts, nullptr);
  const double most = facts.friction * std::min(facts.peak_pressure, hardness * yield);
  const double limit = yield / std::sqrt(3.0);
  // A pressure p0 sqrt(1 - r^2/a^2) exceeds p within the radius sqrt(1 - p^2/p0^2) a.
  return most > limit ? 1.0 - std::pow(limit / most, 2) : 0.0;
}

bool warn_of_expected_flow(const Facts& facts, std::vector<Warning>& warnings)
{
  const double share = estimated_share_at_limit(facts);
  if (!(share > largest_limited_share))
    return false;
  warnings.push_back(
      {"surface_flow",
       fmt::format("by estimate, the shear will be at the limit of a surface in up to {} of the contact, where plastic "
                   "strain concentrates in the uppermost layers of cells. The convergence tables then do not apply, "
                   "and no errors are expected before the run, which will report the share that it finds",
                   percent_text(share))});
  return true;
}

void warn_of_course(const Facts& facts, const RunTotals& totals, std::vector<Warning>& warnings)
{
  if (totals.coverage.contact_columns == 0)
    warnings.push_back({"no_contact",
                        "the bodies do not touch in any step: all loads are zero. An approach counts from "
                        "the first touch of the smooth shapes; dents and the valleys of a texture take "
                        "the surfaces farther apart"});
  else if (facts.can_yield && totals.max_equivalent_plastic_strain == 0.0)
    warnings.push_back(
        misses_first_yield(facts)
            ? Warning{"missed_yield",
                      fmt::format(
                          "no cell has yielded, but by {} the bodies yield: the elastic peak pressure is {:.4g} "
                          "times that at first yield. The largest stress lies between the centres of the cells"
                          "{}: use a finer grid.resolution or grid.spacing",
                          facts.is_yield_exact ? "the exact solution of smooth elastic bodies"
                                               : "the estimate for a round contact",
                          facts.peak_over_yield,
                          facts.friction > 0.0 ? ", with friction above about 0.3 at the trailing edge" : "")}
            : Warning{"no_yield",
                      "nothing has yielded, although a yield stress is given: the whole result is elastic"});
  if (totals.max_equivalent_plastic_strain > largest_strain)
    warnings.push_back(
        {"large_strain",
         fmt::format(
             "the plastic strain reaches {}, but the theory assumes small strains: above {} the result is an estimate",
             percent_text(totals.max_equivalent_plastic_strain), percent_text(largest_strain))});
  if (!(std::abs(totals.energy_balance_error) <= largest_imbalance))
    warnings.push_back(
        {"energy_balance",
         fmt::format("the energy balance has an error of {} of the largest work: use smaller steps or cells",
                     percent_text(totals.energy_balance_error))});
  if (flows_at_surface(facts, totals))
    warnings.push_back(
        {"surface_flow",
         fmt::format(
             "in up to {} of the contact the shear is at the limit of the surface: plastic strain concentrates "
             "in the uppermost layers of cells, and the convergence tables do not apply. From 8 to 24 cells per "
             "contact radius, forces of such runs changed by 5 to 30 %, heat of friction and plastic work by 10 "
             "to 50 %: compare with finer cells, or use --accuracy",
             percent_text(totals.max_share_at_shear_limit))});
  if (!facts.hardens && is_limited_by_strength(facts, &totals) && totals.max_share_at_shear_limit > 0.0)
    warnings.push_back(
        {"free_flow",
         fmt::format(
             "in up to {} of the contact the shear is at the limit of a surface that does not harden: its "
             "plastic strain depends on the thickness of the uppermost layer of cells, forces and depths "
             "depend on it less; the hardening that the material has in reality, or a shear_limit below its yield "
             "stress, makes the strain definite",
             percent_text(totals.max_share_at_shear_limit))});
  if (totals.split_increments > 0)
    warnings.push_back({"split_increments",
                        fmt::format("{} increments did not converge in one piece and were split or solved by plain "
                                    "iteration. All of them have converged, but plastic strain may depend on how: "
                                    "compare with smaller steps, which are also faster",
                                    totals.split_increments)});
}

namespace
{

/// Text of the warning about a body so hot that its constants no longer hold.
std::string hot_surface_text(const char* name, const constitutive::Material& material, double hottest)
{
  const bool lacks_softening = material.is_plastic() && !material.softening;
  return fmt::format("the {} surface reaches {:.0f} degC, {:.0f} K above the bulk temperature, for which the constants "
                     "of the body{} hold: above a rise of {:.0f} K the result is an estimate{}",
                     name, hottest, hottest - material.temperature,
                     lacks_softening ? ", including its yield stress," : "", largest_warming,
                     lacks_softening ? "; give the material a softening law, or reduce speed or load" : "");
}

/// Depth that heat reaches while a point is heated, over the thickness of a layer of cells. None without thermal stress
/// that would matter to yield: E alpha T/(1 - nu) of the largest rise of the temperature, of the skin of a body.
std::optional<double> layers_of_hot_skin(const Facts& facts, const constitutive::Material& material, double rise)
{
  constexpr double share_of_yield = 0.1;
  const std::optional<constitutive::HardeningLaw> law = material.laws().front(); // of the skin
  if (!facts.has_thermal_stress || !facts.heating_time || !material.thermal || !law)
    return std::nullopt;
  const Elastic& skin = material.top();
  const Thermal& thermal = material.layers.empty() ? *material.thermal : material.layers.front().thermal.value();
  const double stress = skin.young_modulus * thermal.expansion * rise / (1.0 - skin.poisson_ratio);
  if (stress < share_of_yield * constitutive::initial_yield_stress(*law))
    return std::nullopt;
  return std::sqrt(4.0 * thermal.diffusivity() * *facts.heating_time) / facts.cell[2];
}

/// Layers of cells that the hot skin needs. With one, thermal yield at the surface is lost nearly whole, with two a third of its
/// strain is missing.
constexpr double fewest_layers_of_skin = 3.0;

} // namespace

void warn_of_heat(const Facts& facts, const RunTotals& totals, std::vector<Warning>& warnings)
{
  if (totals.share_of_held_cells > largest_held_share)
    warnings.push_back(
        {"undecided_contact",
         fmt::format(
             "{} of the heat passed through cells at the edge of the contact that open with this heat and close "
             "without it (imperfect contact): it is uncertain by as much, and what is next to them as well; "
             "finer cells make their share smaller",
             percent_text(totals.share_of_held_cells))});
  for (std::size_t side = 0; side < 2; ++side)
  {
    const constitutive::Material& material = *facts.materials[side];
    const double hottest = totals.max_temperature[side];
    if (!(hottest > material.temperature)) // not heated
      continue;
    const char* name = side == 0 ? "lower" : "upper";
    if (hottest - material.temperature > largest_warming)
      warnings.push_back({"hot_surface", hot_surface_text(name, material, hottest)});
    if (const auto layers = layers_of_hot_skin(facts, material, hottest - material.temperature);
        layers && *layers < fewest_layers_of_skin)
      warnings.push_back(
          {"thin_hot_skin",
           fmt::format(
               "{}, heat reaches only {} into the {} body, {:.2g} layers of cells; "
               "at least {:g} are needed for its thermal stress, and the yield that follows from it: use thinner "
               "cells (grid.spacing)",
               facts.while_heated, length_text(*layers * facts.cell[2]), name, *layers, fewest_layers_of_skin)});
    if (!material.softening)
      continue;
    if (const auto melting = constitutive::melting_temperature(*material.softening); melting && hottest >= *melting)
      warnings.push_back(
          {"melting", fmt::format("the {} surface reaches {:.0f} degC and melts at {:.0f} degC: molten material is "
                                  "treated as a solid with {} of its yield stress",
                                  name, hottest, *melting, percent_text(constitutive::least_softening_factor))});
    else if (!constitutive::covers(*material.softening, hottest))
      warnings.push_back(
          {"softening_range",
           fmt::format(
               "the {} surface reaches {:.0f} degC, beyond the table of its softening, whose last value is used", name,
               hottest)});
  }
}

} // namespace brinell::quality
