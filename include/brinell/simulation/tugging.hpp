// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/constitutive/material.hpp"
#include "brinell/elastoplastic/settings.hpp"
#include "brinell/foundation/grid.hpp"
#include "brinell/simulation/kinematics.hpp"

#include <array>
#include <functional>
#include <optional>
#include <vector>

/// Step loops: motion, history, energies. The tugging of two spherical asperities: the upper one is carried along X
/// past the lower one at a constant height, so that they interfere and push each other (Boucly, Nelias, Green 2006).
namespace brinell::simulation
{

/// One of the two asperities: a sphere and what it is made of.
struct Asperity
{
  double radius = 0.0; ///< [m], > 0
  constitutive::Material material;
  bool operator==(const Asperity&) const = default;
};

/// Everything that defines a tugging run. SI units.
struct TuggingCase
{
  Asperity lower;
  Asperity upper;
  double interference = 0.0;   ///< largest rigid-body interference, reached at alignment [m], > 0
  std::optional<double> shift; ///< arc moved on each body per step (mean of both) [m]; default: one cell dx
  Kinematics kinematics = Kinematics::exact;
  int passes = 1;
  std::optional<std::array<double, 3>> spacing; ///< cell sizes dx, dy, dz [m]
  double resolution = 8.0;                      ///< cells per elastic contact radius along x if no spacing is given
  double extent = 1.0; ///< factor on the automatic extent of the grids around contact and plastic zone, > 0
  elastoplastic::Settings solver;
};

/// What the run will cost and where its cells are; computed without running.
struct TuggingPlan
{
  SurfaceGrid contact;     ///< grid of the contact, carried along with it
  VolumeGrid lower, upper; ///< material grids, wide enough for the whole track
  int steps_per_pass = 0;
  bool mirrored = false; ///< the upper body is the mirror image in x of the lower one, cell by cell: one is solved
  double memory_bytes = 0.0;
  double elastic_contact_radius = 0.0; ///< at alignment [m]
  double shift = 0.0;                  ///< mean arc per step [m]
  double start_distance = 0.0;         ///< d0, Eq. 2 [m]
};

/// One row of the history. SI units; names as in history.csv.
struct StepRecord
{
  int step = 0; ///< counts from 0 over all passes
  int pass = 0; ///< counts from 0
  double X = 0.0, theta = 0.0, interference = 0.0;
  double contact_area = 0.0, max_pressure = 0.0;
  double F_n = 0.0;                        ///< normal force in the plane of contact [N]
  double F_X = 0.0, F_Y = 0.0, F_Z = 0.0;  ///< mean contact plane, pile-up included; F_X > 0 resists the motion [N]
  double F_X_macro = 0.0, F_Z_macro = 0.0; ///< Eqs. 15, 17: without the slope of the residual surfaces [N]
  double F_X_lower = 0.0, F_X_upper = 0.0; ///< Eq. 18 read on each body's own residual surface [N]
  double work = 0.0;                       ///< integral of F_X dX since the start [J]
  double dissipation_lower = 0.0, dissipation_upper = 0.0; ///< plastic work since the start [J]
  double energy_residual = 0.0; ///< elastic energy locked in by the plastic strain of both bodies [J]
  double energy_elastic = 0.0;  ///< recoverable energy of the contact pressure [J]
  double max_residual_lower = 0.0, max_residual_upper = 0.0; ///< largest depth of the residual displacement [m]
  double max_equivalent_plastic_strain = 0.0;
  int iterations = 0; ///< evaluations of the elastic-plastic operator in this step
};

/// Fields of one body on its own material grid (see TuggingPlan); x = 0 is the point touched at alignment.
struct BodySnapshot
{
  VolumeGrid grid;
  double x0 = 0.0, y0 = 0.0;                         ///< centre of cell (0, 0) in the body's surface coordinates [m]
  double contact_x = 0.0;                            ///< where the contact centre is now [m]
  std::array<std::vector<double>, 6> stress;         ///< xx yy zz yz xz xy, contact and residual [Pa]
  std::array<std::vector<double>, 6> plastic_strain; ///< xx yy zz yz xz xy [-]
  std::vector<double> equivalent_plastic_strain;     ///< [-]
  std::vector<double> residual_displacement;         ///< surface, into the body positive [m]
};

/// Fields of one step.
struct Snapshot
{
  StepRecord record;
  SurfaceGrid contact;
  double x0 = 0.0, y0 = 0.0;    ///< centre of contact cell (0, 0) in the local frame (x', y') [m]
  std::vector<double> pressure; ///< [Pa]
  std::vector<double> gap;      ///< [m], >= 0
  BodySnapshot lower, upper;
};

/// How a caller watches a run. Empty functions are skipped.
struct TuggingObserver
{
  std::function<void(const StepRecord&, int step_count_estimate)> on_step;
  std::function<bool(const StepRecord&)> wants_snapshot; ///< asked after each step
  std::function<void(const Snapshot&)> on_snapshot;
};

/// Key results of a whole run.
struct TuggingSummary
{
  int steps = 0;
  long iterations = 0;
  int split_increments = 0;                    ///< increments that had to be split or redone with the guarded scheme
  double peak_F_X = 0.0, X_at_peak_F_X = 0.0;  ///< largest resistance [N], where [m]
  double min_F_X = 0.0;                        ///< largest push forward (negative) [N]
  double peak_F_Z = 0.0;                       ///< [N]
  double F_X_aligned = 0.0, F_Z_aligned = 0.0; ///< at X = 0 [N]
  double load_ratio_aligned = 0.0;             ///< F_X / F_Z at X = 0
  double load_ratio_end = 0.0;                 ///< F_X / F_Z at the end of the contact
  double work = 0.0;                           ///< net energy: integral of F_X dX over all passes [J]
  double work_to_alignment = 0.0;              ///< first pass, up to X = 0 [J]
  double dissipation_lower = 0.0, dissipation_upper = 0.0, energy_residual = 0.0; ///< [J]
  double energy_balance_error = 0.0; ///< (work - dissipation - locked-in energy) / largest work reached
  double max_residual_lower = 0.0, max_residual_upper = 0.0; ///< after unloading [m]
  double max_equivalent_plastic_strain = 0.0;
  Snapshot final_state; ///< after the last step, the entire track of both bodies
};

/// Grids, number of steps and memory of a case.
/// @throws InputError if the case cannot be computed (for example a grid of absurd size).
[[nodiscard]] TuggingPlan plan(const TuggingCase& tugging);

/// Runs a case.
/// @throws InputError, ConvergenceError (all earlier steps have been reported to the observer).
[[nodiscard]] TuggingSummary run(const TuggingCase& tugging, const TuggingObserver& observer = {});

} // namespace brinell::simulation
