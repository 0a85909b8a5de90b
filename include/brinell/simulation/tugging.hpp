// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/simulation/columns.hpp"
#include "brinell/simulation/kinematics.hpp"

#include <optional>

/// Tugging of two asperities: the upper one moves along X past the lower one, at a constant height at which they interfere
/// (Boucly, Nelias, Green 2006), or under a constant normal force.
namespace brinell::simulation
{

struct TuggingPlan;
struct TuggingRecord;
struct TuggingSummary;

/// Both bodies must be circular in the plane of motion: a paraboloid, or a roller across the motion.
struct TuggingCase : PairCase
{
  using Plan = TuggingPlan;
  using Record = TuggingRecord; ///< row of its history
  using Summary = TuggingSummary;

  /// Default resolution with errors of forces within 1 %, and of energies within 2 %, up to nine times the interference of first
  /// yield: docs/verification/accuracy.md.
  TuggingCase() { resolution = 14.0; }

  /// Overlap in height of the tops of the rigid bodies [m], > 0. Without an offset it is the largest interference, reached at
  /// alignment.
  double interference = 0.0;
  /// Offset along y of the upper centre from the lower one [m], with which the bodies pass beside each other and overlap less
  /// along the line of their centres, see closest_approach. Not allowed with a load.
  double offset = 0.0;
  /// Constant force normal to the plane of contact [N], instead of the constant height; it is applied in the first eighth of
  /// the way on which the rigid bodies would touch, and removed in the last one. The interference is then an estimate of the
  /// approach, from which the length of the pass and the grids follow.
  std::optional<double> load;
  std::optional<double>
      shift; ///< arc that the contact moves on each body per step (mean of both) [m]; default: one cell dx
  Kinematics kinematics = Kinematics::exact;
  int passes = 1;
  /// Sum of the speeds of the contact over both bodies [m/s], > 0. It equals the speed of the upper surface over the lower one if
  /// the interference is neglected against the radii. The way back from pass to pass takes as long as a pass. Needed where
  /// friction heats.
  std::optional<double> speed;
};

/// Geometry at alignment, in the plane across the motion.
struct ClosestApproach
{
  double interference = 0.0; ///< along the line of centres, the largest of the pass [m]; <= 0: the bodies never touch
  double tilt = 0.0;         ///< angle of the line of centres to Z, with the sign of the offset [rad]
  double y_lower = 0.0, y_upper = 0.0; ///< arc from the top of each body to the middle of the contact [m]
};

/// With the radii R1, R2 across the motion and the heights of the tops overlapping by alpha, an offset y tilts the line of
/// centres by atan(y/(R1 + R2 - alpha)) and leaves an interference of R1 + R2 - hypot(R1 + R2 - alpha, y), which is
/// alpha - y^2/(2 (R1 + R2)) to second order: docs/theory/simulation.md (offset).
/// @throws PlanError if there is an offset and a body is not rounded across the motion
[[nodiscard]] ClosestApproach closest_approach(const TuggingCase& tugging);

struct TuggingPlan : Plan
{
  ClosestApproach closest;
  int steps_per_pass = 0;
  /// Half-lengths of the elastic contact of the smooth bodies at alignment, along x and y [m].
  double elastic_contact_radius = 0.0, elastic_contact_radius_y = 0.0;
  double shift = 0.0;          ///< mean arc per step [m]
  double start_distance = 0.0; ///< d0, Eq. 2 [m]
  double texture_height = 0.0; ///< sum for both bodies; distance by which they may touch before smooth bodies would [m]
};

/// One row of the history. The work is the integral of F_X dX - F_Z d height, without the way back from pass to pass.
struct TuggingRecord : HeatedRecord
{
  double X = 0.0, theta = 0.0, interference = 0.0;
  double height = 0.0; ///< of the upper centre above the lower one [m]
  double F_X = 0.0, F_Y = 0.0,
         F_Z = 0.0; ///< by the mean contact plane, pile-up included; F_X > 0 resists the motion [N]
  double F_X_macro = 0.0, F_Z_macro = 0.0;       ///< Eqs. 15, 17: without the slope of the residual surfaces [N]
  double F_X_lower = 0.0, F_X_upper = 0.0;       ///< Eq. 18 with the residual surface of one body alone [N]
  double F_X_friction = 0.0, F_Z_friction = 0.0; ///< the shares of the shear in F_X and F_Z [N]

  void exchange(Archive& archive);
};

/// Key numbers of the history. Values at alignment are those of the first pass.
struct TuggingPeaks
{
  double peak_F_X = 0.0, X_at_peak_F_X = 0.0;  ///< largest resistance [N] and its position [m]
  double min_F_X = 0.0;                        ///< largest forward push (negative) [N]
  double peak_F_Y = 0.0;                       ///< value of largest magnitude, signed [N]
  double peak_F_Z = 0.0;                       ///< [N]
  double F_X_aligned = 0.0, F_Z_aligned = 0.0; ///< at X = 0 [N]
  double load_ratio_aligned = 0.0;             ///< F_X / F_Z at X = 0
  double load_ratio_end = 0.0;                 ///< F_X / F_Z at the end of the contact
  double work_to_alignment = 0.0;              ///< up to X = 0 [J]

  void exchange(Archive& archive);
};

struct TuggingSummary : RunTotals, TuggingPeaks
{
  TuggingRecord last;
};

/// Radius of a body in the plane of motion, from its curvature along x [m]. None if the body has no radius > 0, such as a flat or
/// a tip, which cannot pass another body.
[[nodiscard]] std::optional<double> passing_radius(const Shape& shape);

/// Approach of the smooth bodies under a load if they stayed elastic [m]; to be used as the interference of tugging under that
/// load.
[[nodiscard]] double elastic_approach(const ShapedBody& lower, const ShapedBody& upper, double load,
                                      const Domain& domain = {});

/// Grids, number of steps and memory of a case.
/// @throws InputError if the case cannot be computed (for example a grid of absurd size).
[[nodiscard]] TuggingPlan plan(const TuggingCase& tugging);

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
    {"F_Y", "N", &TuggingRecord::F_Y, "lateral force on the upper body, along y"},
    {"F_Z", "N", &TuggingRecord::F_Z, "force that separates the bodies"},
    {"F_X_macro", "N", &TuggingRecord::F_X_macro, "F_X without the slope of the residual surfaces"},
    {"F_Z_macro", "N", &TuggingRecord::F_Z_macro, "F_Z without the slope of the residual surfaces"},
    common::F_friction,
    common::share_at_shear_limit,
});

} // namespace brinell::simulation
