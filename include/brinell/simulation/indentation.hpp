// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/contact/elastic_contact.hpp"
#include "brinell/simulation/columns.hpp"

/// Indentation: the upper body is pressed into the lower one and lifted off again, at one place or at several.
namespace brinell::simulation
{

struct IndentationPlan;
struct IndentationRecord;
struct IndentationSummary;

/// The upper body is the indenter.
struct IndentationCase : PairCase
{
  using Plan = IndentationPlan;
  using Record = IndentationRecord; ///< row of its history
  using Summary = IndentationSummary;

  /// Loads, approaches or mean gaps (all of one kind) that are applied one after the other, starting without contact. If the
  /// sequence is repeated, or there are several places, it must end without contact: with zero, or with a mean gap not below
  /// `touching_gap`.
  std::vector<contact::Drive> sequence;
  int steps = 20;                  ///< from one entry of the sequence to the next
  int cycles = 1;                  ///< how often the sequence is applied at each place
  std::vector<double> places{0.0}; ///< x of the indenter's apex on the lower body [m]
};

struct IndentationPlan : Plan
{
  double contact_radius = 0.0;   ///< estimate at the largest load or approach, along x [m]
  double contact_radius_y = 0.0; ///< along y [m]
  /// Mean gap at which the undeformed surfaces first touch, at the first place [m]: for bodies that are periodic along both axes;
  /// NaN for others.
  double touching_gap = 0.0;
};

/// One row of the history.
struct IndentationRecord : StepRecord
{
  int place = 0;               ///< number of the place, counts from 1
  double x = 0.0;              ///< of the place on the lower body [m]
  double approach = 0.0;       ///< of the bodies from first touch of the undeformed smooth shapes [m]
  double contact_radius = 0.0; ///< radius of a circle with the contact area [m]
  int contact_cells = 0;       ///< cells under pressure
  double mean_pressure = 0.0;  ///< load over projected contact area [Pa]
  /// For bodies that are periodic along both axes; NaN for others.
  double nominal_pressure = 0.0, ///< load over the area of the period [Pa]
      contact_fraction = 0.0,    ///< contact area over the area of the period
      mean_gap = 0.0,            ///< of the deformed surfaces over the period [m], not negative
      contact_stiffness = 0.0;   ///< elastic, - d nominal pressure / d mean gap [Pa/m]
  double residual_depth = 0.0;   ///< largest residual displacement of the lower body at this place [m]
  double pile_up = 0.0;          ///< largest height of its residual surface there [m]

  void exchange(Archive& archive);
};

/// One loading and unloading at one place, with values at the largest load and at the opening of the contact.
struct Indent
{
  int place = 0, cycle = 0;  ///< number of the place, and number of the cycle at this place; both count from 1
  double x = 0.0;            ///< [m]
  double max_load = 0.0;     ///< [N]
  double max_approach = 0.0; ///< at that load [m]
  double contact_area = 0.0; ///< projected, at that load [m^2]
  /// At that load, for bodies that are periodic along both axes; NaN for others.
  double contact_fraction = 0.0, ///< contact area over the area of the period
      mean_gap = 0.0,            ///< [m]
      contact_stiffness = 0.0;   ///< elastic [Pa/m]
  double hardness = 0.0;         ///< max_load / contact_area [Pa]
  /// dF/d approach just before and just after the (last) largest load [N/m]; NaN without another step under load on that side.
  double loading_stiffness = 0.0, unloading_stiffness = 0.0;
  double final_approach = 0.0; ///< approach at which the contact opens [m]; NaN if it does not open
  double residual_depth = 0.0; ///< largest residual displacement of the lower body at the end of the indent [m]
  double pile_up = 0.0;        ///< largest height of its residual surface at the end of the indent [m]
  double work = 0.0;           ///< net work of this indent [J]

  void exchange(Archive& archive);
};

struct IndentationSummary : RunTotals
{
  /// Root mean squares over the period of the combined roughness of both textures, for bodies that are periodic along both axes;
  /// NaN for others.
  double rms_height = 0.0, ///< [m]
      rms_slope = 0.0;     ///< of the magnitude of the gradient
  std::vector<Indent> indents;
  IndentationRecord last;
};

/// Grids, number of steps and memory of a case.
/// @throws InputError
[[nodiscard]] IndentationPlan plan(const IndentationCase& indentation);

template <>
inline constexpr auto columns<IndentationRecord> = common::row<IndentationRecord>({
    common::step,
    common::pass,
    {"place", "1", &IndentationRecord::place, "number of the place of the indentation, counts from 1"},
    {"x", "m", &IndentationRecord::x, "position of the contact on the lower body"},
    {"approach", "m", &IndentationRecord::approach,
     "approach of the bodies, counted from first touch of the undeformed smooth shapes"},
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
     "elastic stiffness: -d(nominal pressure)/d(mean gap)"},
    {"residual_depth", "m", &IndentationRecord::residual_depth,
     "largest residual displacement of the lower body at this place"},
    {"pile_up", "m", &IndentationRecord::pile_up,
     "largest height of the residual surface of the lower body at this place"},
});

/// In summary.json each name has its unit as suffix.
template <>
inline constexpr std::array<Column<Indent>, 16> columns<Indent>{{
    {"place", "1", &Indent::place, "number of the place in the case, from 1"},
    {"cycle", "1", &Indent::cycle, "number of the loading cycle at this place, from 1"},
    {"x", "m", &Indent::x, "coordinate of the indenter's apex on the lower body"},
    {"max_load", "N", &Indent::max_load, "largest load"},
    {"max_approach", "m", &Indent::max_approach,
     "approach at the largest load, from first touch of the undeformed smooth shapes"},
    {"contact_area", "m^2", &Indent::contact_area, "projected contact area at the largest load"},
    {"contact_fraction", "1", &Indent::contact_fraction,
     "contact area over the area of the period at the largest load; NaN unless both axes are periodic"},
    {"mean_gap", "m", &Indent::mean_gap,
     "mean gap over the period at the largest load; NaN unless both axes are periodic"},
    {"contact_stiffness", "Pa/m", &Indent::contact_stiffness,
     "elastic stiffness at the largest load, change of nominal pressure over change of mean gap; NaN unless both axes "
     "are periodic"},
    {"hardness", "Pa", &Indent::hardness, "largest load over the projected contact area"},
    {"loading_stiffness", "N/m", &Indent::loading_stiffness,
     "slope of load over approach during loading, at the largest load; NaN if no step before it has a load"},
    {"unloading_stiffness", "N/m", &Indent::unloading_stiffness,
     "slope of load over approach at the beginning of unloading; NaN if no step after it has a load"},
    {"final_approach", "m", &Indent::final_approach, "approach at which the contact opens; NaN if it does not open"},
    {"residual_depth", "m", &Indent::residual_depth,
     "largest residual displacement of the lower body after unloading, positive into the body"},
    {"pile_up", "m", &Indent::pile_up,
     "largest height of the lower body's residual surface after unloading, positive outwards"},
    {"work", "J", &Indent::work, "net work of the drive in this indent"},
}};

} // namespace brinell::simulation
