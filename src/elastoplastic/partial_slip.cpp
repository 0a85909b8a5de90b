// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/elastoplastic/partial_slip.hpp"

#include "brinell/elastoplastic/placement.hpp"
#include "brinell/foundation/error.hpp"
#include "foundation/sharing.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace brinell::elastoplastic
{

namespace
{

using contact::TangentialDrive;

const TangentialDrive::Axis& axis_of(const TangentialDrive& drive, std::size_t axis)
{
  return axis == 0 ? drive.x : drive.y;
}

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
      couples_(friction.coupling && pair_.couples())
{
  for (std::vector<double>* field :
       {&state_.heat, &state_.path, &bound_before_, &bound_, &pressure_before_, &pressure_added_, &residual_before_[0],
        &residual_before_[1], &displacement_before_[0], &displacement_before_[1], &change_[0], &change_[1], &slip_[0],
        &slip_[1], &state_.shear[0], &state_.shear[1], &state_.slip[0], &state_.slip[1]})
    field->assign(grid.size(), 0.0);
  if (couples_)
    state_.depth.assign(grid.size(), 0.0);
}

void PartialSlip::State::exchange(Archive& archive)
{
  archive("shear_x", shear[0]);
  archive("shear_y", shear[1]);
  archive("slip_x", slip[0]);
  archive("slip_y", slip[1]);
  archive("path", path);
  archive("heat", heat);
  if (!depth.empty())
    archive("depth", depth);
  archive("shift_x", shift[0]);
  archive("shift_y", shift[1]);
  archive("work", work);
  archive("limited_share", limited_share, 0.0, 1.0);
  archive("sticking", sticking);
  archive("pressed", pressed);
}

bool PartialSlip::is_forced(std::size_t axis) const
{
  return axis_of(start_.along, axis).kind == TangentialDrive::Kind::force;
}

std::array<double, 2> PartialSlip::direction(const TangentialDrive& along) const
{
  const std::array<double, 2> force = forces();
  std::array<double, 2> way{};
  for (std::size_t axis = 0; axis < 2; ++axis)
  {
    const auto& [kind, value] = axis_of(along, axis);
    way[axis] = value - (kind == TangentialDrive::Kind::force ? force : state_.shift)[axis];
    // A force of zero is met to rounding, which has no direction.
    if (kind == TangentialDrive::Kind::force && std::abs(way[axis]) <= 1e-9 * (std::abs(value) + std::abs(force[axis])))
      way[axis] = 0.0;
  }
  const double size = std::hypot(way[0], way[1]);
  return size > 0.0 ? std::array{way[0] / size, way[1] / size} : std::array{0.0, 0.0};
}

/// Displacement of the lower body less that of the upper one, but for that of the shears.
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

void PartialSlip::begin(Start start)
{
  before_ = state_;
  start_ = std::move(start);
  drive_ = start_.along;
  if (!is_forced(0))
    drive_.x.value -= state_.shift[0];
  if (!is_forced(1))
    drive_.y.value -= state_.shift[1];
  const Bodies& bodies = start_.bodies;
  pressure_before_.assign(bodies.pressure.begin(), bodies.pressure.end());
  has_bound_ = false;
  set_bound(pressure_before_);
  has_bound_ = false;
  bound_before_ = bound_;
  find_displacement(bodies, pressure_before_, displacement_before_);
  for (std::size_t i = 0; i < bound_.size(); ++i)
  {
    residual_before_[0][i] = bodies.lower_x[i] - bodies.upper_x[i];
    residual_before_[1][i] = bodies.lower_y[i] - bodies.upper_y[i];
  }
  pair_.apply({.shear_x = state_.shear[0], .shear_y = state_.shear[1]}, {.x = change_[0], .y = change_[1]}, scratch_);
  for (std::size_t axis = 0; axis < 2; ++axis)
    for (std::size_t i = 0; i < bound_.size(); ++i)
      displacement_before_[axis][i] += change_[axis][i];
  start_.bodies = {}; // does not last
}

/// Largest shear of a cell.
double PartialSlip::bound_at(std::size_t cell, double pressure) const
{
  return std::min(friction().coefficient * pressure, start_.limit[cell]);
}

/// Largest shear of each cell; held after the first time in an increment, if it shall be.
void PartialSlip::set_bound(std::span<const double> pressure)
{
  if (start_.holds_law && has_bound_)
    return;
  has_bound_ = true;
  for (std::size_t i = 0; i < bound_.size(); ++i)
    bound_[i] = bound_at(i, pressure[i]);
}

/// Whether the bound is enough for a force that is imposed.
bool PartialSlip::carries_drive() const
{
  double squares = 0.0;
  for (std::size_t axis = 0; axis < 2; ++axis)
    squares += is_forced(axis) ? std::pow(axis_of(drive_, axis).value, 2) : 0.0;
  constexpr double margin = 1e-8; // more than that of TangentialContact, which refuses what is left
  return squares == 0.0 || std::sqrt(squares) < (1.0 - margin) * sum(bound_) * pair_.grid().cell_area();
}

/// The tangential problem under the present bound.
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
  constexpr int most_iterations = 2000;
  contact::TangentialStep step;
  step.bound = bound_;
  step.before = {before_.shear[0], before_.shear[1]};
  step.change = {change_[0], change_[1]};
  step.drive = drive_;
  const contact::TangentialReport report =
      tangential_.solve(step, start_.tolerance, most_iterations, {state_.shear[0], state_.shear[1]},
                        {slip_[0], slip_[1]}, start_.wants_stop);
  shift_ = report.shift;
  return report.converged;
}

/// What the shears add to the gap. @returns the largest change [m]
double PartialSlip::lower_gap()
{
  if (!couples_)
    return 0.0;
  const std::vector<double> before = state_.depth;
  pair_.apply({.shear_x = state_.shear[0], .shear_y = state_.shear[1]}, {.z = state_.depth}, scratch_);
  return largest_difference(state_.depth, before);
}

Interface::Change PartialSlip::follow(const Bodies& bodies)
{
  set_bound(bodies.pressure);
  Change change;
  change.is_solved = solve(bodies);
  change.is_overloaded = !carries_drive();
  change.gap = lower_gap();
  return change;
}

/// The bound of the solution stays until there is another one: what slips is told by it.
Interface::Change PartialSlip::renew(const Bodies& bodies)
{
  has_bound_ = false;
  Change change;
  for (std::size_t i = 0; i < bound_.size(); ++i)
    change.shear = larger(change.shear, std::abs(bound_at(i, bodies.pressure[i]) - bound_[i]));
  return change;
}

/// The dual value of the tangential problem: -1/2 q C q + q (what the shears would have to displace without slip).
double PartialSlip::held_energy() const
{
  std::array<std::vector<double>, 2> along{std::vector<double>(bound_.size()), std::vector<double>(bound_.size())};
  pair_.apply({.shear_x = state_.shear[0], .shear_y = state_.shear[1]}, {.x = along[0], .y = along[1]});
  double total = 0.0;
  for (std::size_t axis = 0; axis < 2; ++axis)
  {
    const double imposed = is_forced(axis) ? 0.0 : axis_of(drive_, axis).value;
    for (std::size_t i = 0; i < bound_.size(); ++i)
      total += state_.shear[axis][i] * (displacement_before_[axis][i] + imposed - 0.5 * along[axis][i]);
  }
  return total * pair_.grid().cell_area();
}

void PartialSlip::add_to_gap(std::span<double> gap) const
{
  for (std::size_t i = 0; i < state_.depth.size(); ++i)
    gap[i] += state_.depth[i];
}

/// The slip of an increment is along the shear at its end, which is then at its bound: what a cell slips before it has reached
/// the bound is nothing. The bound changes with the pressure; its mean over the increment is of second order.
void PartialSlip::settle(const Bodies& bodies)
{
  const bool has_moved = bodies.lower_columns != 0.0 || bodies.upper_columns != 0.0;
  if (has_moved && sum(bound_before_) > 0.0)
    throw InternalError("PartialSlip: the contact stays where it is on both bodies");
  state_.sticking = state_.pressed = 0;
  int limited = 0;
  for (std::size_t i = 0; i < bound_.size(); ++i)
  {
    const double size = std::hypot(state_.shear[0][i], state_.shear[1][i]);
    const bool slips = size > 0.0 && size >= contact::slip_threshold * bound_[i];
    const bool is_pressed = bodies.pressure[i] > 0.0;
    state_.pressed += is_pressed ? 1 : 0;
    state_.sticking += is_pressed && !slips ? 1 : 0;
    limited += slips && friction().coefficient * bodies.pressure[i] > start_.limit[i] ? 1 : 0;
    if (!slips)
      continue;
    const double along = (slip_[0][i] * state_.shear[0][i] + slip_[1][i] * state_.shear[1][i]) / size;
    state_.heat[i] += 0.5 * (bound_before_[i] + bound_[i]) * along;
    state_.path[i] += std::hypot(slip_[0][i], slip_[1][i]);
    for (std::size_t axis = 0; axis < 2; ++axis)
      state_.slip[axis][i] += slip_[axis][i];
  }
  state_.limited_share = state_.pressed > 0 ? static_cast<double>(limited) / state_.pressed : 0.0;
  const std::array<double, 2> force = forces();
  for (std::size_t axis = 0; axis < 2; ++axis)
  {
    state_.shift[axis] = is_forced(axis) ? before_.shift[axis] + shift_[axis] : axis_of(start_.along, axis).value;
    const double before = sum(before_.shear[axis]) * pair_.grid().cell_area();
    state_.work += 0.5 * (before + force[axis]) * (state_.shift[axis] - before_.shift[axis]);
  }
}

std::array<double, 2> PartialSlip::forces() const
{
  const double area = pair_.grid().cell_area();
  return {sum(state_.shear[0]) * area, sum(state_.shear[1]) * area};
}

double PartialSlip::elastic_energy(std::span<const double> pressure) const
{
  std::array<std::vector<double>, 2> along{std::vector<double>(bound_.size()), std::vector<double>(bound_.size())};
  pair_.apply({.shear_x = state_.shear[0], .shear_y = state_.shear[1]}, {.x = along[0], .y = along[1]});
  const double together = state_.depth.empty() ? 0.0 : dot(pressure, state_.depth);
  const double alone = 0.5 * (dot(state_.shear[0], along[0]) + dot(state_.shear[1], along[1]));
  return (together + alone) * pair_.grid().cell_area();
}

double PartialSlip::heat() const
{
  return sum(state_.heat) * pair_.grid().cell_area();
}

void PartialSlip::embed(const Interface& smaller)
{
  const auto& other = dynamic_cast<const PartialSlip&>(smaller);
  const auto copy = [&](const std::vector<double>& from, std::vector<double>& to)
  { embed_field(other.pair_.grid(), from, pair_.grid(), to); };
  for (std::size_t axis = 0; axis < 2; ++axis)
  {
    copy(other.state_.shear[axis], state_.shear[axis]);
    copy(other.state_.slip[axis], state_.slip[axis]);
  }
  copy(other.state_.path, state_.path);
  copy(other.state_.heat, state_.heat);
  state_.shift = other.state_.shift;
  state_.work = other.state_.work;
  state_.limited_share = other.state_.limited_share;
  state_.sticking = other.state_.sticking;
  state_.pressed = other.state_.pressed;
}

void PartialSlip::recall(const Bodies& /*bodies*/)
{
  static_cast<void>(lower_gap());
}

} // namespace brinell::elastoplastic
