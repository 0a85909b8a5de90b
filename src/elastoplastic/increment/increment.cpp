// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/elastoplastic/increment.hpp"

#include "brinell/foundation/error.hpp"
#include "foundation/require_size.hpp"
#include "foundation/sharing.hpp"
#include "stop_rules.hpp"
#include "unknowns.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <omp.h>
#include <utility>

/// One increment, from its start to its commit.
namespace brinell::elastoplastic
{

namespace
{

/// Restores the state before the increment on destruction, unless the increment was committed.
template <typename Sides>
class Rollback
{
public:
  Rollback(std::vector<double>& pressure, std::vector<double>& gap, WindowError& window_error, Sides& sides,
           Interface* interface, Heating* heating)
      : pressure_(pressure), gap_(gap), window_error_(window_error), sides_(sides), interface_(interface),
        heating_(heating), old_pressure_(pressure), old_gap_(gap), old_window_error_(window_error)
  {
  }
  ~Rollback()
  {
    if (committed_)
      return;
    pressure_.swap(old_pressure_);
    gap_.swap(old_gap_);
    window_error_ = old_window_error_;
    for (auto& side : sides_)
      side.body.restore();
    if (interface_ != nullptr)
      interface_->restore();
    if (heating_ != nullptr)
      heating_->restore();
  }
  Rollback(const Rollback&) = delete;
  Rollback& operator=(const Rollback&) = delete;
  void commit() { committed_ = true; }

private:
  std::vector<double>&pressure_, &gap_;
  WindowError& window_error_;
  Sides& sides_;
  Interface* interface_; ///< nullptr: none
  Heating* heating_;     ///< nullptr: none
  std::vector<double> old_pressure_, old_gap_;
  WindowError old_window_error_;
  bool committed_ = false;
};

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

template <typename Sides>
bool bears_shear(const Sides& sides)
{
  const auto acts = [](double shear) { return shear != 0.0; };
  return std::any_of(sides.begin(), sides.end(),
                     [&](const auto& side)
                     {
                       return std::any_of(side.shear[0].begin(), side.shear[0].end(), acts) ||
                              std::any_of(side.shear[1].begin(), side.shear[1].end(), acts);
                     });
}

bool is_finite(const IncrementReport& report)
{
  return std::isfinite(report.yield_error + report.displacement_error + report.gap_error);
}

/// Approach whose work enters the dual value of the contact, see CoupledContact::energy; 0 where the load is imposed.
double imposed_approach(const contact::Drive& drive, double found)
{
  return drive.kind == contact::Drive::Kind::load ? 0.0 : found;
}

} // namespace

bool CoupledContact::has_unknowns() const
{
  return std::any_of(sides_.begin(), sides_.end(), [](const Side& side) { return !side.body.active().empty(); });
}

/// Calls work(side) with the index of each body. If both bodies take about as long, two or three threads take one body each: that
/// is faster than to share each of them, because the threads hardly wait and find in their caches what they have written.
template <typename Work>
void CoupledContact::on_sides(const Work& work)
{
  constexpr int most_threads = 3;
  const int threads = omp_get_max_threads();
  const bool is_even = sides_.size() == 2 && is_comparable(sides_[0].body.cost(), sides_[1].body.cost());
  if (is_even && threads > 1 && threads <= most_threads && !omp_in_parallel())
    side_by_side(work);
  else
    for (std::size_t side = 0; side < sides_.size(); ++side)
      work(side);
}

/// Computes the plastic strain of the present trial and the resulting residual displacement of the surfaces.
/// @returns the largest change of that displacement [m]
double CoupledContact::integrate(Integration integration)
{
  std::array<double, 2> changes{};
  on_sides([&](std::size_t side) { changes[side] = sides_[side].body.integrate(integration); });
  return larger(changes[0], changes[1]);
}

/// Computes the stress under the pressure of the trial and, from it, the image g(q) of the trial deviators.
/// @returns whether cells have become active
bool CoupledContact::update(IncrementReport& report)
{
  std::array<bool, 2> grew{};
  on_sides([&](std::size_t side) { grew[side] = sides_[side].body.update(sides_[side].load()); });
  report.yield_error = 0.0;
  for (const Side& side : sides_)
    report.yield_error = larger(report.yield_error, side.body.yield_error());
  return grew[0] || grew[1];
}

/// Number of bodies of which the last evaluation computed a window.
std::ptrdiff_t CoupledContact::windows() const
{
  return std::count_if(sides_.begin(), sides_.end(), [](const Side& side) { return side.body.scope() == Scope::near; });
}

/// Whether the errors of the fixed point are within `factor` times their tolerances. That of the residual displacement refers
/// to the scale of the run, or to the largest change of this displacement in the increment if that is larger, but not to more
/// than the largest approach.
bool CoupledContact::is_within(double factor, const IncrementReport& report) const
{
  const double tolerance = factor * settings_.displacement_tolerance;
  if (!(report.yield_error <= factor * settings_.yield_tolerance))
    return false;
  if (report.displacement_error <= tolerance * scales_.displacement)
    return true;
  double change = 0.0;
  for (const Side& side : sides_)
    change = larger(change, largest_change(side.body.residual_displacement(), side.body.state().residual_displacement));
  return report.displacement_error <= tolerance * std::min(change, scales_.gap);
}

/// Energy of the present trial [J].
/// @param approach  of the trial [m]
double CoupledContact::energy_of_trial(const contact::Drive& drive, double approach)
{
  for (Side& side : sides_)
    side.body.complete_trial();
  return energy(imposed_approach(drive, approach));
}

/// Solves for gap and pressure of the surfaces with the residual displacements of the present trial.
void CoupledContact::solve_contact(std::span<const double> distance, const contact::Drive& drive,
                                   const Placement& placement, const Strategy& strategy, bool closing,
                                   IncrementReport& report)
{
  std::copy(distance.begin(), distance.end(), distance_.begin());
  add_lower_depth(placement.lower, distance_);
  add_upper_depth(placement.upper, distance_);
  if (interface_)
    solve_frictional_contact(drive, placement, strategy, closing, report);
  else
    press(drive, strategy, report);
  spread(placement);
}

/// Solves for the pressure of surfaces at the distance `distance_`.
void CoupledContact::press(const contact::Drive& drive, const Strategy& strategy, IncrementReport& report)
{
  constexpr int max_iterations = 2000;
  const contact::Report contact = contact_.solve(distance_, drive, tolerance_of_gap(), max_iterations, pressure_, gap_,
                                                 strategy.wants_stop, compliance_of_effects_);
  if (symmetry_ != Symmetry::none) // otherwise rounding errors would grow from step to step
    for (std::vector<double>* field : {&pressure_, &gap_})
      complete_in_y(grid(), 1.0, field->data(), field->size());
  report.contact_iterations += contact.iterations;
  report.gap_error = std::max(contact.gap_error, contact.penetration);
  report.contact_converged = contact.converged;
  report.approach = contact.approach;
}

/// Transfers pressure and shear to the grids of the bodies.
void CoupledContact::spread(const Placement& placement)
{
  for (Side& side : sides_)
  {
    const Place& place = placement.*side.place;
    const SurfaceGrid& surface = side.body.grid().surface;
    side.leaves_grid = !spread_traction(grid(), pressure_, place, surface, side.pressure);
    if (interface_)
      spread_shear(place, surface, side.shear_sign, side.shear);
  }
}

namespace
{

/// Only the lateral edges of the bodies: pressure, and stress in the last layer, are reliable only after convergence.
Outgrown lateral_edges(const Outgrown& outgrown)
{
  return {{outgrown.lower.ends, outgrown.lower.sides, false}, {outgrown.upper.ends, outgrown.upper.sides, false}};
}

} // namespace

/// Iterates the fixed point of the trial deviators until it converges or is given up.
IncrementReport CoupledContact::iterate(std::span<const double> distance, const contact::Drive& drive,
                                        const Placement& placement, const Strategy& strategy)
{
  IncrementReport report;
  Acceleration acceleration(strategy.anderson_depth);
  StallRule stall_rule;
  EnergyWatch energy_watch;
  // The increment may only end with an evaluation that computed the stress in all cells; near convergence all evaluations do.
  bool closing = strategy.watch_energy || !has_unknowns();
  bool leaves_window = false, has_checked_edges = false, is_deep = false;
  std::ptrdiff_t windows_now = 0;
  double yield_error_before = 0.0;
  for (report.evaluations = 1;; ++report.evaluations)
  {
    if (strategy.wants_stop && strategy.wants_stop())
      throw Interrupted();
    for (Side& side : sides_)
      side.body.require(closing ? Scope::all : leaves_window ? Scope::all_columns : Scope::near);
    report.displacement_error = integrate(strategy.integration);
    const bool complete =
        std::all_of(sides_.begin(), sides_.end(), [](const Side& side) { return side.body.scope() == Scope::all; });
    solve_contact(distance, drive, placement, strategy, closing, report);
    const bool grew = update(report);
    // The first evaluation measures its change from the state before the increment: convergence needs at least a second one.
    const bool settled = report.evaluations > 1 || !has_unknowns();
    report.converged = report.contact_converged && !grew && settled && complete && is_within(1.0, report);
    const bool renewed = report.converged && strategy.watch_energy && renews_law(report);
    const bool is_slow = report.evaluations >= deep::many_evaluations && !bears_shear(sides_);
    if (!is_deep && strategy.anderson_depth > 0 && (is_slow || report.yield_error > deep::yield_error))
    {
      is_deep = true;
      acceleration.deepen(deep::more_history, deep::damping);
    }
    // With an interface, the increment already has as many evaluations.
    const int most = (is_deep && !interface_ ? deep::more_evaluations : 1) * strategy.max_evaluations;
    if (report.converged || !is_finite(report) || report.evaluations >= most)
      return report;
    if (strategy.stay_within_grids && !has_checked_edges && is_within(edge_check_factor, report))
    {
      has_checked_edges = true;
      report.outgrown = lateral_edges(outgrown());
      if (report.outgrown.any())
        return report;
    }
    if (strategy.watch_energy)
    {
      report.energy = energy_of_trial(drive, report.approach);
      report.energy_rose = energy_watch.rises(report.energy, report.evaluations, grew);
      if (renewed)
        energy_watch.begin_anew(report.evaluations);
    }
    const std::ptrdiff_t windows_before = std::exchange(windows_now, windows());
    const bool changes_map = windows_now < windows_before;
    if (changes_map && leaves_window && !grew)
      window_error_.compare(yield_error_before, report.yield_error);
    yield_error_before = report.yield_error;
    const bool stalls = !strategy.watch_energy && strategy.anderson_depth > 0 &&
                        stall_rule.stalls(report.yield_error, grew || changes_map || report.evaluations == 1,
                                          is_deep ? deep::patience : usual_patience);
    if (report.energy_rose || stalls)
      return report;
    closing = strategy.watch_energy || is_within(closing_factor, report);
    leaves_window = is_within(std::max(closing_factor, window_error_.limit() / settings_.yield_tolerance), report);
    const bool is_near = report.yield_error <= near && report.yield_error >= nearest;
    acceleration.advance(sides_, changes_map, is_near);
  }
}

IncrementReport CoupledContact::advance(std::span<const double> distance, const contact::Drive& drive,
                                        const Placement& placement, const Strategy& strategy,
                                        const contact::TangentialDrive& along)
{
  require_size("CoupledContact::advance: the distance", distance, grid().size());
  if (strategy.stay_within_grids && carries_off(placement))
  {
    IncrementReport report;
    report.outgrown.contact_ends = true;
    return report;
  }
  slid_ = strategy.slides ? strategy.slid : 0.0;
  if (interface_)
    begin_friction(placement, strategy, along);
  Rollback rollback(pressure_, gap_, window_error_, sides_, interface_.get(), heating_.get());
  for (Side& side : sides_)
    side.body.begin((placement.*side.place).column - (placement_.*side.place).column, strategy.stiffness_share);
  begin_effects();
  if (heating_)
    begin_heating(placement, strategy);
  IncrementReport report = iterate(distance, drive, placement, strategy);
  if (!report.converged)
    return report;
  report.outgrown = outgrown();
  if (strategy.stay_within_grids && report.outgrown.any())
  {
    report.converged = false;
    return report;
  }
  if (std::any_of(sides_.begin(), sides_.end(), [](const Side& side) { return side.leaves_grid; }))
    throw GridError("the contact has reached the end of a material grid");
  on_sides([&](std::size_t side) { sides_[side].body.complete_trial(); });
  if (interface_)
    settle_friction(placement);
  const std::array<std::vector<double>, 2> works = works_that_heat();
  if (heating_)
    find_heat_of_increment(strategy, works);
  // From here on nothing may fail: what is committed cannot be taken back.
  on_sides([&](std::size_t side) { sides_[side].body.commit(sides_[side].load()); });
  report.energy = energy(imposed_approach(drive, report.approach)); // after commit, which computes the locked-in part
  for (const std::unique_ptr<Effect>& effect : effects_)
    effect->commit(interaction(), placement);
  if (heating_)
    settle_heating(works);
  placement_ = placement;
  approach_ = report.approach;
  rollback.commit();
  return report;
}

} // namespace brinell::elastoplastic