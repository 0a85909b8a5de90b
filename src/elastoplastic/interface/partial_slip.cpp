// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/elastoplastic/partial_slip.hpp"

#include "brinell/elastoplastic/placement.hpp"
#include "brinell/foundation/error.hpp"
#include "contact/carried_field.hpp"
#include "contact/entry_compliance.hpp"
#include "drive_axis.hpp"
#include "foundation/sharing.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace brinell::elastoplastic
{

namespace
{

using contact::TangentialDrive;

double largest_difference(std::span<const double> a, std::span<const double> b)
{
  double change = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
    change = larger(change, std::abs(a[i] - b[i]));
  return change;
}

} // namespace

PartialSlip::PartialSlip(const SurfaceGrid& grid, const Elastic& lower, const Elastic& upper, const Friction& friction,
                         double reference)
    : Interface(friction), pair_(grid, lower, upper, reference), scratch_(pair_.make_scratch()), tangential_(pair_),
      entry_(std::make_unique<contact::EntryCompliance>(pair_)), couples_(friction.coupling && pair_.couples())
{
  for (std::vector<double>* field : {&heat_of_increment_, &bound_before_, &bound_, &pressure_before_, &pressure_added_})
    field->assign(grid.size(), 0.0);
  for (Pair* pair : {&residual_before_, &displacement_before_, &change_, &slip_, &shear_before_})
    pair->fill(std::vector<double>(grid.size(), 0.0));
  assign_fields(state_, grid.size());
  if (!couples_)
    state_.depth.clear();
}

PartialSlip::~PartialSlip() = default;

bool PartialSlip::is_forced(std::size_t axis) const
{
  return axis_of(start_.along, axis).kind == TangentialDrive::Kind::force;
}

std::array<double, 2> PartialSlip::direction(const TangentialDrive& along) const
{
  const std::array<double, 2> force = forces();
  std::array<double, 2> way{}; // from the present force or shift to the imposed one
  for (std::size_t axis = 0; axis < 2; ++axis)
  {
    const auto& [kind, value] = axis_of(along, axis);
    way[axis] = value - (kind == TangentialDrive::Kind::force ? force : state_.shift)[axis];
    // A force of zero is reached only to rounding, and rounding must not define a direction.
    if (kind == TangentialDrive::Kind::force && std::abs(way[axis]) <= 1e-9 * (std::abs(value) + std::abs(force[axis])))
      way[axis] = 0.0;
  }
  const double size = std::hypot(way[0], way[1]);
  return size > 0.0 ? std::array{way[0] / size, way[1] / size} : std::array{0.0, 0.0};
}

/// Displacement along x and y, lower minus upper body, due to a pressure and the residual displacements, without that of the
/// shears.
void PartialSlip::find_displacement(const Bodies& bodies, std::span<const double> pressure, Pair& out)
{
  if (couples_)
    pair_.apply({.pressure = pressure}, {.x = out[0], .y = out[1]}, scratch_);
  else
    for (std::vector<double>& part : out)
      std::fill(part.begin(), part.end(), 0.0);
  const auto add = [](std::span<const double> lower, std::span<const double> upper, std::vector<double>& to)
  {
    for (std::size_t i = 0; i < to.size(); ++i)
      to[i] += lower[i] - upper[i];
  };
  add(bodies.lower_x, bodies.upper_x, out[0]);
  add(bodies.lower_y, bodies.upper_y, out[1]);
}

/// Moves the quantities that belong to surface points through the contact grid as the contact rolls. Residual displacements are
/// read from the bodies at the new place and need no move.
void PartialSlip::advect(const Bodies& bodies)
{
  const SurfaceGrid& grid = pair_.grid();
  carried_ = {-static_cast<int>(std::lround(bodies.lower_columns)), 0};
  const auto is_carried = [&](double columns) { return std::abs(columns + carried_[0]) < 1e-6; };
  const bool rolls = is_carried(bodies.lower_columns) && is_carried(bodies.upper_columns);
  if (!rolls && sum(bodies.pressure) > 0.0)
    throw InternalError("PartialSlip: the contact moves by the same whole columns on both bodies");
  contact::carry(grid, carried_, bodies.pressure, pressure_before_);
  for (std::size_t axis = 0; axis < 2; ++axis)
    contact::carry(grid, carried_, before_.shear[axis], shear_before_[axis]);
  if (carried_[0] == 0)
    return;
  for_fields(
      [&](const Traits& traits, const std::vector<double>& before, std::vector<double>& now)
      {
        if (traits.is_carried)
          contact::carry(grid, carried_, before, now);
      },
      std::as_const(before_), state_);
}

/// Rigid displacement of the upper body relative to the lower one that is imposed on a cell in the increment, by shift and spin;
/// the shift that follows from an imposed force is not included [m].
double PartialSlip::imposed(std::size_t axis, int column, int row) const
{
  const SurfaceGrid& grid = pair_.grid();
  const double shift = is_forced(axis) ? 0.0 : axis_of(drive_, axis).value;
  const contact::Along turned = contact::turned(grid, carried_, drive_.spin, column, row);
  return shift + (axis == 0 ? turned.x : turned.y);
}

/// Estimate of the relative displacement that the drive causes in the increment; for a force, with the compliance of full stick.
/// @returns 0 if nothing is driven [m]
double PartialSlip::driven_motion() const
{
  const double carried = sum(bound_before_) * pair_.grid().cell_area();
  const double displaced = friction().coefficient * start_.approach; // estimate, by shears at their bound
  const std::array<double, 2> force = forces();
  const SurfaceGrid& grid = pair_.grid();
  double squares = std::pow(drive_.spin * std::hypot(grid.x(grid.nx - 1), grid.y(grid.ny - 1)), 2);
  for (std::size_t axis = 0; axis < 2; ++axis)
  {
    const double value = axis_of(drive_, axis).value;
    constexpr double rounding = 1e-12; // of a sum of shears: a force of zero is reached to this accuracy
    const double share = carried > 0.0 ? std::abs(value - force[axis]) / carried : 0.0;
    squares += std::pow(is_forced(axis) ? (share > rounding ? share * displaced : 0.0) : value, 2);
  }
  return std::sqrt(squares);
}

/// The usual tolerance of displacements is relative to the approach. Slip can be far smaller: shears at their bound displace the
/// surfaces by about friction times the approach, and the imposed motion of an increment may be smaller still. In rolling, errors
/// of the slip accumulate from step to step until the points have left the contact. Hence a tighter tolerance [m].
double PartialSlip::tolerance_of_slip() const
{
  constexpr double of_bound = 1e-4, of_motion = 1e-3, rounding = 1e-15;
  const double moved = driven_motion();
  double wanted = of_bound * friction().coefficient * start_.approach;
  if (moved > 0.0)
    wanted = std::min(wanted, of_motion * moved);
  return std::min(start_.tolerance, std::max(wanted, rounding * start_.approach));
}

void PartialSlip::begin(Start start)
{
  before_ = state_;
  start_ = std::move(start);
  const Bodies& bodies = start_.bodies;
  advect(bodies);
  drive_ = start_.along;
  drive_.spin -= state_.turned;
  if (!is_forced(0))
    drive_.x.value -= state_.shift[0];
  if (!is_forced(1))
    drive_.y.value -= state_.shift[1];
  has_bound_ = false;
  static_cast<void>(set_bound(pressure_before_));
  has_bound_ = false;
  bound_before_ = bound_;
  entries_ = 0;
  is_driven_ = driven_motion() > 0.0;
  start_.tolerance = tolerance_of_slip();
  find_displacement(bodies, pressure_before_, displacement_before_);
  for (std::size_t i = 0; i < bound_.size(); ++i)
  {
    residual_before_[0][i] = bodies.lower_x[i] - bodies.upper_x[i];
    residual_before_[1][i] = bodies.lower_y[i] - bodies.upper_y[i];
  }
  pair_.apply({.shear_x = shear_before_[0], .shear_y = shear_before_[1]}, {.x = change_[0], .y = change_[1]}, scratch_);
  for (std::size_t axis = 0; axis < 2; ++axis)
    for (std::size_t i = 0; i < bound_.size(); ++i)
      displacement_before_[axis][i] += change_[axis][i];
  start_.bodies = {}; // the spans are valid during this call only
}

/// Largest shear of a cell.
double PartialSlip::bound_at(std::size_t cell, double pressure) const
{
  return std::min(friction().coefficient * pressure, start_.limit[cell]);
}

/// Sets the largest shear of each cell; with `Start::holds_law` only once per increment or after `renew`.
/// @returns whether it has been set anew
bool PartialSlip::set_bound(std::span<const double> pressure)
{
  if (start_.holds_law && has_bound_)
    return false;
  has_bound_ = true;
  for (std::size_t i = 0; i < bound_.size(); ++i)
    bound_[i] = bound_at(i, pressure[i]);
  return true;
}

/// Whether shears within the bound can carry the imposed force.
bool PartialSlip::carries_drive() const
{
  double squares = 0.0;
  for (std::size_t axis = 0; axis < 2; ++axis)
    squares += is_forced(axis) ? std::pow(axis_of(drive_, axis).value, 2) : 0.0;
  constexpr double margin = 1e-8; // larger than the margin of TangentialContact, which rejects the remaining cases
  return squares == 0.0 || std::sqrt(squares) < (1.0 - margin) * sum(bound_) * pair_.grid().cell_area();
}

/// Solves the tangential problem under the present bound.
/// @returns whether it converged
bool PartialSlip::solve(const Bodies& bodies)
{
  for (std::size_t i = 0; i < bound_.size(); ++i)
    pressure_added_[i] = bodies.pressure[i] - pressure_before_[i];
  find_displacement(bodies, pressure_added_, change_);
  for (std::size_t axis = 0; axis < 2; ++axis)
    for (std::size_t i = 0; i < bound_.size(); ++i)
      change_[axis][i] -= residual_before_[axis][i];
  if (sum(bound_) == 0.0)
  {
    for (std::vector<double>* field : {&state_.shear[0], &state_.shear[1], &slip_[0], &slip_[1]})
      std::fill(field->begin(), field->end(), 0.0);
    for (std::size_t axis = 0; axis < 2; ++axis)
      shift_[axis] = is_forced(axis) ? 0.0 : axis_of(drive_, axis).value;
    return carries_drive();
  }
  if (!carries_drive())
    return false;
  constexpr int max_iterations = 2000;
  contact::TangentialStep step;
  step.bound = bound_;
  step.before = {before_.shear[0], before_.shear[1]};
  step.change = {change_[0], change_[1]};
  step.drive = drive_;
  step.carried = carried_;
  step.entry = entry_->fields();
  const contact::TangentialReport report =
      tangential_.solve(step, start_.tolerance, max_iterations, {state_.shear[0], state_.shear[1]},
                        {slip_[0], slip_[1]}, start_.wants_stop);
  shift_ = report.shift;
  return report.converged;
}

/// Computes the normal displacement that the shears add to the gap.
/// @returns its largest change [m]
double PartialSlip::update_depth()
{
  if (!couples_)
    return 0.0;
  const std::vector<double> before = state_.depth;
  pair_.apply({.shear_x = state_.shear[0], .shear_y = state_.shear[1]}, {.z = state_.depth}, scratch_);
  return largest_difference(state_.depth, before);
}

Interface::Change PartialSlip::follow(const Bodies& bodies)
{
  constexpr int enough = 20; // updates of the entry, after which it can only alternate, with much wear
  if (set_bound(bodies.pressure) && ++entries_ <= enough)
    entry_->find(carried_, pressure_before_, bodies.pressure, bodies.gap);
  Change change;
  change.is_solved = solve(bodies);
  change.is_overloaded = !carries_drive();
  change.gap = update_depth();
  return change;
}

/// Only marks the bound for renewal: the bound of the present solution stays until the next `follow`, because `slips_at` compares
/// the shear with it.
Interface::Change PartialSlip::renew(const Bodies& bodies)
{
  has_bound_ = false;
  Change change;
  for (std::size_t i = 0; i < bound_.size(); ++i)
    change.shear = larger(change.shear, std::abs(bound_at(i, bodies.pressure[i]) - bound_[i]));
  return change;
}

/// The dual value of the tangential problem: -1/2 q C q + q u, where u is the displacement that the shears would have to cause
/// for full stick.
double PartialSlip::held_energy() const
{
  std::array<std::vector<double>, 2> along{std::vector<double>(bound_.size()), std::vector<double>(bound_.size())};
  pair_.apply({.shear_x = state_.shear[0], .shear_y = state_.shear[1]}, {.x = along[0], .y = along[1]});
  double total = 0.0;
  const std::array<std::span<const double>, 3> entry = entry_->fields();
  const SurfaceGrid& grid = pair_.grid();
  for (std::size_t axis = 0; axis < 2; ++axis)
    for (int row = 0; row < grid.ny; ++row)
      for (int column = 0; column < grid.nx; ++column)
      {
        const std::size_t i = grid.index(column, row);
        const double full_stick = displacement_before_[axis][i] + imposed(axis, column, row);
        const double on_entry = entry.front().empty()
                                    ? 0.0
                                    : entry[axis][i] * state_.shear[axis][i] + entry[2][i] * state_.shear[1 - axis][i];
        total += state_.shear[axis][i] * (full_stick - 0.5 * (along[axis][i] + on_entry));
      }
  return total * pair_.grid().cell_area();
}

void PartialSlip::add_to_gap(std::span<double> gap) const
{
  for (std::size_t i = 0; i < state_.depth.size(); ++i)
    gap[i] += state_.depth[i];
}

void PartialSlip::recall(const Bodies& /*bodies*/)
{
  static_cast<void>(update_depth());
}

} // namespace brinell::elastoplastic
