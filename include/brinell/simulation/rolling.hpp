// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/contact/elastic_contact.hpp"
#include "brinell/simulation/columns.hpp"

/// The upper body, pressed on the lower one, rolls over it along x: pass after pass over the same track.
namespace brinell::simulation
{

struct RollingPlan;
struct RollingRecord;
struct RollingSummary;

/// Creepage of the upper surface over the lower one in rolling with partial slip: relative velocities over the mean speed at
/// which the surfaces pass the contact (Kalker 1967).
struct Creepage
{
  double longitudinal = 0.0; ///< towards +x
  double lateral = 0.0;      ///< towards +y
  double spin = 0.0;         ///< rotation about the contact's normal, from x to y, per distance rolled [rad/m]
  bool operator==(const Creepage&) const = default;
};

/// Limit for longitudinal and lateral creepage, and for spin times the half-length of the contact. It is small because both
/// surfaces are taken to move by the same number of cells.
inline constexpr double largest_creepage = 0.1;

struct RollingCase : PairCase
{
  using Plan = RollingPlan;
  using Record = RollingRecord; ///< row of its history
  using Summary = RollingSummary;

  contact::Drive drive;        ///< load or approach, kept while rolling
  double distance = 0.0;       ///< from -distance/2 to distance/2 on the lower body in each pass [m], > 0
  std::optional<double> shift; ///< distance that the contact moves on the lower body per step [m]; default: one cell dx
  /// Slide-to-roll ratio (u_lower - u_upper) / mean of both speeds of the surfaces past the contact, in (-2, 2]. 0: pure rolling;
  /// 2: the upper body slides without rotation. With friction, a ratio other than 0 means that the surfaces slide everywhere.
  double slide_to_roll = 0.0;
  /// If given, the surfaces stick and slip, which needs friction and slide_to_roll = 0. None: they slide everywhere, or nowhere.
  std::optional<Creepage> creepage;
  int passes = 1;
  int load_steps = 6; ///< steps in which the drive is applied before a pass, and removed after it
  /// Speed of the contact over the lower body [m/s], > 0; needed where friction heats. Each step of pressing on and lifting off
  /// takes as long as one of rolling; with creepage all of them together take at least as long as the contact rolls over its own
  /// length. The way back takes as long as a pass.
  std::optional<double> speed;
};

/// Distance that the contact moves on the upper body per distance on the lower one.
[[nodiscard]] double upper_share(const RollingCase& rolling);

struct RollingPlan : Plan
{
  double half_width_x = 0.0, half_width_y = 0.0; ///< of the contact, estimate [m]
  double shift = 0.0;                            ///< on the lower body per step [m]
  int rolling_steps = 0;                         ///< number of steps that roll, in each pass
  /// Length of the track that is rolled [m]: `RollingCase::distance`, unless given cells make it another one.
  [[nodiscard]] double way() const { return rolling_steps * shift; }
};

/// One row of the history.
struct RollingRecord : HeatedRecord
{
  double x = 0.0;              ///< of the contact's centre on the lower body [m]
  double approach = 0.0;       ///< [m]
  double F_X = 0.0;            ///< resistance to rolling: work of the drive per distance on the lower body [N]
  double friction = 0.0;       ///< F_X / F_n; 0 without contact
  double F_x = 0.0, F_y = 0.0; ///< sums of the shear on the lower body [N]
  double M_z = 0.0;            ///< moment of the shear on the lower body about the contact's normal, from x to y [N m]
  double stick_share =
      0.0; ///< share of the contact where nothing slipped in this step; 0 for surfaces that slide everywhere
  double stick_area = 0.0; ///< area of the contact where nothing slipped in this step [m^2]
  double slip_path = 0.0;  ///< largest slip length of a point under the contact since it came there [m]

  void exchange(Archive& archive);
};

/// Results of one pass, at the middle of the track.
struct RollingPass
{
  int pass = 0;                               ///< counts from 1
  double rut_depth = 0.0;                     ///< residual displacement of the lower body at x = y = 0 [m]
  double shoulder_height = 0.0;               ///< largest height of its residual surface in the section x = 0 [m]
  double max_equivalent_plastic_strain = 0.0; ///< of both bodies
  double track_plastic_strain = 0.0;          ///< largest equivalent plastic strain of the lower body under x = y = 0
  double track_plastic_increment = 0.0;       ///< largest growth of that strain in this pass
  double dissipation = 0.0;                   ///< of both bodies in this pass [J]
  /// Energy that both bodies absorb, dissipated and locked in, per length over the middle half of the track [N].
  double resistance = 0.0;
  /// Difference of the resistance between the two quarters of the middle half, over the larger of them.
  double unsteadiness = 0.0;
  double mean_F_X = 0.0;       ///< mean over the middle half of the track, in which the approach may change [N]
  double friction = 0.0;       ///< mean F_X over mean F_n, both over the middle half
  double contact_area = 0.0;   ///< mean over the middle half [m^2]
  double max_pressure = 0.0;   ///< mean over the middle half of the largest pressure [Pa]
  double F_x = 0.0, F_y = 0.0; ///< means over the last quarter of the track [N]
  double M_z = 0.0;            ///< mean over the last quarter [N m]
  double stick_share = 0.0;    ///< mean over the last quarter
  /// Difference of the force (F_x, F_y) between both halves of the last quarter, over the larger of them.
  double creep_unsteadiness = 0.0;

