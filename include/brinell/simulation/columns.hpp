// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/column.hpp"
#include "brinell/simulation/scenario.hpp"

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <string_view>

/// Tables of the numbers of each record. Each table stands once, in the header of its scenario; checkpoints, history.csv,
/// result.vtkhdf, summary.json and the Python package are generated from it.
namespace brinell::simulation
{

/// All columns of a record, in the order of the files. nullptr for a record without a table, so that looping over it does not
/// compile.
template <typename Record>
inline constexpr std::nullptr_t columns = nullptr;

/// Columns that the rows of all scenarios have.
namespace common
{

using Row = Column<StepRecord>;
inline constexpr Row step{"step", "1", &StepRecord::step,
                          "step, counts from 0 over all passes: the row of the history"};
inline constexpr Row pass{"pass", "1", &StepRecord::pass, "pass, counts from 1"};
inline constexpr Row contact_area{"contact_area", "m^2", &StepRecord::contact_area, "contact area"};
inline constexpr Row max_pressure{"max_pressure", "Pa", &StepRecord::max_pressure, "largest contact pressure"};
inline constexpr Row F_n{"F_n", "N", &StepRecord::F_n, "force normal to the plane of contact"};
/// Columns of the scenarios whose surfaces may slide.
inline constexpr Column<FrictionRecord> F_friction{"F_friction", "N", &FrictionRecord::F_friction,
                                                   "friction between the surfaces, along the plane of contact"};
inline constexpr Column<FrictionRecord> share_at_shear_limit{
    "share_at_shear_limit", "1", &FrictionRecord::share_at_shear_limit,
    "share of the contact where the shear is at the limit of the surface"};

/// Columns of the scenarios in which bodies may be heated.
inline constexpr std::array<Column<HeatedRecord>, 8> heated{{
    {"max_temperature_lower", "degC", &HeatedRecord::max_temperature_lower,
     "largest temperature of the lower surface in and around the contact; without heat the bulk temperature"},
    {"max_temperature_upper", "degC", &HeatedRecord::max_temperature_upper,
     "largest temperature of the upper surface in and around the contact; without heat the bulk temperature"},
    {"heat_lower", "J", &HeatedRecord::heat_lower,
     "heat that has entered the lower body by its surface since the start"},
    {"heat_upper", "J", &HeatedRecord::heat_upper,
     "heat that has entered the upper body by its surface since the start"},
    {"heat_of_source", "J", &HeatedRecord::heat_of_source, "heat of the source since the start"},
    {"heat_of_current", "J", &HeatedRecord::heat_of_current,
     "heat of the electric current in both bodies and the film between them since the start"},
    {"heat_of_plastic_work", "J", &HeatedRecord::heat_of_plastic_work,
     "heat of the plastic work of both bodies since the start"},
    {"work_of_expansion", "J", &HeatedRecord::work_of_expansion,
     "work of the bodies by thermal expansion since the start"},
}};

/// Columns that end each row.
inline constexpr std::array<Row, 10> ending{{
    {"work", "J", &StepRecord::work, "work of the drive since the start"},
    {"dissipation_lower", "J", &StepRecord::dissipation_lower, "plastic work in the lower body since the start"},
    {"dissipation_upper", "J", &StepRecord::dissipation_upper, "plastic work in the upper body since the start"},
    {"dissipation_friction", "J", &StepRecord::dissipation_friction, "heat of friction since the start"},
    {"energy_residual", "J", &StepRecord::energy_residual, "elastic energy locked in by the plastic strain"},
    {"energy_elastic", "J", &StepRecord::energy_elastic, "recoverable elastic energy of pressure and shear"},
    {"max_residual_lower", "m", &StepRecord::max_residual_lower, "largest residual displacement of the lower surface"},
    {"max_residual_upper", "m", &StepRecord::max_residual_upper, "largest residual displacement of the upper surface"},
    {"max_equivalent_plastic_strain", "1", &StepRecord::max_equivalent_plastic_strain,
     "largest equivalent plastic strain of both bodies"},
    {"evaluations", "1", &StepRecord::evaluations, "evaluations of the elastic-plastic operator in this step"},
}};

/// The columns of a row: those that begin it, those of heat in scenarios that have it, those of the effects between the surfaces
/// that may act, and the ending.
template <typename Record, std::size_t N>
constexpr auto row(const Column<Record> (&beginning)[N])
{
  constexpr bool is_heated = std::derived_from<Record, HeatedRecord>;
  constexpr auto may_act = [](const elastoplastic::EffectColumn& column)
  { return is_heated || column.traits.acts_at_rest; };
  constexpr auto& effects = elastoplastic::effect_columns;
  constexpr std::size_t middle = (is_heated ? heated.size() : 0) +
                                 static_cast<std::size_t>(std::count_if(effects.begin(), effects.end(), may_act));
  std::array<Column<Record>, N + middle + ending.size()> all{};
  auto next = std::copy(beginning, beginning + N, all.begin());
  if constexpr (is_heated)
    next = std::copy(heated.begin(), heated.end(), next);
  for (const elastoplastic::EffectColumn& of_effect : effects)
    if (may_act(of_effect))
      *next++ = Column<StepRecord>(of_effect.column);
  std::copy(ending.begin(), ending.end(), next);
  return all;
}

} // namespace common

} // namespace brinell::simulation
