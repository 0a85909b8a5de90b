// SPDX-License-Identifier: BSD-3-Clause
#include "snapshot.hpp"

#include "brinell/elastoplastic/body_stress.hpp"

namespace brinell::simulation
{

namespace
{

/// Six components of a deviator field plus a third of a trace.
std::array<std::vector<double>, 6> expand(const std::vector<double>& deviator, const std::vector<double>& trace)
{
  using D = Deviator;
  const std::size_t n = trace.size();
  const auto component = [&](int c, std::size_t i) { return deviator[static_cast<std::size_t>(c) * n + i]; };
  std::array<std::vector<double>, 6> out;
  for (auto& field : out)
    field.resize(n);
  for (std::size_t i = 0; i < n; ++i)
  {
    const double mean = trace[i] / 3.0;
    out[0][i] = component(D::xx, i) + mean;
    out[1][i] = component(D::yy, i) + mean;
    out[2][i] = mean - component(D::xx, i) - component(D::yy, i);
    out[3][i] = component(D::yz, i);
    out[4][i] = component(D::xz, i);
    out[5][i] = component(D::xy, i);
  }
  return out;
}

} // namespace

BodySnapshot body_snapshot(const elastoplastic::CoupledContact& pair, const elastoplastic::Body& body,
                           const elastoplastic::Place& place, double origin, double contact_x)
{
  BodySnapshot s;
  s.grid = body.grid();
  s.x0 = origin;
  s.y0 = -0.5 * (s.grid.surface.ny - 1) * s.grid.surface.dy;
  s.contact_x = contact_x;
  if (!body.shared_half_space()) // rigid
    return s;
  s.equivalent_plastic_strain = body.state().equivalent;
  s.residual_displacement = body.state().residual_displacement;
  s.plastic_strain = expand(body.state().plastic_strain, std::vector<double>(s.grid.size()));
  const elastoplastic::BodyStress stress = elastoplastic::body_stress(pair, body, place);
  s.stress = expand(stress.deviator, stress.trace);
  return s;
}

} // namespace brinell::simulation
