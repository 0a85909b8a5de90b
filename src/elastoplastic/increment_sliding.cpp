// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/elastoplastic/increment.hpp"
#include "foundation/sharing.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

/// What friction adds to an increment: docs/theory/elastoplastic.md (coulomb).
namespace brinell::elastoplastic
{

namespace
{

/// Adds to `limit` what a surface can carry: the smaller of both. Between the columns of the body it is interpolated; beyond its
/// ends it goes on as it is there.
void take_smaller(const SurfaceGrid& body, const std::vector<double>& strength, const Place& place,
                  const SurfaceGrid& contact, std::vector<double>& limit)
{
  const auto column_on = [&](int column)
  {
    if (body.is_periodic_x())
      return ((column % body.nx) + body.nx) % body.nx;
    return std::clamp(column, 0, body.nx - 1);
  };
  for (int j = 0; j < contact.ny; ++j)
    for (int i = 0; i < contact.nx; ++i)
    {
      const double here = strength[body.index(column_on(i + place.column), j)];
      const double next = strength[body.index(column_on(i + place.column + 1), j)];
      double& value = limit[contact.index(i, j)];
      value = std::min(value, (1.0 - place.fraction) * here + place.fraction * next);
    }
}

} // namespace

/// What each cell of the contact can carry at the start of an increment.
std::vector<double> CoupledContact::shear_limit(const Placement& placement) const
{
  const SlidingInterface& sliding = *sliding_;
  std::vector<double> limit(grid().size(),
                            sliding.friction().shear_limit.value_or(std::numeric_limits<double>::infinity()));
  if (sliding.friction().shear_limit)
    return limit;
  const double direction = sliding.direction();
  if (const BodyView body = lower(); body.material().is_plastic())
    take_smaller(body.grid().surface, body.shear_strength(direction), placement.lower, grid(), limit);
  if (const BodyView body = upper(); body.material().is_plastic())
    take_smaller(body.grid().surface, body.shear_strength(-direction), placement.upper, grid(), limit);
  return limit;
}

void CoupledContact::spread_shear(const Place& place, const SurfaceGrid& body, double sign,
                                  std::vector<double>& out) const
{
  spread_traction(grid(), sliding_->shear(), place, body, out);
  for (double& q : out)
    q *= sign;
}

/// Pressure and shear by turns, until the shear no longer moves the gap. Where it never does, one turn.
void CoupledContact::solve_sliding_contact(const contact::Drive& drive, const Strategy& strategy,
                                           IncrementReport& report)
{
  constexpr int most_turns = 60;
  const double tolerance = settings_.contact_tolerance * scales_.gap;
  const std::vector<double> without_shear = distance_;
  for (int turn = 1;; ++turn)
  {
    std::copy(without_shear.begin(), without_shear.end(), distance_.begin());
    if (sliding_->moves_gap())
      sliding_->add_to_gap(distance_);
    press(drive, strategy, report);
    if (strategy.watch_energy) // the shear is held
      return;
    const SlidingInterface::Change change = sliding_->follow(pressure_);
    if (change.gap <= tolerance)
      return;
    report.contact_converged = false;
    if (turn == most_turns || !std::isfinite(change.gap))
    {
      report.gap_error = change.gap;
      return;
    }
  }
}

/// With the shear held the increment has converged: the shear that belongs to the pressure takes its place.
/// @returns whether it is another one; then the increment goes on.
bool CoupledContact::renews_shear(IncrementReport& report)
{
  if (!sliding_)
    return false;
  const SlidingInterface::Change change = sliding_->follow(pressure_);
  double largest = 0.0;
  for (const double q : sliding_->shear())
    largest = std::max(largest, std::abs(q));
  report.converged =
      change.shear <= settings_.yield_tolerance * largest && change.gap <= settings_.contact_tolerance * scales_.gap;
  return !report.converged;
}

/// Of the given shear on the residual displacement of one body [J].
double CoupledContact::work_of_shear(const Side& side) const
{
  const std::span<const double> displacement = side.body.residual_displacement_x();
  return displacement.empty() ? 0.0 : dot(side.shear, displacement) * grid().cell_area();
}

/// Calls `use` with what the interface needs to know of both bodies.
template <typename Use>
void CoupledContact::with_bodies(const Placement& placement, const Use& use) const
{
  std::vector<double> lower_x(grid().size(), 0.0), upper_x(grid().size(), 0.0);
  const auto add = [&](const BodyView& body, const Place& place, std::vector<double>& out)
  {
    if (const std::vector<double> residual = body.residual_displacement_x(); !residual.empty())
      add_depth(body.grid().surface, residual, {}, place, grid(), out);
  };
  add(lower(), placement.lower, lower_x);
  add(upper(), placement.upper, upper_x);
  const auto moved = [](const Place& now, const Place& before)
  { return (now.column - before.column) + (now.fraction - before.fraction); };
  use({pressure_, lower_x, upper_x, moved(placement.lower, placement_.lower),
       moved(placement.upper, placement_.upper)});
}

void CoupledContact::end_sliding(const Placement& placement)
{
  with_bodies(placement, [&](const SlidingInterface::Bodies& bodies) { sliding_->settle(bodies); });
}

/// After the history has moved to larger grids.
void CoupledContact::recall_sliding()
{
  with_bodies(placement_, [&](const SlidingInterface::Bodies& bodies) { sliding_->find_displacements(bodies); });
}

} // namespace brinell::elastoplastic
