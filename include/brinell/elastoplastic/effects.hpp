// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/elastoplastic/conduction.hpp"
#include "brinell/elastoplastic/wear.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <string_view>
#include <vector>

/// The effects that the engine has, each described beside its physics: settings, totals, columns, fields. A new one is a member of
/// `Effects`, a base of `EffectTotals`, part of `effect_columns` and `effect_fields`, and a line of the table in effects.cpp.
/// Histories, summaries, result files, Python, checkpoints and the increment loop over them: docs/developer/effects.md.
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
struct EffectTotals : WearTotals, CurrentTotals, ConductionTotals
{
  /// Work of the drive that they have used up [J].
  [[nodiscard]] double work_of_effects() const { return work_of_wear; }
};

/// A total in files.
using EffectColumn = EffectColumnOf<EffectTotals>;

namespace detail
{

template <typename Item, std::size_t... sizes>
constexpr auto joined(const std::array<Item, sizes>&... parts)
{
  std::array<Item, (sizes + ...)> all{};
  auto next = all.begin();
  ((next = std::copy(parts.begin(), parts.end(), next)), ...);
  return all;
}

template <typename Totals, std::size_t count>
constexpr auto of_all(const std::array<EffectColumnOf<Totals>, count>& columns)
{
  std::array<EffectColumn, count> all{};
  for (std::size_t i = 0; i < count; ++i)
    all[i] = {columns[i].in_summary, columns[i].column, columns[i].effect, columns[i].traits};
  return all;
}

} // namespace detail

inline constexpr auto effect_columns =
    detail::joined(detail::of_all(wear_columns), detail::of_all(current_columns), detail::of_all(conduction_columns));
inline constexpr auto effect_fields = detail::joined(wear_fields, current_fields);

/// Place of a field in `effect_fields`, from its name: another name does not compile.
struct EffectFieldIndex
{
  // NOLINTNEXTLINE(google-explicit-constructor)
  consteval EffectFieldIndex(const char* name)
  {
    while (std::string_view(effect_fields[value].name) != name) // NOLINT: past the end there is no constant
      ++value;
  }
  std::size_t value = 0;
};

/// Fields of the effects on one grid, in the order of `effect_fields`; empty: not on this grid, or without the effect.
struct EffectFields
{
  std::array<std::vector<double>, effect_fields.size()> of_effects{};

  [[nodiscard]] const std::vector<double>& effect(EffectFieldIndex field) const { return of_effects[field.value]; }
};

/// Values of a field of an effect; empty without the effect.
[[nodiscard]] std::span<const double> values_of(const EffectField& field,
                                                std::span<const std::unique_ptr<Effect>> effects, std::size_t side);

/// Effects that act, in the order in which they do.
/// @param compliance  of the contact; must outlive the effects
/// @param modulus     of the contact [Pa]
[[nodiscard]] std::vector<std::unique_ptr<Effect>> make_effects(const Effects& settings,
                                                                const halfspace::SurfaceCompliance& compliance,
                                                                const VolumeGrid& lower, const VolumeGrid& upper,
                                                                double modulus, const Current::Materials& materials);

} // namespace brinell::elastoplastic
