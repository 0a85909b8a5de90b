// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/foundation/error.hpp"
#include "contact_parts.hpp"
#include "foundation/sharing.hpp"
#include "stop_rules.hpp"
#include "unknowns.hpp"

#include <algorithm>
#include <cmath>
#include <omp.h>
#include <utility>

/// The fixed point of the trial deviators: docs/theory/elastoplastic.md.
namespace brinell::elastoplastic
{

namespace
{

/// Ratio of errors to tolerances below which the next evaluation is likely to be the last one.
constexpr double closing_factor = 5.0;

/// Ratio of errors to tolerances at which the plastic zone is known well enough to decide whether it extends beyond the ends or
/// sides of a grid. If it does, the increment is repeated on a larger grid without converging first.
constexpr double edge_check_factor = 50.0;

/// Range of the yield error in which trials may go further than their residual (Body::go_further): at larger errors they would
/// overshoot, and at smaller ones the plain combination is as good.
constexpr double near = 0.02, nearest = 1e-4;

/// Increments of deep indents of soft metals: where the yield error was ever larger, some cells flow by many times their yield
/// strain. The differences between evaluations are then far from those of a linear map, and the strains that cells flow into
/// freely are many: docs/theory/elastoplastic.md (deep).
namespace deep
{
constexpr double yield_error = 5.0;
constexpr int many_evaluations = 20; ///< without shear: as many tell of such an increment, too
constexpr int more_history = 4;      ///< times Strategy::anderson_depth
constexpr double damping = 0.05;
constexpr int more_evaluations = 4; ///< times Strategy::max_evaluations
constexpr int patience = 40;        ///< of the stall rule
} // namespace deep

/// Whether the work of two bodies is so similar that a thread for each of them is done sooner than two threads that share both in
/// turn: sharing makes two threads some 1.4 times as fast as one.
bool is_comparable(double first, double second)
{
  constexpr double gain_of_sharing = 1.4;
  return gain_of_sharing * std::max(first, second) < first + second;
}

double largest_change(std::span<const double> a, std::span<const double> b)
{
  double largest = 0.0;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
    largest = larger(largest, std::abs(a[i] - b[i]));
  return largest;
}

/// Only the lateral edges of the bodies: pressure, and stress in the last layer, are reliable only after convergence.
Outgrown lateral_edges(const Outgrown& outgrown)
{
  return {{outgrown.lower.ends, outgrown.lower.sides, false}, {outgrown.upper.ends, outgrown.upper.sides, false}};
}

/// The iteration of one increment.
class Iteration
{
public:
  Iteration(ContactParts& contact, const Task& task)
      : c_(contact), task_(task), strategy_(task.strategy),
        acceleration_(task.strategy.anderson_depth, ranks_of(contact),
                      std::ranges::any_of(contact.sides, [](const Side& side) { return side.body.has_inclusions(); }))
  {
  }

  IncrementReport solution();

private:
  [[nodiscard]] bool has_unknowns() const; ///< trials, or the equivalent strain of inclusions
  [[nodiscard]] bool all_sides(Scope scope) const;
  [[nodiscard]] bool evaluate();
  void find_displacements();
  [[nodiscard]] bool find_images();
  [[nodiscard]] bool is_within(double factor) const;
  void deepen();
  [[nodiscard]] bool is_out_of_hand() const;
  [[nodiscard]] bool leaves_grids();
  [[nodiscard]] bool has_left_windows(bool grew);
  [[nodiscard]] bool energy_rises(bool grew, bool renewed);
  [[nodiscard]] bool stalls(bool is_new);
  [[nodiscard]] Scope next_scope() const;

