// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/contact/elastic_contact.hpp"
#include "brinell/simulation/columns.hpp"

/// Sliding: the upper body, pressed on the lower one, slides over it along x, in one stroke, in several, or to and fro. Both
/// surfaces keep their plastic deformation.
namespace brinell::simulation
{

struct SlidingPlan;
struct SlidingRecord;
struct SlidingSummary;

/// The lower body must be flat along x, because the contact stays at the same place on the upper body.
struct SlidingCase : PairCase
{
  using Plan = SlidingPlan;
  using Record = SlidingRecord; ///< row of its history
  using Summary = SlidingSummary;

  /// Load, approach or mean gap: applied first, kept while sliding, removed at the end. Under an approach or a mean gap the
  /// surfaces may be apart at first, if their peaks meet on the way; an approach may then be negative.
  contact::Drive press;
  int press_steps = 10;        ///< steps in which it is applied, and in which it is removed
  double distance = 0.0;       ///< sliding distance of the upper body in each stroke [m], > 0
  std::optional<double> shift; ///< sliding distance in a step [m]; default: one cell dx
  int strokes = 1;
  bool to_and_fro =
      false; ///< whether every second stroke goes back; otherwise each continues where the previous one ended
  /// Speed of the upper body over the lower one [m/s], > 0; needed where friction heats. Each step of pressing and of lifting off
  /// takes as long as one of sliding.
  std::optional<double> speed;
};

struct SlidingPlan : Plan
{
  double half_width_x = 0.0, half_width_y = 0.0; ///< of the contact, estimate [m]
  double shift = 0.0;                            ///< sliding distance of a step [m]
  int sliding_steps = 0;                         ///< number of steps that slide, in each stroke
  /// Length of a stroke [m]: `SlidingCase::distance`, unless given cells or a period make it another one.
  [[nodiscard]] double way() const { return sliding_steps * shift; }
  /// Mean gap at which the undeformed surfaces first touch, before they slide [m]: for bodies that are periodic along both axes;
  /// NaN for others.
  double touching_gap = 0.0;
};

/// One row of the history.
struct SlidingRecord : HeatedRecord
{
  double slid = 0.0;        ///< displacement of the upper body over the lower one along x [m]
  double way = 0.0;         ///< accumulated sliding distance since the start [m]
  double approach = 0.0;    ///< [m]
  double F_X = 0.0;         ///< force along x that resists the motion, ploughing plus friction [N]
  double F_ploughing = 0.0; ///< part of F_X due to the pressure on the slopes of both surfaces [N]
  double friction = 0.0;    ///< F_X / F_n; 0 without contact
  /// For bodies that are periodic along both axes; NaN for others.
  double nominal_pressure = 0.0, ///< load over the area of the period [Pa]
      contact_fraction = 0.0,    ///< contact area over the area of the period
      mean_gap = 0.0;            ///< of the deformed surfaces over the period [m], not negative
  int patches = 0;               ///< number of contact patches: cells under pressure that are connected by their sides
  double largest_patch = 0.0;    ///< area of the largest patch [m^2]

  void exchange(Archive& archive);
};

/// Results of one stroke: means over the stroke, and the state at its end.
struct SlidingStroke
{
  int stroke = 0;                             ///< counts from 1
  double friction = 0.0;                      ///< mean F_X over mean F_n
  double friction_ploughing = 0.0;            ///< part of it due to the slopes of the surfaces
  double friction_interfacial = 0.0;          ///< part of it due to the shear between the surfaces
  double mean_F_X = 0.0;                      ///< [N]
  double contact_area = 0.0;                  ///< mean [m^2]
  double patches = 0.0;                       ///< mean number of patches of the contact
  double largest_patch = 0.0;                 ///< mean area of the largest one [m^2]
  double contact_fraction = 0.0;              ///< mean; NaN unless both axes are periodic
  double mean_gap = 0.0;                      ///< mean [m]; NaN unless both axes are periodic
  double max_pressure = 0.0;                  ///< mean of the largest pressure [Pa]
  double dissipation_plastic = 0.0;           ///< of both bodies in this stroke, without pressing and parting [J]
  double dissipation_friction = 0.0;          ///< heat of friction in this stroke [J]
  double max_equivalent_plastic_strain = 0.0; ///< of both bodies, at its end
  double rms_height_lower = 0.0,
         rms_height_upper = 0.0; ///< Sq of the surfaces at the end of the stroke, over their grids [m]
  double mean_height_lower = 0.0, mean_height_upper = 0.0; ///< mean absolute height at the end: Sa [m]
  double core_height_lower = 0.0, core_height_upper = 0.0; ///< core height of the bearing-area curve at the end: Sk [m]
  double peak_height_lower = 0.0, peak_height_upper = 0.0; ///< reduced height of the peaks above the core: Spk [m]
  double valley_depth_lower = 0.0,
         valley_depth_upper = 0.0; ///< reduced depth of the valleys below the core: Svk [m]

