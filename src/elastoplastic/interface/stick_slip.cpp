// SPDX-License-Identifier: BSD-3-Clause
#include "stick_slip.hpp"

#include "foundation/sharing.hpp"

#include <algorithm>
#include <cmath>

namespace brinell::elastoplastic
{

namespace
{

double largest_difference(std::span<const double> a, std::span<const double> b)
{
  double change = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
    change = larger(change, std::abs(a[i] - b[i]));
  return change;
}

} // namespace

StickSlip::Pair displacement_by(const halfspace::SurfaceCompliance& pair, const StickSlip::Pair& shear)
{
  StickSlip::Pair along{std::vector<double>(shear[0].size()), std::vector<double>(shear[1].size())};
  pair.apply({.shear_x = shear[0], .shear_y = shear[1]}, {.x = along[0], .y = along[1]});
  return along;
}

StickSlip::StickSlip(const SurfaceGrid& grid, const ElasticStack& lower, const ElasticStack& upper, bool couples,
                     double reference)
    : pair_(grid, lower, upper, reference), scratch_(pair_.make_scratch()), tangential_(pair_), entry_(pair_),
      couples_(couples && pair_.couples()), pressure_added_(grid.size(), 0.0)
{
}

/// Displacement along x and y, lower minus upper body, due to a pressure and the residual displacements, without that of the
/// shears.
void StickSlip::find_displacement(const Interface::Bodies& bodies, std::span<const double> pressure, Pair& out)
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

void StickSlip::begin(const Interface::Bodies& before, SlipIncrement& increment)
{
  Pair& displacement = increment.displacement_before;
  Pair& by_shear = increment.change; // as a buffer
  find_displacement(before, increment.pressure_before, displacement);
  for (std::size_t i = 0; i < displacement[0].size(); ++i)
  {
    increment.residual_before[0][i] = before.lower_x[i] - before.upper_x[i];
    increment.residual_before[1][i] = before.lower_y[i] - before.upper_y[i];
  }
  pair_.apply({.shear_x = increment.shear_before[0], .shear_y = increment.shear_before[1]},
              {.x = by_shear[0], .y = by_shear[1]}, scratch_);
  for (std::size_t axis = 0; axis < 2; ++axis)
    for (std::size_t i = 0; i < displacement[axis].size(); ++i)
      displacement[axis][i] += by_shear[axis][i];
  increment.entries = 0;
}

bool StickSlip::solve(const Interface::Bodies& bodies, const Pair& before, SlipIncrement& increment, Pair& shear)
{
  const SlipDrive& drive = increment.drive;
  constexpr int enough = 20; // updates of the entry, after which it can only alternate, with much wear
  if (increment.bound.follow(bodies.pressure) && ++increment.entries <= enough)
    entry_.find(drive.carried, increment.pressure_before, bodies.pressure, bodies.gap);
  const std::vector<double>& bound = increment.bound.now();
  for (std::size_t i = 0; i < bound.size(); ++i)
    pressure_added_[i] = bodies.pressure[i] - increment.pressure_before[i];
  find_displacement(bodies, pressure_added_, increment.change);
  for (std::size_t axis = 0; axis < 2; ++axis)
    for (std::size_t i = 0; i < bound.size(); ++i)
      increment.change[axis][i] -= increment.residual_before[axis][i];
  if (sum(bound) == 0.0)
  {
    for (std::vector<double>* field : {&shear[0], &shear[1], &increment.slip[0], &increment.slip[1]})
      std::fill(field->begin(), field->end(), 0.0);
    for (std::size_t axis = 0; axis < 2; ++axis)
      increment.shift[axis] = is_forced(drive.along, axis) ? 0.0 : axis_of(drive.along, axis).value;
    return increment.is_carried();
  }
  if (!increment.is_carried())
    return false;
  constexpr int max_iterations = 2000;
  contact::TangentialStep step;
  step.bound = bound;
  step.before = {before[0], before[1]};
  step.change = {increment.change[0], increment.change[1]};
  step.drive = drive.along;
  step.carried = drive.carried;
  step.entry = entry_.fields();
  const contact::TangentialReport report =
      tangential_.solve(step, increment.tolerance, max_iterations, {shear[0], shear[1]},
                        {increment.slip[0], increment.slip[1]}, increment.wants_stop);
  increment.shift = report.shift;
  return report.converged;
}

double StickSlip::find_depth(const Pair& shear, std::vector<double>& depth)
{
  if (!couples_)
    return 0.0;
  const std::vector<double> before = depth;
  pair_.apply({.shear_x = shear[0], .shear_y = shear[1]}, {.z = depth}, scratch_);
  return largest_difference(depth, before);
}

/// The dual value of the tangential problem: -1/2 q C q + q u, where u is the displacement that the shears would have to cause
/// for full stick.
double StickSlip::held_energy(const SlipIncrement& increment, const Pair& shear) const
{
  const Pair along = displacement_by(pair_, shear);
  double total = 0.0;
  const std::array<std::span<const double>, 3> entry = entry_.fields();
  const SurfaceGrid& grid = pair_.grid();
  for (std::size_t axis = 0; axis < 2; ++axis)
    for (int row = 0; row < grid.ny; ++row)
      for (int column = 0; column < grid.nx; ++column)
      {
        const std::size_t i = grid.index(column, row);
        const double full_stick =
            increment.displacement_before[axis][i] + imposed_motion(grid, increment.drive, axis, column, row);
        const double on_entry =
            entry.front().empty() ? 0.0 : entry[axis][i] * shear[axis][i] + entry[2][i] * shear[1 - axis][i];
        total += shear[axis][i] * (full_stick - 0.5 * (along[axis][i] + on_entry));
      }
  return total * pair_.grid().cell_area();
}

} // namespace brinell::elastoplastic
