// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/elastoplastic/increment.hpp"
#include "window_error.hpp"

/// The parts of a coupled contact, and functions of several of them that more than one file uses.
namespace brinell::elastoplastic
{

/// A body that is solved, with the load that the contact puts on it.
struct Side
{
  Body body;
  Place Placement::*place;
  std::vector<double> pressure{};             ///< of the trial, on the grid of the body [Pa]
  bool leaves_grid = false;                   ///< pressure of the trial lies beyond an end of the body's grid
  double shear_sign = 1.0;                    ///< sign of the interface's shear on this body
  std::array<std::vector<double>, 2> shear{}; ///< of the trial, along x and y [Pa]; empty if there never is any

  [[nodiscard]] halfspace::SurfaceLoad load() const
  {
    return {.pressure = pressure, .shear_x = shear[0], .shear_y = shear[1]};
  }
};

/// An increment to be solved, and how.
struct Task
{
  std::span<const double> distance;
  const contact::Drive& drive;
  const Placement& placement;
  const Motion& motion;
  const Strategy& strategy;
};

struct ContactParts : Between
{
  halfspace::SurfaceCompliance compliance;
  Textures textures;
  Scales scales;
  Settings settings;
  Twin twin;
  contact::ElasticContact contact{compliance};
  std::vector<Side> sides{}; ///< the lower body, and the upper one unless it is a twin
  WindowError window_error{};
  // Of the current increment
  std::vector<double> compliance_of_effects{}; ///< change of the gap per pressure by all effects [m/Pa]; empty: none
  double slid = 0.0;                           ///< Motion::slid, 0 if nothing slides [m]
  double step = 0.0;                           ///< Motion::step
  std::array<double, 2> driven_along{};        ///< Interface::direction
  std::vector<double> distance{}; ///< of the surfaces with texture and residual displacement, at zero approach [m]

