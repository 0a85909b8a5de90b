// SPDX-License-Identifier: BSD-3-Clause
#include "contact_parts.hpp"
#include "foundation/sharing.hpp"

#include <algorithm>
#include <functional>

/// Heat and other effects between the surfaces in an increment: docs/theory/elastoplastic.md (wear), docs/theory/heat.md
/// (heat-of-friction).
namespace brinell::elastoplastic
{

namespace
{

/// Sums the compliances of the effects.
void find_compliance(ContactParts& c)
{
  const auto has = [](const std::unique_ptr<Effect>& effect) { return !effect->compliance().empty(); };
  if (std::none_of(c.effects.begin(), c.effects.end(), has))
    return;
  c.compliance_of_effects.assign(c.state.pressure.size(), 0.0);
  for (const std::unique_ptr<Effect>& effect : c.effects)
    for (std::size_t i = 0; i < effect->compliance().size(); ++i)
      c.compliance_of_effects[i] += effect->compliance()[i];
}

/// Heat that the effects release between the surfaces [W/m^2]; empty: none.
std::vector<double> heat_of_effects(const ContactParts& c)
{
  std::vector<double> sum;
  for (const std::unique_ptr<Effect>& effect : c.effects)
    if (const std::span<const double> heat = effect->heat(); !heat.empty())
    {
      sum.resize(heat.size());
      std::transform(sum.begin(), sum.end(), heat.begin(), sum.begin(), std::plus<>());
    }
  return sum;
}

bool heats(const ContactParts& c)
{
  return std::any_of(c.effects.begin(), c.effects.end(),
                     [](const std::unique_ptr<Effect>& effect) { return effect->heats(); });
}

} // namespace

Interaction interaction(const ContactParts& c)
{
  return {c.interface.get(), c.state.pressure, c.state.gap, c.slid, c.step};
}

// Not in the header: the type information of what is compiled for several processors stays there.
const SlidingInterface* CoupledContact::sliding() const
{
  return dynamic_cast<const SlidingInterface*>(interface());
}

const PartialSlip* CoupledContact::partial_slip() const
{
  return dynamic_cast<const PartialSlip*>(interface());
}

void begin_effects(ContactParts& c)
{
  const Interaction before = interaction(c);
  for (const std::unique_ptr<Effect>& effect : c.effects)
    effect->begin(before);
  find_compliance(c);
}

double evaluate_effects(ContactParts& c)
{
  const Interaction trial = interaction(c);
  double change = 0.0;
  for (const std::unique_ptr<Effect>& effect : c.effects)
    change = larger(change, effect->evaluate(trial));
  find_compliance(c);
  return change;
}

void soften_by_effects(ContactParts& c)
{
  for (const std::unique_ptr<Effect>& effect : c.effects)
    for (std::size_t side = 0; side < c.sides.size(); ++side)
      if (const std::span<const double> factors = effect->softening(side); !factors.empty())
        c.sides[side].body.set_softening(factors);
}

bool renews_softening(ContactParts& c, const Placement& placement, int turn)
{
  bool renewed = false;
  for (const std::unique_ptr<Effect>& effect : c.effects)
    renewed = effect->renews_softening(interaction(c), placement, turn) || renewed;
  return renewed;
}

double largest_depth_of_effects(const ContactParts& c)
{
  double depth = 0.0;
  for (const std::unique_ptr<Effect>& effect : c.effects)
    depth = std::max(depth, effect->largest_depth());
  return depth;
}

void begin_heating(ContactParts& c, const Task& task)
{
  // In the transient regime the heat accumulates, and its motion follows the placement by columns, so that each flux begins where
  // the previous one ended. A steady flux moves with the exact velocity of the contact.
  std::array<double, 2> columns{};
  if (c.heating->is_steady())
    columns = {task.motion.moved[0] / c.grid().dx, task.motion.moved[1] / c.grid().dx};
  else if (!task.motion.is_put_down)
    columns = columns_moved(c, task.placement);
  c.heating->begin({.grids = c.grids(),
                    .places = {task.placement.lower, task.placement.upper},
                    .columns = columns,
                    .duration = task.motion.duration,
                    .slides = c.interface->knows_slip() ? task.motion.slid > 0.0 : task.motion.slides,
                    .pressure_before = c.state.pressure,
                    .is_source_on = !task.motion.returns,
                    .has_effects = !task.motion.returns && heats(c)});
  for (std::size_t side = 0; side < c.sides.size() && task.motion.duration > 0.0; ++side)
  {
    c.sides[side].body.set_thermal_stress(c.heating->stress(side));
    c.sides[side].body.set_softening(c.heating->softening(side));
  }
}

double follow_heat(ContactParts& c, Heating::Sharing sharing)
{
  return c.heating->follow(c.state.pressure, c.interface->heat_of_trial(c.slid), sharing, heat_of_effects(c));
}

std::array<std::vector<double>, 2> works_that_heat(const ContactParts& c)
{
  std::array<std::vector<double>, 2> works;
  for (std::size_t side = 0; side < c.sides.size() && c.heating; ++side)
    if (c.heating->takes_work(side))
      works[side] = c.sides[side].body.work_of_increment();
  return works;
}

void find_heat_of_increment(ContactParts& c, const Motion& motion, const std::array<std::vector<double>, 2>& works)
{
  c.heating->find_fluxes(c.state.pressure, c.interface->heat_of_increment(motion.slid), heat_of_effects(c));
  c.heating->require_room(c.state.pressure, works, c.grids());
}

void settle_heating(ContactParts& c, const std::array<std::vector<double>, 2>& works)
{
  for (std::size_t side = 0; side < c.sides.size(); ++side)
    if (!works[side].empty())
      c.heating->settle_work(side, works[side], c.sides[side].body.grid());
  const std::array<std::vector<double>, 2> shears = c.interface->mean_shears();
  c.heating->settle(c.state.pressure, {shears[0], shears[1]});
}

double CoupledContact::expansion_work() const
{
  const ContactParts& c = *parts_;
  if (!c.heating)
    return 0.0;
  double on_strain = 0.0;
  for (const Side& side : c.sides)
    on_strain += side.body.state().thermal_work;
  return c.heating->work_on_tractions() + (c.twin == Twin::none ? 1.0 : 2.0) * on_strain;
}

void add_thermal_stress(const ContactParts& c, std::size_t side, CoupledContact::Stress& stress)
{
  if (!c.heating)
    return;
  const BodyView view = c.view(side);
  const Body& solved = view.solved();
  const std::size_t cells = view.grid().size();
  std::vector<double> deviator(Deviator::size * cells), trace(cells);
  c.heating->layers(side, view.grid(), {.temperature = {}, .deviator = deviator, .trace = trace});
  if (!solved.share().is_all())
  {
    deviator = solved.own_layers(deviator);
    trace = solved.own_layers(trace);
  }
  view.turn(deviator, trace);
  for (std::size_t i = 0; i < deviator.size(); ++i)
    stress.deviator[i] += deviator[i];
  for (std::size_t i = 0; i < trace.size(); ++i)
    stress.trace[i] += trace[i];
}

void add_heat(const ContactParts& c, std::size_t side, std::span<const std::size_t> cells,
              std::vector<CoupledContact::CellState>& states)
{
  if (!c.heating)
    return;
  const BodyView view = c.view(side);
  const std::size_t size = view.grid().surface.size();
  std::vector<double> temperature(size), deviator(Deviator::size * size), trace(size);
  std::size_t known = view.grid().size();
  for (std::size_t n = 0; n < cells.size(); ++n)
  {
    const std::size_t cell = view.solved_cell(cells[n]), layer = cell / size, at = cell % size;
    if (layer != known)
      c.heating->layer(side, view.grid(), layer, {temperature, deviator, trace});
    known = layer;
    states[n].stress.deviator = states[n].stress.deviator + view.turned(deviator_at(deviator, size, at));
    states[n].stress.trace += trace[at];
    states[n].temperature = view.material().temperature + temperature[at];
  }
}

std::vector<double> CoupledContact::temperature(std::size_t side) const
{
  const ContactParts& c = *parts_;
  const BodyView view = c.view(side);
  if (!c.heating || view.material().elastic.is_rigid())
    return {};
  std::vector<double> result(view.grid().size()), none;
  c.heating->layers(side, view.grid(), {.temperature = result, .deviator = {}, .trace = {}});
  view.turn(none, result);
  for (double& t : result)
    t += view.material().temperature;
  return result;
}

} // namespace brinell::elastoplastic
