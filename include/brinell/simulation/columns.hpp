// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/simulation/indentation.hpp"
#include "brinell/simulation/rolling.hpp"
#include "brinell/simulation/tugging.hpp"

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <string_view>
#include <variant>

/// The numbers of each record, listed once: checkpoints, history.csv, result.vtkhdf, summary.json and the Python package have
/// them from here.
namespace brinell::simulation
{

/// One number of a record, and how files name it.
template <typename Record>
struct Column
{
  using Member = std::variant<int Record::*, double Record::*>;

  std::string_view name; ///< that of the member
  std::string_view unit; ///< "1" for a pure number
  Member member;
  std::string_view text{}; ///< what it is, in files that say so

  [[nodiscard]] constexpr std::variant<int, double> value(const Record& record) const
  {
    return std::visit([&](auto m) { return std::variant<int, double>(record.*m); }, member);
  }
  /// What derives from a record has its numbers too.
  template <std::derived_from<Record> Derived>
  constexpr operator Column<Derived>() const // NOLINT(google-explicit-constructor)
  {
    return {name, unit, std::visit([](auto m) { return typename Column<Derived>::Member(m); }, member), text};
  }
};

/// All columns of a record, in the order of the files. A record without a table has nothing to loop over.
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
/// Of the scenarios whose surfaces may slide.
inline constexpr Column<SlidingRecord> F_friction{"F_friction", "N", &SlidingRecord::F_friction,
                                                  "friction between the surfaces, along the plane of contact"};
inline constexpr Column<SlidingRecord> share_at_shear_limit{
    "share_at_shear_limit", "1", &SlidingRecord::share_at_shear_limit,
    "share of the contact whose shear is at the limit of the surface"};

/// They end each row.
inline constexpr std::array<Row, 10> ending{{
    {"work", "J", &StepRecord::work, "work of the drive since the start"},
    {"dissipation_lower", "J", &StepRecord::dissipation_lower, "plastic work in the lower body since the start"},
    {"dissipation_upper", "J", &StepRecord::dissipation_upper, "plastic work in the upper body since the start"},
    {"dissipation_friction", "J", &StepRecord::dissipation_friction, "heat of friction since the start"},
    {"energy_residual", "J", &StepRecord::energy_residual, "elastic energy locked in by the plastic strain"},
    {"energy_elastic", "J", &StepRecord::energy_elastic, "elastic energy of the contact, of pressure and shear"},
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

template <>
inline constexpr auto columns<TuggingRecord> = common::row<TuggingRecord>({
    common::step,
    common::pass,
    {"X", "m", &TuggingRecord::X, "sliding coordinate, 0 at alignment"},
    {"theta", "rad", &TuggingRecord::theta, "angle of the line of centres with the vertical"},
    {"interference", "m", &TuggingRecord::interference,
     "interference of the undeformed bodies along the line of centres"},
    {"height", "m", &TuggingRecord::height, "height of the upper centre above the lower one"},
    common::contact_area,
    common::max_pressure,
    common::F_n,
    {"F_X", "N", &TuggingRecord::F_X, "resistance to the motion"},
    {"F_Y", "N", &TuggingRecord::F_Y, "lateral force"},
    {"F_Z", "N", &TuggingRecord::F_Z, "force that separates the bodies"},
    {"F_X_macro", "N", &TuggingRecord::F_X_macro, "F_X without the slope of the residual surfaces"},
    {"F_Z_macro", "N", &TuggingRecord::F_Z_macro, "F_Z without the slope of the residual surfaces"},
    common::F_friction,
    common::share_at_shear_limit,
});

template <>
inline constexpr auto columns<IndentationRecord> = common::row<IndentationRecord>({
    common::step,
    common::pass,
    {"place", "1", &IndentationRecord::place, "which of the places of the indentation, counts from 1"},
    {"x", "m", &IndentationRecord::x, "where the contact is on the lower body"},
    {"approach", "m", &IndentationRecord::approach, "approach of the bodies from first touch of the undeformed ones"},
    common::F_n,
    common::contact_area,
    {"contact_cells", "1", &IndentationRecord::contact_cells, "cells under pressure"},
    {"contact_radius", "m", &IndentationRecord::contact_radius, "radius of the circle of the same area as the contact"},
    common::max_pressure,
    {"mean_pressure", "Pa", &IndentationRecord::mean_pressure, "load over contact area"},
    {"nominal_pressure", "Pa", &IndentationRecord::nominal_pressure, "load over the area of the period"},
    {"contact_fraction", "1", &IndentationRecord::contact_fraction, "contact area over the area of the period"},
    {"mean_gap", "m", &IndentationRecord::mean_gap, "mean distance of the deformed surfaces over the period"},
    {"contact_stiffness", "Pa/m", &IndentationRecord::contact_stiffness,
     "elastic stiffness: nominal pressure over mean gap, both as they begin to change"},
    {"residual_depth", "m", &IndentationRecord::residual_depth,
     "largest residual displacement of the lower body at this place"},
    {"pile_up", "m", &IndentationRecord::pile_up,
     "largest height of the residual surface of the lower body at this place"},
});

template <>
inline constexpr auto columns<RollingRecord> = common::row<RollingRecord>({
    common::step,
    common::pass,
    {"x", "m", &RollingRecord::x, "where the contact is on the lower body"},
    {"approach", "m", &RollingRecord::approach, "approach of the bodies from first touch of the undeformed ones"},
    common::F_n,
    {"F_X", "N", &RollingRecord::F_X, "resistance to the motion"},
    {"friction", "1", &RollingRecord::friction, "F_X over F_n, 0 without contact"},
    common::F_friction,
    common::share_at_shear_limit,
    common::contact_area,
    common::max_pressure,
});

/// In summary.json its unit ends each name.
template <>
inline constexpr std::array<Column<Indent>, 16> columns<Indent>{{
    {"place", "1", &Indent::place},
    {"cycle", "1", &Indent::cycle},
    {"x", "m", &Indent::x},
    {"max_load", "N", &Indent::max_load},
    {"max_approach", "m", &Indent::max_approach},
    {"contact_area", "m^2", &Indent::contact_area},
    {"contact_fraction", "1", &Indent::contact_fraction},
    {"mean_gap", "m", &Indent::mean_gap},
    {"contact_stiffness", "Pa/m", &Indent::contact_stiffness},
    {"hardness", "Pa", &Indent::hardness},
    {"loading_stiffness", "N/m", &Indent::loading_stiffness},
    {"unloading_stiffness", "N/m", &Indent::unloading_stiffness},
    {"final_approach", "m", &Indent::final_approach},
    {"residual_depth", "m", &Indent::residual_depth},
    {"pile_up", "m", &Indent::pile_up},
    {"work", "J", &Indent::work},
}};

template <>
inline constexpr std::array<Column<RollingPass>, 13> columns<RollingPass>{{
    {"pass", "1", &RollingPass::pass},
    {"rut_depth", "m", &RollingPass::rut_depth},
    {"shoulder_height", "m", &RollingPass::shoulder_height},
    {"max_equivalent_plastic_strain", "1", &RollingPass::max_equivalent_plastic_strain},
    {"track_plastic_strain", "1", &RollingPass::track_plastic_strain},
    {"track_plastic_increment", "1", &RollingPass::track_plastic_increment},
    {"dissipation", "J", &RollingPass::dissipation},
    {"resistance", "N", &RollingPass::resistance},
    {"unsteadiness", "1", &RollingPass::unsteadiness},
    {"mean_F_X", "N", &RollingPass::mean_F_X},
    {"friction", "1", &RollingPass::friction},
    {"contact_area", "m^2", &RollingPass::contact_area},
    {"max_pressure", "Pa", &RollingPass::max_pressure},
}};

} // namespace brinell::simulation