  ContactParts& c_;
  const Task& task_;
  const Strategy& strategy_;
  IncrementReport report_;
  Acceleration acceleration_;
  StallRule stall_rule_;
  EnergyWatch energy_watch_;
  Scope scope_ = Scope::near;
  bool is_deep_ = false, has_checked_edges_ = false;
  std::ptrdiff_t windows_ = 0; ///< bodies of which the last evaluation computed a window
  double yield_error_before_ = 0.0;
};

IncrementReport Iteration::solution()
{
  // The increment may only end with an evaluation that computed the stress in all cells; near convergence all evaluations do.
  scope_ = strategy_.watch_energy || !has_unknowns() ? Scope::all : Scope::near;
  for (report_.evaluations = 1;; ++report_.evaluations)
  {
    if (strategy_.wants_stop && strategy_.wants_stop())
      throw Interrupted();
    const bool grew = evaluate();
    const bool renewed = report_.converged && strategy_.watch_energy && renews_law(c_, report_);
    deepen();
    if (report_.converged || is_out_of_hand() || leaves_grids())
      return report_;
    const bool changes_map = has_left_windows(grew);
    if (strategy_.watch_energy ? energy_rises(grew, renewed) : stalls(grew || changes_map || report_.evaluations == 1))
      return report_;
    scope_ = next_scope();
    const bool is_near = report_.yield_error <= near && report_.yield_error >= nearest;
    acceleration_.advance(c_.sides, changes_map, is_near);
  }
}

/// One evaluation of g(q): plastic strain, residual displacement, contact, stress.
/// @returns whether cells have become active
bool Iteration::evaluate()
{
  for (Side& side : c_.sides)
    side.body.require(scope_);
  find_displacements();
  const bool is_complete = all_sides(Scope::all);
  solve_contact(c_, task_, scope_ == Scope::all, report_);
  const bool grew = find_images();
  // The first evaluation measures its change from the state before the increment: convergence needs at least a second one.
  const bool settled = report_.evaluations > 1 || !has_unknowns();
  report_.converged = report_.contact_converged && !grew && settled && is_complete && is_within(1.0);
  return grew;
}

bool Iteration::has_unknowns() const
{
  return std::any_of(c_.sides.begin(), c_.sides.end(),
                     [](const Side& side) { return side.body.active_of_all() > 0 || side.body.has_inclusions(); });
}

/// Whether the last evaluation of all bodies computed this much.
bool Iteration::all_sides(Scope scope) const
{
  return std::all_of(c_.sides.begin(), c_.sides.end(), [&](const Side& side) { return side.body.scope() == scope; });
}

/// Computes the plastic strain of the present trial and the resulting residual displacement of the surfaces.
void Iteration::find_displacements()
{
  std::array<double, 2> changes{};
  on_sides(c_, [&](std::size_t side) { changes[side] = c_.sides[side].body.integrate(strategy_.integration); });
  report_.displacement_error = larger(changes[0], changes[1]);
}

/// Computes the stress under the pressure of the trial and, from it, the image g(q) of the trial deviators.
/// @returns whether cells have become active
bool Iteration::find_images()
{
  std::array<bool, 2> grew{};
  on_sides(c_, [&](std::size_t side) { grew[side] = c_.sides[side].body.update(c_.sides[side].load()); });
  report_.yield_error = report_.inclusion_residual = 0.0;
  for (const Side& side : c_.sides)
  {
    report_.yield_error = larger(report_.yield_error, side.body.yield_error());
    const halfspace::Inclusions::Report inclusions = side.body.inclusion_report();
    report_.inclusion_iterations += inclusions.iterations;
    report_.inclusion_residual = larger(report_.inclusion_residual, inclusions.residual);
  }
  return grew[0] || grew[1];
}

/// Whether the errors of the fixed point are within `factor` times their tolerances. That of the residual displacement refers
/// to the scale of the run, or to the largest change of this displacement in the increment if that is larger, but not to more
/// than the largest approach.
bool Iteration::is_within(double factor) const
{
  const double tolerance = factor * c_.settings.displacement_tolerance;
  if (!(report_.yield_error <= factor * c_.settings.yield_tolerance))
    return false;
  if (report_.displacement_error <= tolerance * c_.scales.displacement)
    return true;
  double change = 0.0;
  for (const Side& side : c_.sides)
    change = larger(change, largest_change(side.body.residual_displacement(), side.body.state().residual_displacement));
  return report_.displacement_error <= tolerance * std::min(change, c_.scales.gap);
}

/// Keeps more of the history in a deep increment.
void Iteration::deepen()
{
  const bool is_slow = report_.evaluations >= deep::many_evaluations && !bears_shear(c_);
  if (is_deep_ || strategy_.anderson_depth == 0 || !(is_slow || report_.yield_error > deep::yield_error))
    return;
  is_deep_ = true;
  acceleration_.deepen(deep::more_history, deep::damping);
}

/// Whether there have been too many evaluations, or numbers are no longer finite.
bool Iteration::is_out_of_hand() const
{
  // With an interface, the increment already has as many evaluations.
  const int most = (is_deep_ && !c_.interface ? deep::more_evaluations : 1) * strategy_.max_evaluations;
  return !std::isfinite(report_.yield_error + report_.displacement_error + report_.gap_error) ||
         report_.evaluations >= most;
}

/// Whether plastic strain has reached lateral edges, once it is known well enough.
bool Iteration::leaves_grids()
{
  if (!strategy_.stay_within_grids || has_checked_edges_ || !is_within(edge_check_factor))
    return false;
  has_checked_edges_ = true;
  for (Side& side : c_.sides)
    side.body.fetch();
  report_.outgrown = lateral_edges(outgrown(c_));
  return report_.outgrown.any();
}

/// Whether fewer bodies than before were computed in a window only. What such an evaluation finds first tells the error of the
/// window.
bool Iteration::has_left_windows(bool grew)
{
  const auto now = std::count_if(c_.sides.begin(), c_.sides.end(),
                                 [](const Side& side) { return side.body.scope() == Scope::near; });
  const bool has_left = now < std::exchange(windows_, now);
  if (has_left && scope_ != Scope::near && !grew)
    c_.window_error.compare(yield_error_before_, report_.yield_error);
  yield_error_before_ = report_.yield_error;
  return has_left;
}

bool Iteration::energy_rises(bool grew, bool renewed)
{
  for (Side& side : c_.sides)
    side.body.complete_trial();
  report_.energy = energy(c_, imposed_approach(task_.drive, report_.approach));
  report_.energy_rose = energy_watch_.rises(report_.energy, report_.evaluations, grew);
  if (renewed)
    energy_watch_.begin_anew(report_.evaluations);
  return report_.energy_rose;
}

/// @param is_new  whether earlier errors are those of another problem
bool Iteration::stalls(bool is_new)
{
  return strategy_.anderson_depth > 0 &&
         stall_rule_.stalls(report_.yield_error, is_new, is_deep_ ? deep::patience : usual_patience);
}

Scope Iteration::next_scope() const
{
  if (strategy_.watch_energy || is_within(closing_factor))
    return Scope::all;
  const double of_window = c_.window_error.limit() / c_.settings.yield_tolerance;
  return is_within(std::max(closing_factor, of_window)) ? Scope::all_columns : Scope::near;
}

} // namespace

void on_sides(ContactParts& c, const std::function<void(std::size_t)>& work)
{
  constexpr int most_threads = 3;
  const int threads = omp_get_max_threads();
  const bool is_even = c.sides.size() == 2 && is_comparable(c.sides[0].body.cost(), c.sides[1].body.cost());
  if (is_even && ranks_of(c).is_alone() && threads > 1 && threads <= most_threads && !omp_in_parallel())
    side_by_side(work);
  else
    for (std::size_t side = 0; side < c.sides.size(); ++side)
      work(side);
}

IncrementReport iterate(ContactParts& contact, const Task& task)
{
  return Iteration(contact, task).solution();
}

} // namespace brinell::elastoplastic