  [[nodiscard]] const SurfaceGrid& grid() const { return compliance.grid(); }
  [[nodiscard]] BodyView view(std::size_t side) const
  {
    return side == 0 ? BodyView(sides.front().body, Twin::none, textures.lower)
                     : BodyView(sides.back().body, twin, textures.upper);
  }
  /// The body itself, or that of which it is the twin.
  [[nodiscard]] Body& solved(std::size_t side) { return side == 0 ? sides.front().body : sides.back().body; }
  /// Grids of the lower and the upper body.
  [[nodiscard]] std::array<VolumeGrid, 2> grids() const { return {view(0).grid(), view(1).grid()}; }
  [[nodiscard]] bool may_stick() const { return dynamic_cast<const PartialSlip*>(interface.get()) != nullptr; }
};

/// Iterates the fixed point of the trial deviators until it converges or is given up.
[[nodiscard]] IncrementReport iterate(ContactParts& contact, const Task& task);
/// Calls work(side) with the index of each body. If both bodies take about as long, two or three threads take one body each: that
/// is faster than to share each of them, because the threads hardly wait and find in their caches what they have written.
void on_sides(ContactParts& contact, const std::function<void(std::size_t)>& work);
/// Transfers pressure and shear to the grids of the bodies.
void spread(ContactParts& contact, const Placement& placement);
[[nodiscard]] Outgrown outgrown(const ContactParts& contact);
[[nodiscard]] bool bears_shear(const ContactParts& contact);
/// Tolerance of the contact solver: largest gap under pressure, and largest overlap elsewhere [m].
[[nodiscard]] double tolerance_of_gap(const ContactParts& contact);
/// Adds the depth of a surface under the contact grid, from texture, residual displacement and effects [m].
void add_depth_of(const ContactParts& contact, std::size_t side, const Place& place, std::span<double> out);

/// Energy of the present trial or, after the commit, of the increment [J].
/// @param approach  imposed; 0 where the load is imposed [m]
[[nodiscard]] double energy(const ContactParts& contact, double approach);
/// Approach whose work enters the energy; 0 where the load is imposed.
[[nodiscard]] double imposed_approach(const contact::Drive& drive, double found);

/// Solves for gap and pressure of the surfaces with the residual displacements of the present trial, and for what acts between
/// them.
/// @param closing  whether the increment may end with this evaluation
void solve_contact(ContactParts& contact, const Task& task, bool closing, IncrementReport& report);
/// After convergence with the law of friction held: updates bound, heat and other effects to the present pressure.
/// @returns whether they changed by more than the tolerances; the iteration then continues.
[[nodiscard]] bool renews_law(ContactParts& contact, IncrementReport& report);
void begin_friction(ContactParts& contact, const Task& task);
/// Largest shear that each cell of the contact can carry, the given limit or the strength of the softer surface with
/// the hardening of the present trial if that is less, for a direction of the shear on the lower body [Pa].
[[nodiscard]] std::vector<double> shear_limit(const ContactParts& contact, const Placement& placement,
                                              const std::array<double, 2>& direction);
/// Computes the shear for the pressure of the trial.
Interface::Change follow(ContactParts& contact, const Placement& placement);
void settle_friction(ContactParts& contact, const Placement& placement);
/// Recomputes the displacements of the interface after the history has moved to larger grids.
void recall_friction(ContactParts& contact);
/// Whether surfaces that may stick would move present pressure and shear over an end of the contact grid, so that their
/// displacements would be lost, or bring points from beyond the other end under the present pressure, whose gap is not known.
[[nodiscard]] bool carries_off(const ContactParts& contact, const Placement& placement);
/// The ranks that solve the contact together.
[[nodiscard]] const Communicator& ranks_of(const ContactParts& contact);
/// Columns by which the contact grid moves on the lower and the upper body from the present placement to another one.
[[nodiscard]] std::array<double, 2> columns_moved(const ContactParts& contact, const Placement& placement);
/// Shear between the surfaces on the grid of a body.
void spread_shear(const ContactParts& contact, const Place& place, const SurfaceGrid& body, double sign,
                  std::array<std::vector<double>, 2>& out);
/// Work of the shear on the residual displacement of one body [J].
[[nodiscard]] double work_of_shear(const ContactParts& contact, const Side& side);

/// Pressure, shear and slip of the present trial.
[[nodiscard]] Interaction interaction(const ContactParts& contact);
void begin_effects(ContactParts& contact);
/// Lets the effects follow the trial.
/// @returns the largest change of the gap by one of them [m]
double evaluate_effects(ContactParts& contact);
/// Sets the factors of the effects on the yield stress of the bodies, if they have any.
void soften_by_effects(ContactParts& contact);
/// After a converged increment: see Effect::renews_softening.
[[nodiscard]] bool renews_softening(ContactParts& contact, const Placement& placement, int turn);
[[nodiscard]] double largest_depth_of_effects(const ContactParts& contact);

void begin_heating(ContactParts& contact, const Task& task);
/// Computes the fluxes for pressure and slip of the trial.
/// @returns the largest change of the thermal displacement [m]
double follow_heat(ContactParts& contact, Heating::Sharing sharing);
/// Plastic work of the trial in the bodies that it heats, per cell [J/m^3]; empty for others.
[[nodiscard]] std::array<std::vector<double>, 2> works_that_heat(const ContactParts& contact);
/// Final heat of a converged increment, before anything is committed.
/// @throws GridError, ConvergenceError
void find_heat_of_increment(ContactParts& contact, const Motion& motion,
                            const std::array<std::vector<double>, 2>& works);
void settle_heating(ContactParts& contact, const std::array<std::vector<double>, 2>& works);
/// Adds the thermal stress of a body; for a twin the fields of the solved body are turned by the view.
void add_thermal_stress(const ContactParts& contact, std::size_t side, CoupledContact::Stress& stress);
/// Adds the thermal stress in some cells and sets their temperatures, layer by layer.
void add_heat(const ContactParts& contact, std::size_t side, std::span<const std::size_t> cells,
              std::vector<CoupledContact::CellState>& states);

} // namespace brinell::elastoplastic
