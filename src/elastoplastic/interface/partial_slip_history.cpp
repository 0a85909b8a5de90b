// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/elastoplastic/partial_slip.hpp"

#include "contact/carried_field.hpp"
#include "foundation/sharing.hpp"
#include "slip_increment.hpp"
#include "stick_slip.hpp"

#include <algorithm>
#include <cmath>

/// The end of an increment of stick and slip: history and results.
namespace brinell::elastoplastic
{

namespace
{

using Pair = SlipIncrement::Pair;

/// An increment with the shear at its end.
struct Slipped
{
  const SlipIncrement& increment;
  const Pair& shear;

  [[nodiscard]] std::size_t cells() const { return shear[0].size(); }
  [[nodiscard]] double bound_before(std::size_t cell) const { return increment.bound.before()[cell]; }
  [[nodiscard]] double bound(std::size_t cell) const { return increment.bound.now()[cell]; }
};

/// Whether the shear has reached its bound in a cell.
bool slips_at(const Slipped& trial, std::size_t cell)
{
  const double size = std::hypot(trial.shear[0][cell], trial.shear[1][cell]);
  return size > 0.0 && size >= contact::slip_threshold * trial.bound(cell);
}

/// Bound of the shear at which a cell that slips begins to do so [Pa].
double bound_of_onset(const Slipped& trial, std::size_t cell)
{
  const Pair& before = trial.increment.shear_before;
  const double size_before = std::hypot(before[0][cell], before[1][cell]);
  return std::min(trial.bound_before(cell), std::max(size_before, trial.bound(cell)));
}

/// Heat per area of a cell that slips [J/m^2]. It slips only while its shear is at the bound, along the shear at the end of the
/// increment. The friction work uses the mean of the bounds at which slip begins and ends. A cell that sticks under a shear far
/// below its bound begins to slip when the falling bound meets that shear: near the trailing edge of a rolling contact the bound
/// may fall by most of its value in one step.
double heat_at(const Slipped& trial, std::size_t cell)
{
  const auto& [x, y] = trial.shear;
  const Pair& slip = trial.increment.slip;
  const double along = (slip[0][cell] * x[cell] + slip[1][cell] * y[cell]) / std::hypot(x[cell], y[cell]);
  return 0.5 * (bound_of_onset(trial, cell) + trial.bound(cell)) * along;
}

/// Slip of points that leave the contact in the increment: they slip until their shear has vanished. Zero elsewhere;
/// empty if there are none.
Pair parting_slip(const Slipped& trial, const halfspace::SurfaceCompliance& pair)
{
  const SlipIncrement& increment = trial.increment;
  const Pair& before = increment.shear_before;
  const auto parts = [&](std::size_t i)
  { return trial.bound(i) == 0.0 && (before[0][i] != 0.0 || before[1][i] != 0.0); };
  bool any = false;
  for (std::size_t i = 0; i < trial.cells() && !any; ++i)
    any = parts(i);
  if (!any)
    return {};
  Pair change = trial.shear;
  for (std::size_t axis = 0; axis < 2; ++axis)
    for (std::size_t i = 0; i < trial.cells(); ++i)
      change[axis][i] -= before[axis][i];
  const Pair displacement = displacement_by(pair, change);
  Pair slip{std::vector<double>(trial.cells()), std::vector<double>(trial.cells())};
  const SurfaceGrid& grid = increment.grid;
  for (int row = 0; row < grid.ny; ++row)
    for (int column = 0; column < grid.nx; ++column)
      if (const std::size_t i = grid.index(column, row); parts(i))
        for (std::size_t axis = 0; axis < 2; ++axis)
        {
          const double found = is_forced(increment.drive.along, axis) ? increment.shift[axis] : 0.0;
          slip[axis][i] = imposed_motion(grid, increment.drive, axis, column, row) + found - increment.change[axis][i] -
                          displacement[axis][i];
        }
  return slip;
}

/// Work of shears per angle of the increment: the moment about z where the contact rests, about the place that `turned` names
/// where it rolls [N m].
double moment_of(const Pair& shear, const SlipIncrement& increment)
{
  const SurfaceGrid& grid = increment.grid;
  double moment = 0.0;
  for (int row = 0; row < grid.ny; ++row)
    for (int column = 0; column < grid.nx; ++column)
    {
      const std::size_t i = grid.index(column, row);
      const contact::Along turned = contact::turned(grid, increment.drive.carried, 1.0, column, row);
      moment += turned.x * shear[0][i] + turned.y * shear[1][i];
    }
  return moment * grid.cell_area();
}

void add_heat(std::size_t cell, double heat, SlipIncrement& increment, SlipState& state)
{
  increment.heat[cell] += heat;
  state.heat[cell] += heat;
  state.total_heat += heat * increment.grid.cell_area();
}

/// Adds slip and heat of the cells that slip, and counts those that stick.
/// @returns the heat beyond the work of the mean shear on the slip [J]
double add_slip(std::span<const double> pressure, SlipIncrement& increment, SlipState& state)
{
  const Slipped trial{increment, state.shear};
  state.sticking = state.pressed = 0;
  int limited = 0;
  double beyond_trapezoid = 0.0; // as a sum over cells [J/m^2]
  for (std::size_t i = 0; i < trial.cells(); ++i)
  {
    const bool slips = slips_at(trial, i);
    const bool is_pressed = pressure[i] > 0.0;
    state.pressed += is_pressed ? 1 : 0;
    state.sticking += is_pressed && !slips ? 1 : 0;
    limited += slips && increment.bound.is_limited(i, pressure[i]) ? 1 : 0;
    if (!slips)
      continue;
    const double heat = heat_at(trial, i);
    add_heat(i, heat, increment, state);
    beyond_trapezoid += heat;
    for (std::size_t axis = 0; axis < 2; ++axis)
      beyond_trapezoid -= 0.5 * (increment.shear_before[axis][i] + state.shear[axis][i]) * increment.slip[axis][i];
    state.path[i] += std::hypot(increment.slip[0][i], increment.slip[1][i]);
    for (std::size_t axis = 0; axis < 2; ++axis)
      state.slip[axis][i] += increment.slip[axis][i];
  }
  state.limited_share = state.pressed > 0 ? static_cast<double>(limited) / state.pressed : 0.0;
  return beyond_trapezoid * increment.grid.cell_area();
}

/// Adds slip and heat of points that leave the contact in the increment, under half of the shear that they had.
void add_parting_slip(const Pair& slip, SlipIncrement& increment, SlipState& state)
{
  const Pair& before = increment.shear_before;
  for (std::size_t i = 0; i < slip[0].size(); ++i)
  {
    for (std::size_t axis = 0; axis < 2; ++axis)
      state.slip[axis][i] += slip[axis][i];
    const double work = slip[0][i] * before[0][i] + slip[1][i] * before[1][i];
    state.path[i] += std::hypot(slip[0][i], slip[1][i]);
    add_heat(i, std::max(0.0, 0.5 * work), increment, state);
  }
}

std::array<double, 2> forces_of(const Pair& shear, const SurfaceGrid& grid)
{
  return {sum(shear[0]) * grid.cell_area(), sum(shear[1]) * grid.cell_area()};
}

/// Adds the work of the forces on the shifts, and of their moment on the spin.
///
/// In each cell the motion is the slip plus the change of the displacement of the surfaces. On the latter the trapezoidal rule is
/// exact as long as the bodies are elastic, in sum over the cells: the displacement is linear in the shear. A cell that begins
/// to slip does all of its slip under the shear at the bound, however, not under the mean shear of the increment: the work of the
/// trapezoidal rule is too small by the difference.
/// @param beyond_trapezoid  that difference [J]; 0 in rolling, where the forces change smoothly, and where nothing is driven
void add_work(const SlipState& before, const SlipIncrement& increment, double beyond_trapezoid, SlipState& state)
{
  const contact::TangentialDrive& end = increment.drive.end;
  const std::array<double, 2> force_before = forces_of(before.shear, increment.grid);
  const std::array<double, 2> force = forces_of(state.shear, increment.grid);
  for (std::size_t axis = 0; axis < 2; ++axis)
  {
    state.shift[axis] = is_forced(end, axis) ? before.shift[axis] + increment.shift[axis] : axis_of(end, axis).value;
    state.work += 0.5 * (force_before[axis] + force[axis]) * (state.shift[axis] - before.shift[axis]);
  }
  state.turned = end.spin;
  state.work += 0.5 * (moment_of(increment.shear_before, increment) + moment_of(state.shear, increment)) *
                (state.turned - before.turned);
  state.work += beyond_trapezoid;
}

} // namespace

void PartialSlip::settle(const Bodies& bodies)
{
  SlipIncrement& now = *increment_;
  std::fill(now.heat.begin(), now.heat.end(), 0.0);
  const double beyond_trapezoid = add_slip(bodies.pressure, now, state_);
  add_parting_slip(parting_slip({now, state_.shear}, stick_slip_->pair()), now, state_);
  add_work(before_, now, now.drive.carried[0] == 0 && now.is_driven ? beyond_trapezoid : 0.0, state_);
}

std::vector<double> PartialSlip::slip_length(double /*slid*/) const
{
  const Slipped trial{*increment_, state_.shear};
  const auto& [x, y] = increment_->slip;
  std::vector<double> length(trial.cells());
  for (std::size_t i = 0; i < length.size(); ++i)
    if (slips_at(trial, i))
      length[i] = std::hypot(x[i], y[i]);
  const Pair parting = parting_slip(trial, stick_slip_->pair());
  for (std::size_t i = 0; i < parting[0].size(); ++i)
    length[i] += std::hypot(parting[0][i], parting[1][i]);
  return length;
}

std::span<const double> PartialSlip::pressure_before(std::span<const double> /*last*/) const
{
  return increment_->pressure_before;
}

/// The pressure of onset is that whose friction bound is the shear at which slip begins; where the surface limits the shear, a
/// cell slips from the beginning.
Interface::Onset PartialSlip::onset(std::span<const double> pressure) const
{
  const Slipped trial{*increment_, state_.shear};
  Onset onset{std::vector<double>(trial.cells()), std::vector<double>(trial.cells())};
  const double coefficient = friction().coefficient;
  for (std::size_t i = 0; i < trial.cells(); ++i)
  {
    const double before = increment_->pressure_before[i];
    const bool is_limited = trial.bound_before(i) < coefficient * before || trial.bound(i) < coefficient * pressure[i];
    onset.shear[i] = bound_of_onset(trial, i);
    onset.pressure[i] = is_limited ? before : onset.shear[i] / coefficient;
  }
  return onset;
}

std::vector<double> PartialSlip::heat_of_trial(double /*slid*/) const
{
  const Slipped trial{*increment_, state_.shear};
  std::vector<double> heat(trial.cells());
  for (std::size_t i = 0; i < heat.size(); ++i)
    if (slips_at(trial, i))
      heat[i] = heat_at(trial, i);
  return heat;
}

std::vector<double> PartialSlip::heat_of_increment(double /*slid*/) const
{
  return increment_->heat;
}

std::array<std::vector<double>, 2> PartialSlip::mean_shears() const
{
  Pair mean = state_.shear;
  for (std::size_t axis = 0; axis < 2; ++axis)
    for (std::size_t i = 0; i < mean[axis].size(); ++i)
      mean[axis][i] = 0.5 * (increment_->shear_before[axis][i] + state_.shear[axis][i]);
  return mean;
}

std::array<double, 2> PartialSlip::forces() const
{
  return forces_of(state_.shear, increment_->grid);
}

double PartialSlip::elastic_energy(std::span<const double> pressure) const
{
  const Pair along = displacement_by(stick_slip_->pair(), state_.shear);
  const double coupling = state_.depth.empty() ? 0.0 : dot(pressure, state_.depth);
  const double tangential = 0.5 * (dot(state_.shear[0], along[0]) + dot(state_.shear[1], along[1]));
  return (coupling + tangential) * increment_->grid.cell_area();
}

} // namespace brinell::elastoplastic
