// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/contact/tangential_contact.hpp"
#include "brinell/elastoplastic/body.hpp"

#include <array>
#include <functional>
#include <optional>

/// Questions to an increment and its answer.
namespace brinell::elastoplastic
{

/// How the surfaces move on each other and over the bodies in one increment.
struct Motion
{
  /// For surfaces that may stick: forces at the end of the increment, or shifts since the first one. For others: the sign of the
  /// shift along x, unless zero, is the direction of sliding.
  contact::TangentialDrive along{};
  /// Whether the surfaces slide on each other in this increment; if false there is no friction.
  bool slides = true;
  double slid = 0.0;     ///< sliding distance of the undeformed surfaces in the increment [m], >= 0
  double duration = 0.0; ///< of the increment [s]; 0: no heat is generated or conducted
  /// The contact was put down at its place without moving over the bodies: no heat on the way.
  bool is_put_down = false;
  bool returns = false; ///< includes the way back of the contact to its start: no heat from a HeatSource
  /// Distances that the contact moves over the lower and the upper body in the increment [m]. Placements follow by whole columns.
  std::array<double, 2> moved{};
  double step =
      0.0; ///< row of the history that the increment ends at, which counts from 0; between two rows within a step
  /// Of surfaces that slide everywhere: the share of the full friction at the end of an increment in which friction is
  /// raised before the surfaces move, from -1, the friction of the opposite direction, to 1; none: the surfaces move
  /// under full friction. The work of the shear in increments at rest counts as heat of the next increment that moves.
  std::optional<double> share_at_rest{};
};

/// How one increment is solved.
struct Strategy
{
  Integration integration = Integration::path;
  int max_evaluations = 60;
  int anderson_depth = 6;
  /// c / (2 mu) in q = s + c d_eps, see Body::begin.
  double stiffness_share = 0.6;
  /// Compute all layers in each evaluation, and give up as soon as the energy of the increment's convex problem,
  /// docs/theory/elastoplastic.md (energy), rises (backward Euler, plain fixed point): the caller then tries a larger stiffness
  /// share, that is shorter steps of the iteration. If false, the stall rule ends an iteration that makes no progress.
  bool watch_energy = false;
  /// Do not commit a solution that has outgrown a grid: `converged` is then false, and the caller has to continue on larger
  /// grids. If false, strain beyond an edge is lost.
  bool stay_within_grids = false;
  std::function<bool()> wants_stop{}; ///< asked before each evaluation and while the contact is solved
  /// Keep the largest shear that the surfaces can carry as it was before the increment, an error of first order in its length, so
  /// that hardening and shear do not raise each other. Implied by `watch_energy`.
  bool keeps_shear_limit = false;
};

/// Edges of the three grids that pressure or plastic strain has reached.
struct Outgrown
{
  Edges lower, upper;
  /// Pressure in the outermost columns, or rows, of the contact grid; of surfaces that wear in the two outermost ones.
  bool contact_ends = false, contact_sides = false;
  [[nodiscard]] bool any() const
  {
    return contact_ends || contact_sides || lower.ends || lower.sides || lower.bottom || upper.ends || upper.sides ||
           upper.bottom;
  }
};

/// How an increment ended.
struct IncrementReport
{
  bool converged = false;
  Outgrown outgrown{}; ///< edges that the solution reached, if it converged
  bool contact_converged = false;
  double approach = 0.0; ///< imposed, or found for the load imposed [m]
  int evaluations = 0;   ///< evaluations of the elastic-plastic operator of both bodies
  int contact_iterations = 0;
  double yield_error = 0.0;        ///< largest |g(q) - q| over the yield stress
  double displacement_error = 0.0; ///< largest change of residual displacement in the last evaluation [m]
  double gap_error = 0.0;          ///< contact complementarity [m]
  double energy = 0.0;             ///< locked-in, elastic and dissipated energy, which backward Euler minimises [J]
  long inclusion_iterations = 0;   ///< of the equivalent strain of inclusions, in all evaluations of both bodies
  double inclusion_residual = 0.0; ///< of its equation in the last evaluation, relative to the stress
  bool energy_rose = false;        ///< stopped by Strategy::watch_energy
  bool overloaded = false;         ///< friction could not carry the force along the surface in the last evaluation
};

/// Reference lengths of the tolerances [m].
struct Scales
{
  /// For the change of residual displacement: approach at first yield; plans limit it to between 1 % and 100 % of the largest
  /// approach. Friction is left out: it makes bodies yield earlier, but the displacements relevant to the contact stay as large.
  double displacement = 0.0;
  double gap = 0.0; ///< for complementarity: largest approach
};

} // namespace brinell::elastoplastic
