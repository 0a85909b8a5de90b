// SPDX-License-Identifier: BSD-3-Clause
#include "coarser_tangential.hpp"

#include "carried_field.hpp"
#include "foundation/sharing.hpp"
#include "friction_discs.hpp"

#include <algorithm>

namespace brinell::contact
{

CoarserTangential::CoarserTangential(const halfspace::SurfaceCompliance& fine)
    : cells_(fine.grid()), compliance_(fine.on(cells_.coarse())), contact_(compliance_), bound_(cells_.coarse().size()),
      finer_(cells_.fine().size())
{
  for (Pair* pair : {&before_, &change_, &shear_, &guess_, &slip_})
    for (std::vector<double>& field : *pair)
      field.resize(cells_.coarse().size());
}

/// Averages the step on the larger cells. The shears `before` are carried along on the finer cells first, and the spin is
/// included in the change: carried by whole larger cells and turned about the middle of the coarser grid, both would differ. What
/// points move freely before they come into the contact is left out, since this is a mere guess.
void CoarserTangential::read(const TangentialStep& step)
{
  const SurfaceGrid& fine = cells_.fine();
  cells_.average(step.bound, bound_);
  for (std::size_t axis = 0; axis < 2; ++axis)
  {
    std::fill(finer_.begin(), finer_.end(), 0.0);
    if (!step.before[axis].empty())
      carry(fine, step.carried, step.before[axis], finer_);
    cells_.average(finer_, before_[axis]);
    for (int j = 0; j < fine.ny; ++j)
      for (int i = 0; i < fine.nx; ++i)
      {
        const std::size_t cell = fine.index(i, j);
        const Along by_spin = turned(fine, step.carried, step.drive.spin, i, j);
        finer_[cell] =
            (step.change[axis].empty() ? 0.0 : step.change[axis][cell]) - (axis == 0 ? by_spin.x : by_spin.y);
      }
    cells_.average(finer_, change_[axis]);
  }
}

bool CoarserTangential::guess(const TangentialStep& step, double tolerance, const AlongSurface& shear,
                              const std::function<bool()>& wants_stop)
{
  read(step);
  const auto force = [](const TangentialDrive::Axis& axis)
  { return axis.kind == TangentialDrive::Kind::force ? axis.value : 0.0; };
  const double carried = sum(bound_) * cells_.coarse().cell_area();
  constexpr double sliding = 0.999; // the larger cells may carry slightly less than the finer ones
  if (!(Along{force(step.drive.x), force(step.drive.y)}.size() < sliding * carried))
    return false;
  for (std::size_t axis = 0; axis < 2; ++axis)
  {
    cells_.average(shear[axis], guess_[axis]);
    shear_[axis] = guess_[axis];
  }
  TangentialStep coarser;
  coarser.bound = bound_;
  coarser.before = {before_[0], before_[1]};
  coarser.change = {change_[0], change_[1]};
  coarser.drive = {step.drive.x, step.drive.y, 0.0};
  constexpr double rougher = 100.0; // looser tolerance: the discretisation error of the larger cells is larger anyway
  constexpr int most_iterations = 200;
  if (!contact_
           .solve(coarser, rougher * tolerance, most_iterations, {shear_[0], shear_[1]}, {slip_[0], slip_[1]},
                  wants_stop)
           .converged)
    return false;
  interpolate(step.bound, shear);
  return true;
}

/// Interpolates the ratio of shears to bounds. Finer cells on a slipping larger cell slip, too; elsewhere the guess is changed by
/// the interpolated change of the larger cells, so that it retains its fine structure.
void CoarserTangential::interpolate(std::span<const double> bound, const AlongSurface& shear) const
{
  const SurfaceGrid& fine = cells_.fine();
  const auto share = [&](const Pair& of, std::size_t cell) {
    return (1.0 / bound_[cell]) * Along{of[0][cell], of[1][cell]};
  };
  for (int j = 0; j < fine.ny; ++j)
    for (int i = 0; i < fine.nx; ++i)
    {
      const std::size_t cell = fine.index(i, j);
      const std::array<CoarserCells::Neighbour, 4> around = cells_.around(i, j);
      const std::size_t own = around.front().cell;
      if (!(bound[cell] > 0.0 && bound_[own] > 0.0))
        continue;
      const bool slips = share(shear_, own).size() >= slip_threshold;
      Along value;
      double weight = 0.0;
      for (const CoarserCells::Neighbour& n : around)
        if (bound_[n.cell] > 0.0)
        {
          value += n.weight * (slips ? share(shear_, n.cell) : share(shear_, n.cell) - share(guess_, n.cell));
          weight += n.weight;
        }
      value = (bound[cell] / weight) * value;
      const Along q = slips ? (bound[cell] / value.size()) * value
                            : bounded(Along{shear[0][cell], shear[1][cell]} + value, bound[cell]);
      shear[0][cell] = q.x;
      shear[1][cell] = q.y;
    }
}

} // namespace brinell::contact
