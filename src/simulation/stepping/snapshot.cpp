// SPDX-License-Identifier: BSD-3-Clause
#include "snapshot.hpp"

#include "foundation/sharing.hpp"

#include <algorithm>
#include <utility>

namespace brinell::simulation
{

namespace
{

/// Full tensor fields from deviators (5 values per cell) and trace.
std::vector<std::vector<double>> six_fields(const std::vector<double>& deviators, const std::vector<double>& trace)
{
  const std::size_t cells = trace.size();
  std::vector<std::vector<double>> fields(std::tuple_size_v<TensorField>, std::vector<double>(cells));
  for_pieces(cells,
             [&](std::size_t first, std::size_t last)
             {
               for (std::size_t cell = first; cell < last; ++cell)
               {
                 const SymTensor tensor = to_tensor(deviator_at(deviators, cells, cell), trace[cell]);
                 for (std::size_t c = 0; c < fields.size(); ++c)
                   fields[c][cell] = tensor[c];
               }
             });
  return fields;
}

std::vector<StepFields::CellState> whole_tensors(const std::vector<elastoplastic::CoupledContact::CellState>& cells)
{
  std::vector<StepFields::CellState> states;
  states.reserve(cells.size());
  for (const auto& [stress, plastic_strain, equivalent, temperature] : cells)
    states.push_back(
        {to_tensor(stress.deviator, stress.trace), to_tensor(plastic_strain, 0.0), equivalent, temperature});
  return states;
}

} // namespace

BodySnapshot surface_snapshot(const elastoplastic::BodyView& body, double origin, double contact_x)
{
  BodySnapshot s;
  s.grid = body.grid();
  s.grid.surface = s.grid.surface.whole();
  s.x0 = origin;
  s.y0 = s.grid.surface.y(0);
  s.contact_x = contact_x;
  s.is_rigid = body.material().elastic.is_rigid();
  if (!s.is_rigid)
    s.residual_displacement = body.field(&elastoplastic::BodyState::residual_displacement);
  return s;
}

StepFields::Within fields_within(const elastoplastic::BodyView& body,
                                 const std::function<elastoplastic::CoupledContact::Stress()>& stress,
                                 std::function<std::vector<double>()> temperature, StatesOfCells states)
{
  using elastoplastic::BodyState;
  if (body.material().elastic.is_rigid())
    return {};
  std::function<LayeredFields()> temperature_field;
  if (temperature)
    temperature_field = [body, temperature = std::move(temperature)]
    { return LayeredFields(body.grid(), {temperature()}); };
  std::function<LayeredFields()> inclusion;
  if (body.solved().has_inclusions())
    inclusion = [body] { return body.solved().layered({body.solved().inclusion_numbers()}); };
  return {.equivalent_plastic_strain = [body] { return body.solved().layered({body.field(&BodyState::equivalent)}); },
          .temperature = std::move(temperature_field),
          .plastic_strain =
              [body]
          {
            const std::vector<double> strain = body.field(&BodyState::plastic_strain);
            return body.solved().layered(six_fields(strain, std::vector<double>(strain.size() / Deviator::size)));
          },
          .stress =
              [body, stress]
          {
            const elastoplastic::CoupledContact::Stress found = stress();
            return body.solved().layered(six_fields(found.deviator, found.trace));
          },
          .inclusion = std::move(inclusion),
          .cells = [states = std::move(states)](std::span<const std::size_t> cells)
          { return whole_tensors(states(cells)); }};
}

namespace
{

TensorField tensor(const LayeredFields& components)
{
  TensorField whole;
  for (std::size_t c = 0; c < whole.size(); ++c)
    whole[c] = components.whole(c);
  return whole;
}

} // namespace

Snapshot StepFields::whole() const
{
  Snapshot s = surfaces;
  for (const auto& [within, body] : {std::pair{&lower, &s.lower}, {&upper, &s.upper}})
  {
    if (within->equivalent_plastic_strain)
      body->equivalent_plastic_strain = within->equivalent_plastic_strain().whole();
    if (within->plastic_strain)
      body->plastic_strain = tensor(within->plastic_strain());
    if (within->stress)
      body->stress = tensor(within->stress());
    if (within->temperature)
      body->temperature = within->temperature().whole();
    if (within->inclusion)
      body->inclusion = within->inclusion().whole();
  }
  return s;
}

void set_heat(const elastoplastic::CoupledContact& pair, Snapshot& snapshot)
{
  const elastoplastic::Heating* heating = pair.heating();
  if (heating == nullptr)
    return;
  const auto copy = [](std::span<const double> field) { return std::vector<double>(field.begin(), field.end()); };
  for (std::size_t side = 0; side < 2; ++side)
  {
    snapshot.temperature[side] = copy(heating->temperature(side));
    snapshot.heat_flux[side] = copy(heating->flux(side));
  }
}

std::vector<double> surface_height(const elastoplastic::CoupledContact& pair, std::size_t side)
{
  const elastoplastic::BodyView& body = side == 0 ? pair.lower() : pair.upper();
  std::vector<double> depth = body.residual_displacement();
  const auto deepen = [&](std::span<const double> further)
  {
    for (std::size_t i = 0; i < further.size(); ++i)
      depth[i] += further[i];
  };
  deepen(body.texture());
  for (const elastoplastic::EffectField& field : elastoplastic::effect_fields)
    if (field.lowers_surface)
      deepen(elastoplastic::values_of(field, pair.effects(), side));
  for (double& d : depth)
    d = -d;
  return depth;
}

void set_effects(const elastoplastic::CoupledContact& pair, Snapshot& snapshot)
{
  const auto set = [&](std::size_t field, std::size_t side, elastoplastic::EffectFields& fields)
  {
    const auto values = elastoplastic::values_of(elastoplastic::effect_fields[field], pair.effects(), side);
    fields.of_effects[field].assign(values.begin(), values.end());
  };
  const std::array<BodySnapshot*, 2> bodies{&snapshot.lower, &snapshot.upper};
  for (std::size_t field = 0; field < elastoplastic::effect_fields.size(); ++field)
    if (elastoplastic::effect_fields[field].on == elastoplastic::EffectField::On::contact)
      set(field, 0, snapshot);
    else
      for (std::size_t side = 0; side < bodies.size(); ++side)
        set(field, side, *bodies[side]);
  for (std::size_t side = 0; side < bodies.size(); ++side)
    if (!(side == 0 ? pair.lower() : pair.upper()).texture().empty())
      bodies[side]->height = surface_height(pair, side);
}

void set_shear(const elastoplastic::CoupledContact& pair, Snapshot& snapshot)
{
  const auto copy = [](std::span<const double> field) { return std::vector<double>(field.begin(), field.end()); };
  if (pair.interface() != nullptr)
    for (std::size_t axis = 0; axis < 2; ++axis)
      snapshot.shear[axis] = copy(pair.interface()->shears()[axis]);
  const elastoplastic::PartialSlip* partial = pair.partial_slip();
  if (partial == nullptr)
    return;
  for (std::size_t axis = 0; axis < 2; ++axis)
    snapshot.slip[axis] = copy(partial->state().slip[axis]);
  snapshot.slip_path = copy(partial->state().path);
  snapshot.friction_heat = copy(partial->state().heat);
}

} // namespace brinell::simulation
