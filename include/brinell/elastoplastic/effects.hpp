// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/elastoplastic/current.hpp"
#include "brinell/elastoplastic/wear.hpp"
#include "brinell/foundation/column.hpp"

#include <array>
#include <memory>
#include <string_view>
#include <vector>

/// The effects that the engine has. A new one is a member of `Effects`, a base of `EffectTotals` with its columns, and a line in
/// `make_effects`. Histories, summaries, checkpoints and the increment loop over them.
namespace brinell::elastoplastic
{

/// Settings of the effects between two surfaces; by default none of them acts.
struct Effects
{
  WearLaw wear{};
  CurrentDrive current{}; ///< between bodies that conduct

  /// Whether bodies that are mirror images of each other stay so.
  [[nodiscard]] bool are_alike() const { return wear.is_alike(); }
  /// Whether pressure and effects are solved in turns: some of them are not proportional to the pressure.
  [[nodiscard]] bool need_turns() const { return wear.wears() && wear.kind != WearLaw::Kind::archard; }
  bool operator==(const Effects&) const = default;
};

/// Names of the effects that act, as in summaries.
[[nodiscard]] std::vector<std::string_view> names_of(const Effects& settings, const Current::Materials& materials);

/// Totals of all effects since the start of a run, and numbers at its end; zero without them.
struct EffectTotals : WearTotals, CurrentTotals
{
  /// Work of the drive that they have used up [J].
  [[nodiscard]] double work_of_effects() const { return work_of_wear; }
};

/// A total in files.
struct EffectColumn
{
  std::string_view effect;     ///< part of the summary
  std::string_view in_summary; ///< name there
  Column<EffectTotals> column;
  bool acts_at_rest = false; ///< acts between surfaces that never slide, too
};

template <typename Member>
constexpr EffectColumn of_current(std::string_view in_summary, std::string_view name, std::string_view unit,
                                  Member member, std::string_view text)
{
  return {"current", in_summary, {name, unit, member, text}, true};
}

inline constexpr std::array<EffectColumn, 16> effect_columns{{
    {"wear",
     "volume_lower_m3",
     {"worn_volume_lower", "m^3", &EffectTotals::worn_volume_lower, "worn volume of the lower body"}},
    {"wear",
     "volume_upper_m3",
     {"worn_volume_upper", "m^3", &EffectTotals::worn_volume_upper, "worn volume of the upper body"}},
    {"wear",
     "max_depth_lower_m",
     {"max_worn_depth_lower", "m", &EffectTotals::max_worn_depth_lower, "largest worn depth of the lower surface"}},
    {"wear",
     "max_depth_upper_m",
     {"max_worn_depth_upper", "m", &EffectTotals::max_worn_depth_upper, "largest worn depth of the upper surface"}},
    {"wear",
     "max_depth_of_an_increment_m",
     {"max_wear_step", "m", &EffectTotals::max_wear_step,
      "largest worn depth of both surfaces together in one increment so far"}},
    {"wear",
     "work_J",
     {"work_of_wear", "J", &EffectTotals::work_of_wear, "work of the pressure on the worn depth since the start"}},
    of_current("resistance_ohm", "contact_resistance", "ohm", &EffectTotals::contact_resistance,
               "resistance between points far from the contact in both bodies; 0 unless both conduct"),
    of_current("current_A", "current", "A", &EffectTotals::current, "electric current"),
    of_current("voltage_V", "voltage", "V", &EffectTotals::voltage, "voltage between points far from the contact"),
    of_current("power_W", "electric_power", "W", &EffectTotals::electric_power, "voltage times current"),
    of_current("max_density_A_m2", "max_current_density", "A/m^2", &EffectTotals::max_current_density,
               "largest density of the current, mean over a cell"),
    of_current("spots", "current_spots", "1", &EffectTotals::current_spots, "patches of the contact"),
    of_current("largest_spot_share", "largest_spot_share", "1", &EffectTotals::largest_spot_share,
               "largest share of a patch in the current"),
    of_current("temperature_degC", "contact_temperature", "degC", &EffectTotals::contact_temperature,
               "largest temperature by the current alone, steady"),
    of_current("min_resistance_ohm", "min_contact_resistance", "ohm", &EffectTotals::min_contact_resistance,
               "smallest resistance of the contact since the start"),
    of_current("max_temperature_degC", "max_contact_temperature", "degC", &EffectTotals::max_contact_temperature,
               "largest temperature by the current since the start"),
}};

/// Effects that act, in the order in which they do.
/// @param compliance  of the contact; must outlive the effects
/// @param modulus     of the contact [Pa]
[[nodiscard]] std::vector<std::unique_ptr<Effect>> make_effects(const Effects& settings,
                                                                const halfspace::SurfaceCompliance& compliance,
                                                                const SurfaceGrid& lower, const SurfaceGrid& upper,
                                                                double modulus, const Current::Materials& materials);

} // namespace brinell::elastoplastic