  void exchange(Archive& archive);
};

struct SlidingSummary : RunTotals
{
  /// Root mean squares over the period of the combined roughness of both textures before sliding, for bodies that are periodic
  /// along both axes; NaN for others.
  double rms_height = 0.0, ///< [m]
      rms_slope = 0.0;     ///< of the magnitude of the gradient
  std::vector<SlidingStroke> strokes;
  SlidingRecord last;
};

/// Grids, number of steps and memory of a case.
/// @throws InputError
[[nodiscard]] SlidingPlan plan(const SlidingCase& sliding);

template <>
inline constexpr auto columns<SlidingRecord> = common::row<SlidingRecord>({
    common::step,
    common::pass,
    {"slid", "m", &SlidingRecord::slid, "displacement of the upper body over the lower one along x"},
    {"way", "m", &SlidingRecord::way, "accumulated sliding distance since the start"},
    {"approach", "m", &SlidingRecord::approach,
     "approach of the bodies, counted from first touch of the undeformed smooth shapes"},
    common::F_n,
    {"F_X", "N", &SlidingRecord::F_X, "force along x that resists the motion"},
    {"F_ploughing", "N", &SlidingRecord::F_ploughing, "part of F_X due to the pressure on the slopes of both surfaces"},
    common::F_friction,
    {"friction", "1", &SlidingRecord::friction, "F_X over F_n, 0 without contact"},
    common::share_at_shear_limit,
    common::contact_area,
    {"contact_fraction", "1", &SlidingRecord::contact_fraction, "contact area over the area of the period"},
    {"patches", "1", &SlidingRecord::patches,
     "number of contact patches; patches that cross the boundary of a period count once"},
    {"largest_patch", "m^2", &SlidingRecord::largest_patch, "area of the largest patch"},
    {"nominal_pressure", "Pa", &SlidingRecord::nominal_pressure, "load over the area of the period"},
    {"mean_gap", "m", &SlidingRecord::mean_gap, "mean distance of the deformed surfaces over the period"},
    common::max_pressure,
});

/// In summary.json each name has its unit as suffix.
template <>
inline constexpr std::array<Column<SlidingStroke>, 24> columns<SlidingStroke>{{
    {"stroke", "1", &SlidingStroke::stroke, "number of the stroke, from 1"},
    {"friction", "1", &SlidingStroke::friction, "mean F_X over mean F_n"},
    {"friction_ploughing", "1", &SlidingStroke::friction_ploughing,
     "part of the friction from pressure on the slopes of both surfaces (ploughing)"},
    {"friction_interfacial", "1", &SlidingStroke::friction_interfacial,
     "part of the friction from the shear between the surfaces"},
    {"mean_F_X", "N", &SlidingStroke::mean_F_X, "mean F_X"},
    {"contact_area", "m^2", &SlidingStroke::contact_area, "mean contact area"},
    {"contact_fraction", "1", &SlidingStroke::contact_fraction,
     "mean contact area over the area of the period; NaN unless both axes are periodic"},
    {"patches", "1", &SlidingStroke::patches, "mean number of contact patches"},
    {"largest_patch", "m^2", &SlidingStroke::largest_patch, "mean area of the largest patch"},
    {"mean_gap", "m", &SlidingStroke::mean_gap,
     "gap averaged over the period and the stroke; NaN unless both axes are periodic"},
    {"max_pressure", "Pa", &SlidingStroke::max_pressure, "mean over the stroke of the largest pressure"},
    {"dissipation_plastic", "J", &SlidingStroke::dissipation_plastic,
     "plastic work in both bodies in this stroke, without pressing and parting"},
    {"dissipation_friction", "J", &SlidingStroke::dissipation_friction,
     "energy dissipated by friction in this stroke, without pressing and parting"},
    {"max_equivalent_plastic_strain", "1", &SlidingStroke::max_equivalent_plastic_strain,
     "largest equivalent plastic strain of both bodies at the end of the stroke"},
    {"rms_height_lower", "m", &SlidingStroke::rms_height_lower,
     "Sq of the lower surface (texture and residual displacement, over its grid) at the end of the stroke"},
    {"rms_height_upper", "m", &SlidingStroke::rms_height_upper, "Sq of the upper surface at the end of the stroke"},
    {"mean_height_lower", "m", &SlidingStroke::mean_height_lower, "Sa of the lower surface at the end of the stroke"},
    {"mean_height_upper", "m", &SlidingStroke::mean_height_upper, "Sa of the upper surface at the end of the stroke"},
    {"core_height_lower", "m", &SlidingStroke::core_height_lower,
     "Sk of the lower surface, the core height of the bearing-area curve, at the end of the stroke"},
    {"core_height_upper", "m", &SlidingStroke::core_height_upper, "Sk of the upper surface at the end of the stroke"},
    {"peak_height_lower", "m", &SlidingStroke::peak_height_lower,
     "Spk of the lower surface, the reduced peak height, at the end of the stroke"},
    {"peak_height_upper", "m", &SlidingStroke::peak_height_upper, "Spk of the upper surface at the end of the stroke"},
    {"valley_depth_lower", "m", &SlidingStroke::valley_depth_lower,
     "Svk of the lower surface, the reduced valley depth, at the end of the stroke"},
    {"valley_depth_upper", "m", &SlidingStroke::valley_depth_upper,
     "Svk of the upper surface at the end of the stroke"},
}};

} // namespace brinell::simulation
