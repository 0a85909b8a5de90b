// SPDX-License-Identifier: BSD-3-Clause
#include "snapshot.hpp"

#include "brinell/elastoplastic/body_stress.hpp"
#include "grid_layout.hpp"

namespace brinell::simulation
{

namespace
{

/// Six fields of a field of deviators plus a third of a trace.
std::array<std::vector<double>, 6> six_fields(const std::vector<double>& deviators, const std::vector<double>& trace)
{
  const std::size_t cells = trace.size();
  std::array<std::vector<double>, 6> fields;
  for (std::vector<double>& field : fields)
    field.resize(cells);
  for (std::size_t cell = 0; cell < cells; ++cell)
  {
    const SymTensor tensor = to_tensor(deviator_at(deviators, cells, cell), trace[cell]);
    for (std::size_t c = 0; c < fields.size(); ++c)
      fields[c][cell] = tensor[c];
  }
  return fields;
}

} // namespace

BodySnapshot body_snapshot(const elastoplastic::CoupledContact& pair, const elastoplastic::Body& body,
                           const elastoplastic::Place& place, double origin, double contact_x)
{
  BodySnapshot s;
  s.grid = body.grid();
  s.x0 = origin;
  s.y0 = row_y(s.grid.surface, 0);
  s.contact_x = contact_x;
  if (!body.shared_half_space()) // rigid
    return s;
  s.equivalent_plastic_strain = body.state().equivalent;
  s.residual_displacement = body.state().residual_displacement;
  s.plastic_strain = six_fields(body.state().plastic_strain, std::vector<double>(s.grid.size()));
  const elastoplastic::BodyStress stress = elastoplastic::body_stress(pair, body, place);
  s.stress = six_fields(stress.deviator, stress.trace);
  return s;
}

} // namespace brinell::simulation
