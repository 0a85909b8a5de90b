// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/elastoplastic/partial_slip.hpp"

#include "brinell/foundation/embedding.hpp"
#include "contact/carried_field.hpp"
#include "drive_axis.hpp"
#include "foundation/sharing.hpp"

#include <algorithm>
#include <cmath>

/// The end of an increment of stick and slip: history and results.
namespace brinell::elastoplastic
{

/// Whether the shear of the trial has reached its bound in a cell.
bool PartialSlip::slips_at(std::size_t cell) const
{
  const double size = std::hypot(state_.shear[0][cell], state_.shear[1][cell]);
  return size > 0.0 && size >= contact::slip_threshold * bound_[cell];
}

std::vector<double> PartialSlip::slip_length(double /*slid*/) const
{
  std::vector<double> length(bound_.size());
  for (std::size_t i = 0; i < length.size(); ++i)
    if (slips_at(i))
      length[i] = std::hypot(slip_[0][i], slip_[1][i]);
  const Pair parting = parting_slip();
  for (std::size_t i = 0; i < parting[0].size(); ++i)
    length[i] += std::hypot(parting[0][i], parting[1][i]);
  return length;
}

/// Heat per area of a cell that slips [J/m^2]. It slips only while its shear is at the bound, along the shear at the end of the
/// increment. The friction work uses the mean of the bounds at which slip begins and ends. A cell that sticks under a shear far
/// below its bound begins to slip when the falling bound meets that shear: near the trailing edge of a rolling contact the bound
/// may fall by most of its value in one step.
double PartialSlip::heat_at(std::size_t cell) const
{
  const double size = std::hypot(state_.shear[0][cell], state_.shear[1][cell]);
  const double along = (slip_[0][cell] * state_.shear[0][cell] + slip_[1][cell] * state_.shear[1][cell]) / size;
  return 0.5 * (bound_of_onset(cell) + bound_[cell]) * along;
}

/// Bound of the shear at which a cell that slips begins to do so [Pa].
double PartialSlip::bound_of_onset(std::size_t cell) const
{
  const double size_before = std::hypot(shear_before_[0][cell], shear_before_[1][cell]);
  return std::min(bound_before_[cell], std::max(size_before, bound_[cell]));
}

std::vector<double> PartialSlip::shear_of_onset() const
{
  std::vector<double> onset(bound_.size());
  for (std::size_t i = 0; i < onset.size(); ++i)
    onset[i] = bound_of_onset(i);
  return onset;
}

/// Pressure whose friction bound is the shear at which slip begins; where the surface limits the shear, a cell slips from the
/// beginning.
std::vector<double> PartialSlip::pressure_of_onset(std::span<const double> pressure) const
{
  std::vector<double> onset(bound_.size());
  for (std::size_t i = 0; i < onset.size(); ++i)
  {
    const double before = pressure_before_[i], coefficient = friction().coefficient;
    const bool is_limited = bound_before_[i] < coefficient * before || bound_[i] < coefficient * pressure[i];
    onset[i] = is_limited ? before : bound_of_onset(i) / coefficient;
  }
  return onset;
}

std::vector<double> PartialSlip::heat_of_trial(double /*slid*/) const
{
  std::vector<double> heat(bound_.size());
  for (std::size_t i = 0; i < heat.size(); ++i)
    if (slips_at(i))
      heat[i] = heat_at(i);
  return heat;
}

std::array<std::vector<double>, 2> PartialSlip::mean_shears() const
{
  std::array<std::vector<double>, 2> mean = state_.shear;
  for (std::size_t axis = 0; axis < 2; ++axis)
    for (std::size_t i = 0; i < bound_.size(); ++i)
      mean[axis][i] = 0.5 * (shear_before_[axis][i] + state_.shear[axis][i]);
  return mean;
}

void PartialSlip::settle(const Bodies& bodies)
{
  state_.sticking = state_.pressed = 0;
  int limited = 0;
  std::fill(heat_of_increment_.begin(), heat_of_increment_.end(), 0.0);
  double beyond_trapezoid = 0.0; // heat beyond the work of the mean shear on the slip, as a sum over cells [J/m^2]
  for (std::size_t i = 0; i < bound_.size(); ++i)
  {
    const bool slips = slips_at(i);
    const bool is_pressed = bodies.pressure[i] > 0.0;
    state_.pressed += is_pressed ? 1 : 0;
    state_.sticking += is_pressed && !slips ? 1 : 0;
    limited += slips && friction().coefficient * bodies.pressure[i] > start_.limit[i] ? 1 : 0;
    if (!slips)
      continue;
    const double heat = heat_at(i);
    add_heat(i, heat);
    beyond_trapezoid += heat;
    for (std::size_t axis = 0; axis < 2; ++axis)
      beyond_trapezoid -= 0.5 * (shear_before_[axis][i] + state_.shear[axis][i]) * slip_[axis][i];
    state_.path[i] += std::hypot(slip_[0][i], slip_[1][i]);
    for (std::size_t axis = 0; axis < 2; ++axis)
      state_.slip[axis][i] += slip_[axis][i];
  }
  state_.limited_share = state_.pressed > 0 ? static_cast<double>(limited) / state_.pressed : 0.0;
  add_parting_heat();
  add_work(carried_[0] == 0 && is_driven_ ? beyond_trapezoid * pair_.grid().cell_area() : 0.0);
}

void PartialSlip::add_heat(std::size_t cell, double heat)
{
  heat_of_increment_[cell] += heat;
  state_.heat[cell] += heat;
  state_.total_heat += heat * pair_.grid().cell_area();
}

/// Adds the work of the forces on the shifts, and of their moment on the spin.
///
/// In each cell the motion is the slip plus the change of the displacement of the surfaces. On the latter the trapezoidal rule is
/// exact as long as the bodies are elastic, in sum over the cells: the displacement is linear in the shear. A cell that begins
/// to slip does all of its slip under the shear at the bound, however, not under the mean shear of the increment: the work of the
/// trapezoidal rule is too small by the difference.
/// @param beyond_trapezoid  that difference [J]; 0 in rolling, where the forces change smoothly, and where nothing is driven
void PartialSlip::add_work(double beyond_trapezoid)
{
  const std::array<double, 2> force = forces();
  for (std::size_t axis = 0; axis < 2; ++axis)
  {
    state_.shift[axis] = is_forced(axis) ? before_.shift[axis] + shift_[axis] : axis_of(start_.along, axis).value;
    const double before = sum(before_.shear[axis]) * pair_.grid().cell_area();
    state_.work += 0.5 * (before + force[axis]) * (state_.shift[axis] - before_.shift[axis]);
  }
  state_.turned = start_.along.spin;
  state_.work += 0.5 * (moment_of(shear_before_) + moment_of(state_.shear)) * (state_.turned - before_.turned);
  state_.work += beyond_trapezoid;
}

/// Slip of points that leave the contact in the increment: they slip until their shear has vanished. Zero elsewhere;
/// empty if there are none.
PartialSlip::Pair PartialSlip::parting_slip() const
{
  const auto parts = [&](std::size_t i)
  { return bound_[i] == 0.0 && (shear_before_[0][i] != 0.0 || shear_before_[1][i] != 0.0); };
  const SurfaceGrid& grid = pair_.grid();
  bool any = false;
  for (std::size_t i = 0; i < bound_.size() && !any; ++i)
    any = parts(i);
  if (!any)
    return {};
  Pair change{state_.shear[0], state_.shear[1]}, displacement = change;
  for (std::size_t axis = 0; axis < 2; ++axis)
    for (std::size_t i = 0; i < bound_.size(); ++i)
      change[axis][i] -= shear_before_[axis][i];
  pair_.apply({.shear_x = change[0], .shear_y = change[1]}, {.x = displacement[0], .y = displacement[1]});
  Pair slip{std::vector<double>(bound_.size()), std::vector<double>(bound_.size())};
  for (int row = 0; row < grid.ny; ++row)
    for (int column = 0; column < grid.nx; ++column)
      if (const std::size_t i = grid.index(column, row); parts(i))
        for (std::size_t axis = 0; axis < 2; ++axis)
        {
          const double found = is_forced(axis) ? shift_[axis] : 0.0;
          slip[axis][i] = imposed(axis, column, row) + found - change_[axis][i] - displacement[axis][i];
        }
  return slip;
}

/// Adds slip and heat of points that leave the contact in the increment, under half of the shear that they had.
void PartialSlip::add_parting_heat()
{
  const Pair slip = parting_slip();
  for (std::size_t i = 0; i < slip[0].size(); ++i)
  {
    for (std::size_t axis = 0; axis < 2; ++axis)
      state_.slip[axis][i] += slip[axis][i];
    const double work = slip[0][i] * shear_before_[0][i] + slip[1][i] * shear_before_[1][i];
    state_.path[i] += std::hypot(slip[0][i], slip[1][i]);
    add_heat(i, std::max(0.0, 0.5 * work));
  }
}

/// Work of the shears per angle of the increment: the moment about z where the contact rests, about the place that `turned` names
/// where it rolls [N m].
double PartialSlip::moment_of(const Pair& shear) const
{
  const SurfaceGrid& grid = pair_.grid();
  double moment = 0.0;
  for (int row = 0; row < grid.ny; ++row)
    for (int column = 0; column < grid.nx; ++column)
    {
      const std::size_t i = grid.index(column, row);
      const contact::Along turned = contact::turned(grid, carried_, 1.0, column, row);
      moment += turned.x * shear[0][i] + turned.y * shear[1][i];
    }
  return moment * grid.cell_area();
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
  const double coupling = state_.depth.empty() ? 0.0 : dot(pressure, state_.depth);
  const double tangential = 0.5 * (dot(state_.shear[0], along[0]) + dot(state_.shear[1], along[1]));
  return (coupling + tangential) * pair_.grid().cell_area();
}

void PartialSlip::embed(const Interface& smaller)
{
  const auto& other = dynamic_cast<const PartialSlip&>(smaller);
  embed_state(other.pair_.grid(), other.state_, pair_.grid(), state_);
}

} // namespace brinell::elastoplastic
