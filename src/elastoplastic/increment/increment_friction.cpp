// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/elastoplastic/increment.hpp"
#include "foundation/sharing.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

/// Friction in an increment: docs/theory/elastoplastic.md (coulomb).
namespace brinell::elastoplastic
{

namespace
{

/// Reduces `limit` to the shear strength of a surface where this is smaller. The strength is interpolated linearly between the
/// columns of the body and continued as a constant beyond its ends.
void limit_to_strength(const SurfaceGrid& body, const std::vector<double>& strength, const Place& place,
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

/// Gap that the yield error of a body does not notice: where it alternates in sign from cell to cell, it changes the pressure by
/// pi E' gap/2d, here a quarter of the tolerance. In deep indents of soft metals it is far below the usual tolerance, which is
/// relative to the approach: docs/theory/elastoplastic.md (noise).
/// @returns infinity for a body that cannot yield
double unnoticed_gap(const constitutive::Material& material, double modulus, const SurfaceGrid& grid, double tolerance)
{
  constexpr double share = 0.25;
  if (!material.is_plastic())
    return std::numeric_limits<double>::infinity();
  double factor = material.yield_factor.empty() ? 1.0 : std::numeric_limits<double>::infinity();
  for (const double z : material.yield_factor.depth())
    factor = std::min(factor, material.yield_factor.at(z, 1.0));
  return share * tolerance * factor * constitutive::initial_yield_stress(*material.hardening) * 2.0 *
         std::min(grid.dx, grid.dy) / (std::numbers::pi * modulus);
}

} // namespace

const SlidingInterface* CoupledContact::sliding() const
{
  return dynamic_cast<const SlidingInterface*>(interface_.get());
}

const PartialSlip* CoupledContact::partial_slip() const
{
  return dynamic_cast<const PartialSlip*>(interface_.get());
}

/// Largest shear that each cell of the contact can carry, the given limit or the strength of the softer surface with
/// the hardening of the present trial if that is less, for a direction of the shear on the lower body [Pa].
std::vector<double> CoupledContact::shear_limit(const Placement& placement,
                                                const std::array<double, 2>& direction) const
{
  constexpr double none = std::numeric_limits<double>::infinity();
  std::vector<double> limit(grid().size(), interface_->friction().shear_limit.value_or(none));
  const auto& [x, y] = direction;
  if (const BodyView body = lower(); body.material().is_plastic())
    limit_to_strength(body.grid().surface, body.shear_strength(x, y), placement.lower, grid(), limit);
  if (const BodyView body = upper(); body.material().is_plastic())
    limit_to_strength(body.grid().surface, body.shear_strength(-x, -y), placement.upper, grid(), limit);
  return limit;
}

void CoupledContact::spread_shear(const Place& place, const SurfaceGrid& body, double sign,
                                  std::array<std::vector<double>, 2>& out) const
{
  const contact::ConstAlongSurface shears = interface_->shears();
  for (std::size_t axis = 0; axis < 2; ++axis)
  {
    if (shears[axis].empty())
      continue;
    spread_traction(grid(), shears[axis], place, body, out[axis]);
    for (double& q : out[axis])
      q *= sign;
  }
}

/// Calls `use` with the data of both bodies that the interface needs. Thermal displacement counts as residual
/// displacement: it does not depend on the shear.
template <typename Use>
void CoupledContact::with_bodies(const Placement& placement, const Use& use) const
{
  const auto field = [&](std::vector<double> (BodyView::*of)() const, std::size_t axis)
  {
    std::array<std::vector<double>, 2> both{std::vector<double>(grid().size()), std::vector<double>(grid().size())};
    const auto add = [&](const BodyView& body, const Place& place, std::vector<double>& out)
    {
      if (const std::vector<double> residual = (body.*of)(); !residual.empty())
        add_depth(body.grid().surface, residual, {}, place, grid(), out);
    };
    add(lower(), placement.lower, both[0]);
    add(upper(), placement.upper, both[1]);
    for (std::size_t side = 0; side < 2 && heating_; ++side)
      heating_->add_along(side, axis, both[side]);
    return both;
  };
  const auto x = field(&BodyView::residual_displacement_x, 0);
  const auto y = field(&BodyView::residual_displacement_y, 1);
  const std::array<double, 2> moved = columns_moved(placement);
  use(Interface::Bodies{pressure_, x[0], x[1], y[0], y[1], moved[0], moved[1], gap_});
}

/// Columns by which the contact grid moves on the lower and the upper body from the present placement to another one.
std::array<double, 2> CoupledContact::columns_moved(const Placement& placement) const
{
  const auto moved = [](const Place& now, const Place& before)
  { return (now.column - before.column) + (now.fraction - before.fraction); };
  return {moved(placement.lower, placement_.lower), moved(placement.upper, placement_.upper)};
}

void CoupledContact::begin_friction(const Placement& placement, const Strategy& strategy,
                                    const contact::TangentialDrive& along)
{
  driven_along_ = interface_->direction(along);
  if (strategy.share_at_rest.value_or(1.0) < 0.0)
    for (double& part : driven_along_)
      part = -part;
  if (heating_ && partial_slip() != nullptr)
    heating_->recall({lower().grid(), upper().grid()}, {placement.lower, placement.upper}, columns_moved(placement));
  std::vector<double> limit = shear_limit(placement, driven_along_);
  with_bodies(placement,
              [&](const Interface::Bodies& bodies)
              {
                interface_->begin({.slides = strategy.slides,
                                   .along = along,
                                   .limit = std::move(limit),
                                   .bodies = bodies,
                                   .holds_law = strategy.watch_energy,
                                   .tolerance = settings_.tolerance_of_contact() * scales_.gap,
                                   .approach = scales_.gap,
                                   .wants_stop = strategy.wants_stop,
                                   .share_at_rest = strategy.share_at_rest});
              });
}

void CoupledContact::settle_friction(const Placement& placement)
{
  with_bodies(placement, [&](const Interface::Bodies& bodies) { interface_->settle(bodies); });
}

/// Recomputes the displacements of the interface after the history has moved to larger grids.
void CoupledContact::recall_friction()
{
  with_bodies(placement_, [&](const Interface::Bodies& bodies) { interface_->recall(bodies); });
}

/// Whether surfaces that may stick would move present pressure and shear over an end of the contact grid, so that their
/// displacements would be lost, or bring points from beyond the other end under the present pressure, whose gap is not known.
bool CoupledContact::carries_off(const Placement& placement) const
{
  const SurfaceGrid& g = grid();
  const int columns = placement.lower.column - placement_.lower.column;
  if (partial_slip() == nullptr || g.is_periodic_x() || std::abs(columns) >= g.nx)
    return false;
  const int ends = std::abs(columns);
  for (int j = 0; j < g.ny; ++j)
    for (int i = 0; i < ends; ++i)
      if (pressure_[g.index(i, j)] > 0.0 || pressure_[g.index(g.nx - 1 - i, j)] > 0.0)
        return true;
  return false;
}

/// Tolerance of the contact solver: largest gap under pressure, and largest overlap elsewhere [m].
double CoupledContact::tolerance_of_gap() const
{
  constexpr double rounding = 1e-12;
  const constitutive::Material &lower = sides_.front().body.material(), &upper = sides_.back().body.material();
  const double modulus = contact_modulus(lower.elastic, upper.elastic);
  double usual = settings_.tolerance_of_contact() * scales_.gap;
  for (const constitutive::Material* material : {&lower, &upper})
    usual = std::min(
        usual, std::max(rounding * scales_.gap, unnoticed_gap(*material, modulus, grid(), settings_.yield_tolerance)));
  return interface_ ? interface_->tolerance_of_gap(usual) : usual;
}

/// Solves alternately for pressure and for shear, heat and other effects, until the gap no longer changes; one turn if they
/// do not affect the gap.
/// @param closing  whether the increment may end with this evaluation. If not, the effect of heat on the gap is not iterated to
///                 convergence but taken into account in the next evaluation.
void CoupledContact::solve_frictional_contact(const contact::Drive& drive, const Placement& placement,
                                              const Strategy& strategy, bool closing, IncrementReport& report)
{
  if (!strategy.watch_energy && !strategy.keeps_shear_limit)
    interface_->set_limit(shear_limit(placement, driven_along_));
  constexpr int max_turns = 60;
  const double tolerance = tolerance_of_gap();
  const bool exact = closing || !settings_.shortcuts;
  const std::vector<double> without_shear = distance_;
  for (int turn = 1;; ++turn)
  {
    std::copy(without_shear.begin(), without_shear.end(), distance_.begin());
    if (interface_->moves_gap())
      interface_->add_to_gap(distance_);
    if (heating_)
      heating_->add_to_gap(distance_);
    for (const std::unique_ptr<Effect>& effect : effects_)
      effect->add_to_gap(distance_);
    press(drive, strategy, report);
    Interface::Change change = follow(placement);
    const double heat_change = heating_ && !strategy.watch_energy
                                   ? follow_heat(exact ? Heating::Sharing::fine : Heating::Sharing::rough)
                                   : 0.0;
    if (exact)
      change.gap = larger(change.gap, heat_change);
    if (!strategy.watch_energy)
      change.gap = larger(change.gap, evaluate_effects());
    report.overloaded = change.is_overloaded;
    report.contact_converged = report.contact_converged && change.is_solved && heat_change <= tolerance;
    if (change.gap <= tolerance)
      return;
    report.contact_converged = false;
    if (turn == max_turns || !std::isfinite(change.gap))
    {
      report.gap_error = change.gap;
      return;
    }
  }
}

/// Computes the shear for the pressure of the trial.
Interface::Change CoupledContact::follow(const Placement& placement)
{
  if (!interface_->follows_displacement())
    return interface_->follow({.pressure = pressure_, .lower_x = {}, .upper_x = {}});
  Interface::Change change;
  with_bodies(placement, [&](const Interface::Bodies& bodies) { change = interface_->follow(bodies); });
  return change;
}

/// After convergence with the law of friction held: updates bound, heat and other effects to the present pressure.
/// @returns whether they changed by more than the tolerances; the iteration then continues.
bool CoupledContact::renews_law(IncrementReport& report)
{
  if (!interface_)
    return false;
  Interface::Change change = interface_->renew({.pressure = pressure_, .lower_x = {}, .upper_x = {}});
  if (heating_)
    change.gap = larger(change.gap, follow_heat(Heating::Sharing::fine));
  change.gap = larger(change.gap, evaluate_effects());
  const contact::ConstAlongSurface shears = interface_->shears();
  double largest = 0.0;
  for (const std::span<const double>& shear : shears)
    for (const double q : shear)
      largest = std::max(largest, std::abs(q));
  report.converged = change.shear <= settings_.yield_tolerance * largest && change.gap <= tolerance_of_gap();
  return !report.converged;
}

/// Work of the shear on the residual displacement of one body [J].
double CoupledContact::work_of_shear(const Side& side) const
{
  double work = 0.0;
  for (const auto& [shear, displacement] :
       {std::pair{std::span<const double>(side.shear[0]), side.body.residual_displacement(1)},
        {std::span<const double>(side.shear[1]), side.body.residual_displacement(2)}})
    if (!displacement.empty() && !shear.empty())
      work += dot(shear, displacement) * grid().cell_area();
  return work;
}

} // namespace brinell::elastoplastic
