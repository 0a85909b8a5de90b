// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/contact/elastic_contact.hpp"
#include "brinell/contact/tangential_contact.hpp"
#include "brinell/simulation/columns.hpp"

/// Fretting: the upper body is pressed on the lower one and oscillates along it with so small an amplitude that the surfaces
/// stick in places.
namespace brinell::simulation
{

struct FrettingPlan;
struct FrettingRecord;
struct FrettingSummary;

struct FrettingCase : PairCase
{
  using Plan = FrettingPlan;
  using Record = FrettingRecord; ///< row of its history
  using Summary = FrettingSummary;
  /// Quantity that oscillates: the relative displacement of distant points of both bodies, or the tangential force between them.
  using Kind = contact::TangentialDrive::Kind;

  contact::Drive press;    ///< load or approach, applied first and then kept
  int press_steps = 10;    ///< steps in which it is applied
  Kind kind = Kind::shift; ///< of the amplitude
  double amplitude = 0.0;  ///< [m] or [N], >= 0; each cycle goes from 0 to it, to its opposite and back to 0
  int cycles = 1;
  int steps_per_cycle = 40; ///< a multiple of 4
  double direction = 0.0;   ///< of the motion, from x towards y [rad]
  /// Cycles per time [1/s], > 0; needed where friction heats. Each step of pressing takes as long as one of a cycle.
  std::optional<double> frequency;
};

struct FrettingPlan : Plan
{
  double contact_radius = 0.0;   ///< estimate, along x [m]
  double contact_radius_y = 0.0; ///< along y [m]
  /// Estimate of the displacement beyond which smooth elastic bodies with a round contact slide everywhere [m]; 0 without
  /// friction.
  double sliding_displacement = 0.0;
};

/// One row of the history.
struct FrettingRecord : HeatedRecord
{
  int cycle = 0;               ///< counts from 1; 0 while the bodies are pressed together
  double approach = 0.0;       ///< [m]
  double displacement = 0.0;   ///< of the upper body relative to the lower one, along the direction [m]
  double force = 0.0;          ///< on the lower body, along the direction [N]
  double F_x = 0.0, F_y = 0.0; ///< force on the lower body along x and y [N]
  double stick_share = 0.0;    ///< share of the contact where nothing slipped in this step
  double stick_area = 0.0;     ///< area of the contact where nothing slipped in this step [m^2]
  double slip_path = 0.0;      ///< largest accumulated slip length of a point since the start [m]

  void exchange(Archive& archive);
};

/// One cycle, from the middle through both reversals back to the middle.
struct FrettingCycle
{
  int cycle = 0;                              ///< counts from 1
  double work = 0.0;                          ///< work of the tangential force: area of the fretting loop [J]
  double dissipation_friction = 0.0;          ///< heat of friction [J]
  double dissipation_plastic = 0.0;           ///< of both bodies [J]
  double max_force = 0.0;                     ///< largest magnitude [N]
  double max_displacement = 0.0;              ///< largest magnitude [m]
  double slip_amplitude = 0.0;                ///< a quarter of the slip of the point that slips most [m]
  double stick_share = 0.0;                   ///< smallest in the cycle
  double max_equivalent_plastic_strain = 0.0; ///< of both bodies, at its end

  void exchange(Archive& archive);
};

struct FrettingSummary : RunTotals
{
  std::vector<FrettingCycle> cycles; ///< complete cycles
  FrettingRecord last;
};

/// Grids, number of steps and memory of a case.
/// @throws InputError
[[nodiscard]] FrettingPlan plan(const FrettingCase& fretting);

template <>
inline constexpr auto columns<FrettingRecord> = common::row<FrettingRecord>({
    common::step,
    common::pass,
    {"cycle", "1", &FrettingRecord::cycle, "cycle, counts from 1; 0 while the bodies are pressed together"},
    {"approach", "m", &FrettingRecord::approach,
     "approach of the bodies, counted from first touch of the undeformed smooth shapes"},
    common::F_n,
    {"displacement", "m", &FrettingRecord::displacement,
     "displacement of distant points of the upper body relative to those of the lower one, along the motion"},
    {"force", "N", &FrettingRecord::force, "force on the lower body along the motion"},
    {"F_x", "N", &FrettingRecord::F_x, "force on the lower body along x"},
    {"F_y", "N", &FrettingRecord::F_y, "force on the lower body along y"},
    common::F_friction,
    common::share_at_shear_limit,
    {"stick_share", "1", &FrettingRecord::stick_share, "share of the contact where nothing slipped in this step"},
    {"stick_area", "m^2", &FrettingRecord::stick_area, "area of the contact where nothing slipped in this step"},
    {"slip_path", "m", &FrettingRecord::slip_path, "largest slip length of a point since the start"},
    common::contact_area,
    common::max_pressure,
});

/// In summary.json each name has its unit as suffix.
template <>
inline constexpr std::array<Column<FrettingCycle>, 9> columns<FrettingCycle>{{
    {"cycle", "1", &FrettingCycle::cycle, "number of the cycle, from 1"},
    {"work", "J", &FrettingCycle::work, "work of the tangential force, the area of the hysteresis loop"},
    {"dissipation_friction", "J", &FrettingCycle::dissipation_friction, "energy dissipated by friction in this cycle"},
    {"dissipation_plastic", "J", &FrettingCycle::dissipation_plastic, "plastic work in both bodies in this cycle"},
    {"max_force", "N", &FrettingCycle::max_force, "largest magnitude of the tangential force"},
    {"max_displacement", "m", &FrettingCycle::max_displacement, "largest magnitude of the displacement"},
    {"slip_amplitude", "m", &FrettingCycle::slip_amplitude, "a quarter of the largest local slip path of this cycle"},
    {"stick_share", "1", &FrettingCycle::stick_share, "smallest fraction of the contact area that sticks"},
    {"max_equivalent_plastic_strain", "1", &FrettingCycle::max_equivalent_plastic_strain,
     "largest equivalent plastic strain of both bodies at the end of the cycle"},
}};

} // namespace brinell::simulation