  /// Whether the middle of the track was in steady state, so that its means do not depend on the length of the track.
  [[nodiscard]] bool is_steady() const { return unsteadiness <= 0.1; }
  /// Whether stick and slip have reached steady rolling.
  [[nodiscard]] bool creeps_steadily() const { return creep_unsteadiness <= 0.01; }

  void exchange(Archive& archive);
};

/// Depth profile under x = y = 0 of the lower body after the last pass, unloaded.
struct TrackProfile
{
  std::vector<double> depth;                    ///< of the layers' centres [m]
  std::vector<double> residual_xx, residual_yy; ///< residual stress [Pa]
  std::vector<double> equivalent_plastic_strain;
};

struct RollingSummary : RunTotals
{
  std::vector<RollingPass> passes;
  TrackProfile profile;
  RollingRecord last;
};

/// Grids, number of steps and memory of a case.
/// @throws InputError
[[nodiscard]] RollingPlan plan(const RollingCase& rolling);

template <>
inline constexpr auto columns<RollingRecord> = common::row<RollingRecord>({
    common::step,
    common::pass,
    {"x", "m", &RollingRecord::x, "position of the contact on the lower body"},
    {"approach", "m", &RollingRecord::approach,
     "approach of the bodies, counted from first touch of the undeformed smooth shapes"},
    common::F_n,
    {"F_X", "N", &RollingRecord::F_X, "resistance to the motion"},
    {"friction", "1", &RollingRecord::friction, "F_X over F_n, 0 without contact"},
    common::F_friction,
    {"F_x", "N", &RollingRecord::F_x, "force of the shear on the lower body along x"},
    {"F_y", "N", &RollingRecord::F_y, "force of the shear on the lower body along y"},
    {"M_z", "N m", &RollingRecord::M_z,
     "moment of the shear on the lower body about the contact's normal, from x to y"},
    common::share_at_shear_limit,
    {"stick_share", "1", &RollingRecord::stick_share,
     "share of the contact where nothing slipped in this step; 0 without creepage"},
    {"stick_area", "m^2", &RollingRecord::stick_area, "area of the contact where nothing slipped in this step"},
    {"slip_path", "m", &RollingRecord::slip_path,
     "largest slip length of a point under the contact since it came there; 0 without creepage"},
    common::contact_area,
    common::max_pressure,
});

template <>
inline constexpr std::array<Column<RollingPass>, 18> columns<RollingPass>{{
    {"pass", "1", &RollingPass::pass, "number of the pass, from 1"},
    {"rut_depth", "m", &RollingPass::rut_depth,
     "residual displacement of the lower body at x = y = 0, positive into the body"},
    {"shoulder_height", "m", &RollingPass::shoulder_height,
     "largest height of the lower body's residual surface in the section x = 0, positive outwards"},
    {"max_equivalent_plastic_strain", "1", &RollingPass::max_equivalent_plastic_strain,
     "largest equivalent plastic strain of both bodies"},
    {"track_plastic_strain", "1", &RollingPass::track_plastic_strain,
     "largest equivalent plastic strain of the lower body under x = y = 0"},
    {"track_plastic_increment", "1", &RollingPass::track_plastic_increment,
     "largest increment of the equivalent plastic strain under x = y = 0 in this pass"},
    {"dissipation", "J", &RollingPass::dissipation, "plastic work in both bodies in this pass"},
    {"resistance", "N", &RollingPass::resistance,
     "energy dissipated and locked in by both bodies per length, over the middle half of the track"},
    {"unsteadiness", "1", &RollingPass::unsteadiness,
     "difference of the resistance between the two quarters of the middle half, over the larger of them; up to 0.1 the "
     "resistance counts as steady"},
    {"mean_F_X", "N", &RollingPass::mean_F_X,
     "mean F_X over the middle half of the track, positive if it resists the motion"},
    {"friction", "1", &RollingPass::friction, "mean F_X over mean F_n in the middle half of the track"},
    {"contact_area", "m^2", &RollingPass::contact_area, "contact area, averaged over the middle half of the track"},
    {"max_pressure", "Pa", &RollingPass::max_pressure, "largest pressure, averaged over the middle half of the track"},
    {"F_x", "N", &RollingPass::F_x,
     "force of the shear on the lower body along x, averaged over the last quarter of the track"},
    {"F_y", "N", &RollingPass::F_y,
     "force of the shear on the lower body along y, averaged over the last quarter of the track"},
    {"M_z", "N m", &RollingPass::M_z,
     "moment of the shear about the contact normal, positive from x to y, averaged over the last quarter"},
    {"stick_share", "1", &RollingPass::stick_share,
     "fraction of the contact area that sticks, averaged over the last quarter of the track; 0 without creepage"},
    {"creep_unsteadiness", "1", &RollingPass::creep_unsteadiness,
     "difference of the force between both halves of the last quarter, over the larger of them; up to 0.01 the force "
     "counts as steady"},
}};

} // namespace brinell::simulation
