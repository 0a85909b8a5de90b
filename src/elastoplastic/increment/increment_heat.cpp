// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/elastoplastic/increment.hpp"

#include <vector>

/// Heat in an increment: docs/theory/heat.md (heat-of-friction).
namespace brinell::elastoplastic
{

void CoupledContact::begin_heating(const Placement& placement, const Strategy& strategy)
{
  // In the transient regime the heat accumulates, and its motion follows the placement by columns, so that each flux begins where
  // the previous one ended. A steady flux moves with the exact velocity of the contact.
  std::array<double, 2> columns{};
  if (heating_->is_steady())
    columns = {strategy.moved[0] / grid().dx, strategy.moved[1] / grid().dx};
  else if (!strategy.is_put_down)
    columns = columns_moved(placement);
  heating_->begin({.grids = {lower().grid(), upper().grid()},
                   .places = {placement.lower, placement.upper},
                   .columns = columns,
                   .duration = strategy.duration,
                   .slides = interface_->knows_slip() ? strategy.slid > 0.0 : strategy.slides,
                   .pressure_before = pressure_,
                   .is_source_on = !strategy.returns});
  for (std::size_t side = 0; side < sides_.size() && strategy.duration > 0.0; ++side)
  {
    sides_[side].body.set_thermal_stress(heating_->stress(side));
    sides_[side].body.set_softening(heating_->softening(side));
  }
}

/// Computes the fluxes for pressure and slip of the trial.
/// @returns the largest change of the thermal displacement [m]
double CoupledContact::follow_heat(Heating::Sharing sharing)
{
  return heating_->follow(pressure_, interface_->heat_of_trial(slid_), sharing);
}

/// Plastic work of the trial in the bodies that it heats, per cell [J/m^3]; empty for others.
std::array<std::vector<double>, 2> CoupledContact::works_that_heat() const
{
  std::array<std::vector<double>, 2> works;
  for (std::size_t side = 0; side < sides_.size() && heating_; ++side)
    if (heating_->takes_work(side))
      works[side] = sides_[side].body.work_of_increment();
  return works;
}

/// Final heat of a converged increment, before anything is committed.
/// @throws GridError, ConvergenceError
void CoupledContact::find_heat_of_increment(const Strategy& strategy, const std::array<std::vector<double>, 2>& works)
{
  heating_->find_fluxes(pressure_, interface_->heat_of_increment(strategy.slid));
  heating_->require_room(pressure_, works, {lower().grid(), upper().grid()});
}

void CoupledContact::settle_heating(const std::array<std::vector<double>, 2>& works)
{
  for (std::size_t side = 0; side < sides_.size(); ++side)
    if (!works[side].empty())
      heating_->settle_work(side, works[side], sides_[side].body.grid());
  const std::array<std::vector<double>, 2> shears = interface_->mean_shears();
  heating_->settle(pressure_, {shears[0], shears[1]});
}

double CoupledContact::expansion_work() const
{
  if (!heating_)
    return 0.0;
  double on_strain = 0.0;
  for (const Side& side : sides_)
    on_strain += side.body.state().thermal_work;
  return heating_->work_on_tractions() + (twin_ == Twin::none ? 1.0 : 2.0) * on_strain;
}

/// Adds the thermal stress of a body; for a twin the fields of the solved body are turned by the view.
void CoupledContact::add_thermal_stress(std::size_t side, const BodyView& view, Stress& stress) const
{
  if (!heating_)
    return;
  std::vector<double> deviator(stress.deviator.size()), trace(stress.trace.size());
  heating_->layers(side, view.grid(), {.temperature = {}, .deviator = deviator, .trace = trace});
  view.turn(deviator, trace);
  for (std::size_t i = 0; i < deviator.size(); ++i)
    stress.deviator[i] += deviator[i];
  for (std::size_t i = 0; i < trace.size(); ++i)
    stress.trace[i] += trace[i];
}

/// Adds the thermal stress in some cells and sets their temperatures, layer by layer.
void CoupledContact::add_heat(std::size_t side, const BodyView& view, std::span<const std::size_t> cells,
                              std::vector<CellState>& states) const
{
  if (!heating_)
    return;
  const std::size_t size = view.grid().surface.size();
  std::vector<double> temperature(size), deviator(Deviator::size * size), trace(size);
  std::size_t known = view.grid().size();
  for (std::size_t n = 0; n < cells.size(); ++n)
  {
    const std::size_t cell = view.solved_cell(cells[n]), layer = cell / size, at = cell % size;
    if (layer != known)
      heating_->layer(side, view.grid(), layer, {temperature, deviator, trace});
    known = layer;
    states[n].stress.deviator = states[n].stress.deviator + view.turned(deviator_at(deviator, size, at));
    states[n].stress.trace += trace[at];
    states[n].temperature = view.material().temperature + temperature[at];
  }
}

std::vector<double> CoupledContact::temperature(std::size_t side, const BodyView& view) const
{
  if (!heating_ || view.material().elastic.is_rigid())
    return {};
  std::vector<double> result(view.grid().size()), none;
  heating_->layers(side, view.grid(), {.temperature = result, .deviator = {}, .trace = {}});
  view.turn(none, result);
  for (double& t : result)
    t += view.material().temperature;
  return result;
}

} // namespace brinell::elastoplastic
