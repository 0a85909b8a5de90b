// SPDX-License-Identifier: BSD-3-Clause
#pragma once

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

  /// Whether bodies that are mirror images of each other stay so.
  [[nodiscard]] bool are_alike() const { return wear.is_alike(); }
  /// Whether pressure and effects are solved in turns: some of them are not proportional to the pressure.
  [[nodiscard]] bool need_turns() const { return wear.wears() && wear.kind != WearLaw::Kind::archard; }
  bool operator==(const Effects&) const = default;
};

/// Names of the effects that act, as in summaries.
[[nodiscard]] std::vector<std::string_view> names_of(const Effects& settings);

/// Totals of all effects since the start of a run; zero without them.
struct EffectTotals : WearTotals
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
};

inline constexpr std::array<EffectColumn, 6> effect_columns{{
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
}};

/// Effects that act, in the order in which they do.
/// @param modulus  of the contact [Pa]
[[nodiscard]] std::vector<std::unique_ptr<Effect>> make_effects(const Effects& settings, const SurfaceGrid& contact,
                                                                const SurfaceGrid& lower, const SurfaceGrid& upper,
                                                                double modulus);

} // namespace brinell::elastoplastic
