// SPDX-License-Identifier: BSD-3-Clause
#include "contact_parts.hpp"
#include "foundation/sharing.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

/// The contact of the surfaces of a trial: pressure, and in turns with it shear, heat and other effects.
namespace brinell::elastoplastic
{

namespace
{

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
  return share * tolerance * factor * constitutive::initial_yield_stress(material.law()) * 2.0 *
         std::min(grid.dx, grid.dy) / (std::numbers::pi * modulus);
}

/// Solves for the pressure of surfaces at the distance `distance`.
void press(ContactParts& c, const Task& task, IncrementReport& report)
{
  constexpr int max_iterations = 2000;
  const contact::Report contact =
      c.contact.solve(c.distance, task.drive, tolerance_of_gap(c), max_iterations, c.state.pressure, c.state.gap,
                      task.strategy.wants_stop, c.compliance_of_effects);
  report.contact_iterations += contact.iterations;
  report.gap_error = std::max(contact.gap_error, contact.penetration);
  report.contact_converged = contact.converged;
  report.approach = contact.approach;
}

/// Solves alternately for pressure and for shear, heat and other effects, until the gap no longer changes; one turn if they
/// do not affect the gap.
/// @param closing  whether the increment may end with this evaluation. If not, the effect of heat on the gap is not iterated to
///                 convergence but taken into account in the next evaluation.
void solve_frictional_contact(ContactParts& c, const Task& task, bool closing, IncrementReport& report)
{
  const Strategy& strategy = task.strategy;
  if (!strategy.watch_energy && !strategy.keeps_shear_limit)
    c.interface->set_limit(shear_limit(c, task.placement, c.driven_along));
  constexpr int max_turns = 60;
  const double tolerance = tolerance_of_gap(c);
  const bool exact = closing || !c.settings.shortcuts;
  const std::vector<double> without_shear = c.distance;
  for (int turn = 1;; ++turn)
  {
    std::copy(without_shear.begin(), without_shear.end(), c.distance.begin());
    c.interface->add_to_gap(c.distance);
    if (c.heating)
      c.heating->add_to_gap(c.distance);
    for (const std::unique_ptr<Effect>& effect : c.effects)
      effect->add_to_gap(c.distance);
    press(c, task, report);
    Interface::Change change = follow(c, task.placement);
    const double heat_change = c.heating && !strategy.watch_energy
                                   ? follow_heat(c, exact ? Heating::Sharing::fine : Heating::Sharing::rough)
                                   : 0.0;
    if (exact)
      change.gap = larger(change.gap, heat_change);
    if (!strategy.watch_energy)
      change.gap = larger(change.gap, evaluate_effects(c));
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

} // namespace

double tolerance_of_gap(const ContactParts& c)
{
  constexpr double rounding = 1e-12;
  const constitutive::Material &lower = c.sides.front().body.material(), &upper = c.sides.back().body.material();
  const double modulus = contact_modulus(lower.top(), upper.top());
  double usual = c.settings.tolerance_of_contact() * c.scales.gap;
  for (const constitutive::Material* material : {&lower, &upper})
    usual = std::min(usual, std::max(rounding * c.scales.gap,
                                     unnoticed_gap(*material, modulus, c.grid(), c.settings.yield_tolerance)));
  return c.interface ? c.interface->tolerance_of_gap(usual) : usual;
}

void solve_contact(ContactParts& c, const Task& task, bool closing, IncrementReport& report)
{
  std::copy(task.distance.begin(), task.distance.end(), c.distance.begin());
  add_depth_of(c, 0, task.placement.lower, c.distance);
  add_depth_of(c, 1, task.placement.upper, c.distance);
  if (c.interface)
    solve_frictional_contact(c, task, closing, report);
  else
    press(c, task, report);
  spread(c, task.placement);
}

void spread(ContactParts& c, const Placement& placement)
{
  for (Side& side : c.sides)
  {
    const Place& place = placement.*side.place;
    const SurfaceGrid& surface = side.body.grid().surface;
    side.leaves_grid = !spread_traction(c.grid(), c.state.pressure, place, surface, side.pressure);
    if (c.interface)
      spread_shear(c, place, surface, side.shear_sign, side.shear);
  }
}

bool bears_shear(const ContactParts& c)
{
  const auto acts = [](double shear) { return shear != 0.0; };
  return std::any_of(c.sides.begin(), c.sides.end(),
                     [&](const Side& side)
                     {
                       return std::any_of(side.shear[0].begin(), side.shear[0].end(), acts) ||
                              std::any_of(side.shear[1].begin(), side.shear[1].end(), acts);
                     });
}

bool renews_law(ContactParts& c, IncrementReport& report)
{
  if (!c.interface)
    return false;
  Interface::Change change = c.interface->renew({.pressure = c.state.pressure, .lower_x = {}, .upper_x = {}});
  if (c.heating)
    change.gap = larger(change.gap, follow_heat(c, Heating::Sharing::fine));
  change.gap = larger(change.gap, evaluate_effects(c));
  const contact::ConstAlongSurface shears = c.interface->shears();
  double largest = 0.0;
  for (const std::span<const double>& shear : shears)
    for (const double q : shear)
      largest = std::max(largest, std::abs(q));
  report.converged = change.shear <= c.settings.yield_tolerance * largest && change.gap <= tolerance_of_gap(c);
  return !report.converged;
}

} // namespace brinell::elastoplastic
