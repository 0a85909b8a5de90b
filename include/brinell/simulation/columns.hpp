// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/simulation/scenario.hpp"

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <string_view>
#include <variant>

/// Tables of the numbers of each record. Each table stands once, in the header of its scenario; checkpoints, history.csv,
/// result.vtkhdf, summary.json and the Python package are generated from it.
namespace brinell::simulation
{

/// One number of a record, with its name and unit in files.
template <typename Record>
struct Column
{
  using Member = std::variant<int Record::*, double Record::*>;

  std::string_view name; ///< name of the member
  std::string_view unit; ///< "1" for a pure number
  Member member;
  std::string_view text{}; ///< description, for files that have descriptions

  [[nodiscard]] constexpr std::variant<int, double> value(const Record& record) const
  {
    return std::visit([&](auto m) { return std::variant<int, double>(record.*m); }, member);
  }
  /// A column of a record is also a column of every derived record.
  template <std::derived_from<Record> Derived>
  constexpr operator Column<Derived>() const // NOLINT(google-explicit-constructor)
  {
    return {name, unit, std::visit([](auto m) { return typename Column<Derived>::Member(m); }, member), text};
  }
};

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
inline constexpr std::array<Column<HeatedRecord>, 7> heated{{
    {"max_temperature_lower", "degC", &HeatedRecord::max_temperature_lower,
     "largest temperature of the lower surface in and around the contact; without heat the bulk temperature"},
    {"max_temperature_upper", "degC", &HeatedRecord::max_temperature_upper,
     "largest temperature of the upper surface in and around the contact; without heat the bulk temperature"},
    {"heat_lower", "J", &HeatedRecord::heat_lower,
     "heat that has entered the lower body by its surface since the start"},
    {"heat_upper", "J", &HeatedRecord::heat_upper,
     "heat that has entered the upper body by its surface since the start"},
    {"heat_of_source", "J", &HeatedRecord::heat_of_source, "heat of the source (thermal.source) since the start"},
    {"heat_of_plastic_work", "J", &HeatedRecord::heat_of_plastic_work,
     "heat of the plastic work of both bodies since the start"},
    {"work_of_expansion", "J", &HeatedRecord::work_of_expansion,
     "work of the bodies by thermal expansion since the start"},
}};

/// Columns of the scenarios in which the surfaces may wear.
inline constexpr std::array<Row, 6> worn{{
    {"worn_volume_lower", "m^3", &StepRecord::worn_volume_lower, "worn volume of the lower body"},
    {"worn_volume_upper", "m^3", &StepRecord::worn_volume_upper, "worn volume of the upper body"},
    {"max_worn_depth_lower", "m", &StepRecord::max_worn_depth_lower, "largest worn depth of the lower surface"},
    {"max_worn_depth_upper", "m", &StepRecord::max_worn_depth_upper, "largest worn depth of the upper surface"},
    {"max_wear_step", "m", &StepRecord::max_wear_step,
     "largest worn depth of both surfaces together in one increment so far"},
    {"work_of_wear", "J", &StepRecord::work_of_wear, "work of the pressure on the worn depth since the start"},
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

/// The columns of a row: those that begin it, and the ending.
template <typename Record, std::size_t N>
constexpr std::array<Column<Record>, N + ending.size()> row(const Column<Record> (&beginning)[N])
{
  std::array<Column<Record>, N + ending.size()> all{};
  std::copy(ending.begin(), ending.end(), std::copy(beginning, beginning + N, all.begin()));
  return all;
}

} // namespace common

} // namespace brinell::simulation
